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
        safe = table["stable_at_0.8"].asstr()[:] == "yes"
    curved = ["noise, cylinder", "noise, sphere"]
    problems = [p for p in dict.fromkeys(problem) if p not in curved] + [p for p in curved if p in problem]
    figure, axis = plt.subplots(figsize=(11, 5), constrained_layout=True)
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
    axis.set_xticks(range(len(problems)), [p.replace(", ", ",\n") for p in problems], fontsize=9)
    axis.set_xlim(-0.5, len(problems) - 0.5)
    axis.set_ylim(0.5, 1.65)
    axis.set_ylabel("largest stable CFL number [1]")
    bad = sorted(set(problem[~safe]))
    verdict = "CFL 0.8 is stable on all problems" if not bad else "CFL 0.8 is stable but for " + "; ".join(bad)
    axis.set_title(f"{verdict} (least limit {limit.min():.2f})")
    axis.legend(fontsize=8, ncol=2, loc="upper left", bbox_to_anchor=(0.02, 1.0))
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
