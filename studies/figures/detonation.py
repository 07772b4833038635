"""Errors of programmed burn against the number of cells a radius.

usage: detonation.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

SCHEMES = {"godunov": ("tab:gray", "s"), "linear": ("tab:blue", "o"), "parabolic": ("tab:red", "D")}
PANELS = {"l1_pressure": "pressure, mean", "l1_density": "density, mean", "l1_velocity": "velocity, mean",
          "core_pressure": "core's pressure"}


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = {name: data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:]
                 for name, data in file["errors"].items()}
    figure, axes = plt.subplots(1, 4, figsize=(13, 3.4), constrained_layout=True)
    for axis, (name, title) in zip(axes, PANELS.items()):
        value = np.abs(table[name] - 1) if name == "core_pressure" else table[name]
        for scheme, (colour, marker) in SCHEMES.items():
            for case, style, label in (("detonation-spherical", "-", scheme), ("detonation-3d", ":", f"{scheme}, 3D")):
                rows = (table["scheme"] == scheme) & (table["case"] == case)
                if rows.any():
                    axis.loglog(table["cells"][rows], value[rows], marker + style, color=colour, ms=4, lw=1, label=label,
                                mfc="none" if style == ":" else colour)
        axis.set_title(title, fontsize=9)
        axis.set_xlabel("cells a radius", fontsize=8)
        axis.set_xticks([32, 64, 128, 256, 512], ["32", "64", "128", "256", "512"])
        axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.tick_params(labelsize=7, which="both")
    axes[0].set_ylabel("error, relative", fontsize=8)
    axes[0].legend(fontsize=7)
    figure.savefig(out, dpi=150)


main()
