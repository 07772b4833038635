"""Path of a rigid cylinder that a shock lifts off the floor of a channel, by scheme and grid.

usage: fsi-sphere.py study.h5 OUT.png     (histories.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    figure, axes = plt.subplots(1, 2, figsize=(12, 4), constrained_layout=True)
    with h5py.File(pathlib.Path(source).parent / "histories.h5", "r") as file:
        for name in sorted(file):
            path = {key: file[name][key][:] for key in file[name]}
            style = "--" if name.startswith("godunov") else "-"
            axes[0].plot(path["x"], path["y"], lw=1, ls=style, label=name)
            for key, colour in (("x", "C0"), ("y", "C1")):
                axes[1].plot(path["time"], path[key], lw=0.8, ls=style, color=colour)
    axes[0].plot([0.65], [0.14], "k+", ms=8, label="published, about")
    axes[0].set_xlabel("x [m]")
    axes[0].set_ylabel("y [m]")
    axes[0].legend(fontsize=7)
    axes[1].set_xlabel("t [s]")
    axes[1].set_ylabel("x (blue), y (orange) [m]")
    for axis in axes:
        axis.grid(True, lw=0.3)
    figure.savefig(out, dpi=150)


main()
