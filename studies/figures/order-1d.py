"""Observed orders: error against cell size for the smooth cases, orders over laws and meshes, ablations.

usage: order-1d.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

CASES = ["acoustic-1d", "entropy-1d", "simple-wave-1d", "mms-1d"]
SCHEMES = {"godunov": ("tab:gray", "s"), "linear, graded": ("tab:blue", "o"), "muscl": ("tab:green", "P"),
           "parabolic, on": ("tab:red", "D")}


def read(group):
    """Columns of a table; NaN where a number is missing."""
    return {name: data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:] for name, data in group.items()}


def where(table, **wanted):
    chosen = np.ones(len(table["case"]), bool)
    for key, value in wanted.items():
        chosen &= table[key] == value
    return chosen


def plain_ticks(axis, cells):
    ticks = [n for n in (25, 50, 100, 200, 400, 800) if 0.8 * cells.min() <= n <= 1.2 * cells.max()]
    axis.set_xticks(ticks, [str(n) for n in ticks])
    axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def convergence(axis, errors, case):
    for scheme, (colour, marker) in SCHEMES.items():
        rows = where(errors, group="laws", case=case, law="ideal", scheme=scheme, variable="density")
        axis.loglog(1 / errors["h"][rows], errors["l1"][rows], marker + "-", color=colour, ms=3.5, lw=1, label=scheme)
    axis.set_title(f"{case}, ideal gas, uniform", fontsize=9)
    axis.set_xlabel("cells per length [1/m]", fontsize=8)
    plain_ticks(axis, 1 / errors["h"][where(errors, group="laws", case=case, law="ideal", variable="density")])
    axis.tick_params(labelsize=7, which="both")


def spread(axis, orders):
    """One point a row: L1 order of density, laws (filled) and meshes (open)."""
    rng = np.random.default_rng(0)
    for k, case in enumerate(CASES):
        for j, (scheme, (colour, marker)) in enumerate(SCHEMES.items()):
            for group, face in (("laws", colour), ("meshes", "none")):
                rows = where(orders, group=group, case=case, scheme=scheme, variable="density")
                y = orders["l1_order"][rows]
                x = k + 0.2 * (j - 1.5) + 0.05 * rng.uniform(-1, 1, y.size)
                axis.errorbar(x, y, orders["l1_interval"][rows], fmt=marker, color=colour, mfc=face, ms=4, lw=0.7)
    for order in (1, 2, 3):
        axis.axhline(order, color="black", lw=0.6, ls=":")
    axis.set_xticks(range(len(CASES)), CASES, fontsize=9)
    axis.set_ylim(0.6, 3.4)
    axis.set_ylabel("L1 order of density [1]", fontsize=8)
    axis.set_title("every law (filled) and mesh (open), 95 % intervals, schemes as above", fontsize=9)


def ablations(axis, errors):
    curves = [("conservative feet", dict(group="meshes", case="simple-wave-1d", mesh="alternating",
                                                           scheme="linear, off"), "tab:blue", "o-"),
              ("corrected (3.10), CFL 0.2", dict(group="feet", case="simple-wave-1d", mesh="alternating",
                                                 scheme="linear, corrected (3.10)"), "tab:cyan", "v-"),
              ("corrected (3.10), CFL 0.8: clipped", dict(group="feet", case="simple-wave-1d", mesh="alternating",
                                                          scheme="linear, corrected (3.10), CFL 0.8"), "tab:cyan",
               "v:"),
              ("printed (3.10), CFL 0.2", dict(group="feet", case="simple-wave-1d", mesh="alternating",
                                               scheme="linear, printed (3.10)"), "tab:red", "x--"),
              ("entropy wave, own foot", dict(group="laws", case="entropy-1d", law="ideal", scheme="linear, off"),
               "black", "s-"),
              ("entropy wave, one foot", dict(group="one foot", case="entropy-1d", scheme="linear, one foot"),
               "tab:orange", "s--")]
    for label, wanted, colour, style in curves:
        rows = where(errors, variable="density", **wanted)
        axis.loglog(1 / errors["h"][rows], errors["l1"][rows], style, color=colour, ms=3.5, lw=1, label=label)
    axis.set_xlabel("cells per length [1/m]", fontsize=8)
    axis.set_ylabel("L1 error of density, relative [1]", fontsize=8)
    plain_ticks(axis, np.array([80, 640]))
    axis.set_title("without each part (linear, off): simple wave on 1:2 mesh; entropy wave",
                   fontsize=9)
    axis.legend(fontsize=7)


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        orders, errors = read(file["orders"]), read(file["errors"])
    figure = plt.figure(figsize=(13, 7.5), constrained_layout=True)
    grid = figure.add_gridspec(2, 4)
    for k, case in enumerate(CASES):
        axis = figure.add_subplot(grid[0, k])
        convergence(axis, errors, case)
        if k == 0:
            axis.set_ylabel("L1 error of density, relative [1]", fontsize=8)
            axis.legend(fontsize=7)
    spread(figure.add_subplot(grid[1, :2]), orders)
    ablations(figure.add_subplot(grid[1, 2:]), errors)
    figure.suptitle("Godunov is first order, the linear predictor second on every law and mesh; the parabola third "
                    "on every smooth mesh", fontsize=11)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
