"""Errors of a stressed body after a quarter turn, against the number of cells.

usage: objectivity.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STYLE = {"godunov": ("tab:gray", "s"), "linear": ("tab:blue", "o"), "parabolic": ("tab:red", "D")}


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = file["turn"]
        scheme, cells = table["scheme"].asstr()[:], table["cells"][:]
        columns = {name: np.abs(table[name][:]) for name in ("stress_error", "invariant_drift", "kinetic_energy_error")}
    figure, axes = plt.subplots(1, 3, figsize=(12, 4), constrained_layout=True)
    titles = ("largest stress error, over |S|", "largest change of S:S, relative", "error of the kinetic energy, relative")
    for axis, (name, values), title in zip(axes, columns.items(), titles):
        for s, (colour, marker) in STYLE.items():
            axis.loglog(cells[scheme == s], values[scheme == s], marker + "-", color=colour, ms=4, lw=1, label=s)
        axis.loglog(cells[:4], values[scheme == "linear"][0] * (cells[0] / cells[:4]) ** 2.0, "k:", lw=1, label="order 2")
        axis.set_title(title, fontsize=9)
        axis.set_xlabel("cells a side", fontsize=8)
        axis.tick_params(labelsize=7, which="both")
    axes[0].legend(fontsize=8)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
