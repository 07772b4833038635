"""Largest stable CFL number of each scheme on each problem.

usage: stability-1d.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STYLE = {"godunov": ("tab:gray", "s"), "linear, off": ("tab:cyan", "v"), "linear, binary": ("tab:purple", "^"),
         "linear, graded": ("tab:blue", "o"), "parabolic, off": ("tab:orange", "<"), "parabolic, on": ("tab:red", "D"),
         "muscl": ("tab:green", "P")}


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = file["limits"]
        scheme, problem = table["scheme"].asstr()[:], table["problem"].asstr()[:]
        limit = table["cfl_limit"][:]
        safe = all(table["stable_at_0.8"].asstr()[:] == "yes")
    problems = list(dict.fromkeys(problem))
    figure, axis = plt.subplots(figsize=(9, 4.8), constrained_layout=True)
    names = list(dict.fromkeys(scheme))
    for k, name in enumerate(names):
        colour, marker = STYLE.get(name, ("black", "x"))
        chosen = scheme == name
        shift = 0.1 * (k - (len(names) - 1) / 2)
        x = [problems.index(p) + shift for p in problem[chosen]]
        axis.plot(x, limit[chosen], marker, color=colour, ms=6, label=name)
    axis.axhline(1.0, color="black", lw=0.8, ls=":")
    axis.text(-0.48, 1.025, "one cell a step", fontsize=8)
    axis.axhline(0.8, color="black", lw=1.2)
    axis.text(-0.48, 0.81, "recommended", fontsize=8)
    axis.set_xticks(range(len(problems)), problems, fontsize=9)
    axis.set_xlim(-0.5, len(problems) - 0.5)
    axis.set_ylim(0.7, 1.65)
    axis.set_ylabel("largest stable CFL number [1]")
    verdict = "stable for all" if safe else "not stable for all"
    axis.set_title(f"The least limit of any scheme is {limit.min():.2f}: CFL 0.8 is {verdict}")
    axis.legend(fontsize=8, ncol=2, loc="upper left", bbox_to_anchor=(0.02, 1.0))
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
