"""Tip of a clamped plate that swings freely, and of the panel in the shock tube.

usage: panel.py study.h5 OUT.png     (histories.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), constrained_layout=True)
    with h5py.File(pathlib.Path(source).parent / "histories.h5", "r") as file:
        for name in sorted(file):
            time, tip = file[name]["time"][:], file[name]["tip"][:]
            if name.startswith("panel"):
                axes[1].plot(1e3 * time, 1e3 * tip, lw=1, label=name)
            else:
                axes[0].plot(time, tip, lw=1, label=name)
    axes[0].set_xlabel("time, thicknesses over the bar's wave speed")
    axes[0].set_ylabel("tip, thicknesses")
    axes[1].axhspan(5.8, 6.6, color="0.85", label="peak as measured")
    axes[1].set_xlabel("time, ms")
    axes[1].set_ylabel("tip, mm")
    for axis in axes:
        axis.grid(True, lw=0.3)
        axis.legend(fontsize=7)
    figure.savefig(out, dpi=150)


main()
