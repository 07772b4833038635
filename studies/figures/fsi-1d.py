"""Contact of gas and solid on a line: errors against yielding steel, and on a smooth motion of both sides.

usage: fsi-1d.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLOURS = {"godunov": "tab:gray", "linear": "tab:blue", "parabolic": "tab:red"}


def column(table, name):
    data = table[name]
    return data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:]


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        steel = {name: column(file["yielding"], name) for name in file["yielding"]}
        smooth = {name: column(file["errors"], name) for name in file["errors"]}
    figure, axes = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    for scheme, colour in COLOURS.items():
        rows = steel["scheme"] == scheme
        axes[0].loglog(steel["cells"][rows], np.abs(steel["pressure_error"][rows]), "o-", color=colour, ms=4, lw=1,
                       label=f"{scheme}, pressure")
        axes[0].loglog(steel["cells"][rows], np.abs(steel["velocity_error"][rows]), "s--", color=colour, ms=4, lw=1,
                       label=f"{scheme}, velocity")
    axes[0].axhline(1e-4, color="k", ls=":", lw=1)
    axes[0].set_xlabel("cells a side", fontsize=8)
    axes[0].set_title("products against yielding steel: contact, relative", fontsize=9)
    for axis, variable in zip(axes[1:], ("interface_velocity", "solid_sxx")):
        for scheme in sorted(set(smooth["scheme"])):
            rows = (smooth["scheme"] == scheme) & (smooth["variable"] == variable) & (smooth["mesh"] == "lagrangian")
            axis.loglog(smooth["h"][rows], smooth["l1"][rows], "o-", ms=4, lw=1, label=scheme)
        axis.set_xlabel("cell width [m]", fontsize=8)
        axis.set_title(f"smooth motion: L1 error of {variable.replace('_', ' ')}", fontsize=9)
    for axis in axes:
        axis.legend(fontsize=7)
        axis.grid(True, which="both", lw=0.3)
    figure.savefig(out, dpi=150)


main()
