"""Error of the velocity against CPU time of solids, one panel a problem.

usage: work-precision-solid.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STYLE = {"godunov": ("tab:gray", "s"), "linear": ("tab:blue", "o"), "parabolic": ("tab:red", "D")}


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = file["curves"]
        problem, scheme = table["problem"].asstr()[:], table["scheme"].asstr()[:]
        error, cpu, spread = table["velocity_l1"][:], table["cpu"][:], table["spread"][:]
    problems = list(dict.fromkeys(problem))
    figure, axes = plt.subplots(2, 4, figsize=(15, 7), squeeze=False, constrained_layout=True)
    for axis, p in zip(axes.flat, problems):
        for s, (colour, marker) in STYLE.items():
            rows = (problem == p) & (scheme == s)
            axis.errorbar(cpu[rows], error[rows], xerr=cpu[rows] * spread[rows], fmt=marker + "-", color=colour, ms=4, lw=1, label=s)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_title(p, fontsize=9)
        axis.set_xlabel("CPU time [s]", fontsize=8)
        axis.tick_params(labelsize=7, which="both")
    for axis in axes.flat[len(problems):]:
        axis.axis("off")
    axes[0, 0].set_ylabel("L1 error of the velocity [m/s]", fontsize=8)
    axes[0, 0].legend(fontsize=7)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
