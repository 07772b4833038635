"""Error of shock tubes at three angles to the grid, by scheme.

usage: shock-angle.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STYLE = {"godunov": ("tab:gray", "s"), "linear": ("tab:blue", "o"), "parabolic": ("tab:red", "D"), "muscl-hllc": ("tab:green", "P")}


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = file["errors"]
        problem, angle, scheme = (table[k].asstr()[:] for k in ("problem", "angle", "scheme"))
        cells, error = table["cells"][:], table["density_l1"][:]
    problems, angles = list(dict.fromkeys(problem)), list(dict.fromkeys(angle))
    figure, axes = plt.subplots(1, len(problems), figsize=(11, 4.5), constrained_layout=True)
    for axis, p in zip(axes, problems):
        for s, (colour, marker) in STYLE.items():
            for n, style in ((100, ":"), (200, "-")):
                y = [error[(problem == p) & (angle == a) & (scheme == s) & (cells == n)][0] for a in angles]
                axis.semilogy(np.arange(len(angles)), y, marker + style, color=colour, label=f"{s}, {n} cells")
        axis.set_xticks(np.arange(len(angles)), angles)
        axis.set_xlabel("angle between the shock's normal and x")
        axis.set_ylabel("L1 error of density [kg/m^3]")
        axis.set_title(p)
        axis.legend(fontsize=7)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
