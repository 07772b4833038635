"""A copper rod that strikes a rigid wall: foot and length in time by grids, and published values.

usage: taylor-bar.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        history = {name: file["history"][name][:] for name in file["history"]}
        published = {name: file["published"][name][:] for name in file["published"]}
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8), constrained_layout=True)
    for axis, name, title in zip(axes, ("foot", "length"), ("foot's diameter over the rod's", "length over the first")):
        for cells in np.unique(history["cells"]):
            rows = history["cells"] == cells
            axis.plot(1e6 * history["time"][rows], history[name][rows], lw=1.2, label=f"{cells} cells a radius")
        given = published[name] > 0
        axis.plot(1e6 * published["time"][given], published[name][given], "k+", ms=9, label="published, converged")
        axis.set_xlabel("time [us]", fontsize=8)
        axis.set_title(title, fontsize=9)
        axis.legend(fontsize=7)
        axis.grid(True, lw=0.3)
    figure.savefig(out, dpi=150)


main()
