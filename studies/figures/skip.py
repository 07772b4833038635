"""Time saved by each skip, and the error of what remains.

usage: skip.py STUDY.h5 OUT.png
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
        table = file["skips"]
        blast, skip = table["blast"].asstr()[:], table["skip"].asstr()[:]
        front, factor, error = table["front"][:], table["factor"][:], table["density_l1"][:]
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), constrained_layout=True)
    for column, b in enumerate(dict.fromkeys(blast)):
        for s in dict.fromkeys(skip):
            rows = (blast == b) & (skip == s)
            axes[0, column].plot(front[rows], factor[rows], "o-", label=s)
            axes[1, column].plot(front[rows], error[rows], "o-", label=s)
        axes[0, column].set_title(b)
        axes[0, column].set_yscale("log")
        axes[1, column].set_xlabel("radius of the front [m]")
    axes[0, 0].set_ylabel("CPU time of computing everything\nover that with the skip [1]")
    axes[1, 0].set_ylabel("mean density difference to a fine line [kg/m^3]")
    axes[0, 0].legend(fontsize=8)
    figure.suptitle(f"all skips together save a factor {np.max(factor):.1f} at best")
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
