"""Errors of readings of the paper's method of overset grids over those of what is used.

usage: fsi-literal.py STUDY.h5 OUT.png
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
        table = file["readings"]
        case, reading, quantity = (table[name].asstr()[:] for name in ("case", "reading", "quantity"))
        ratio, done, error = table["over_used"][:], table["done"][:], table["error"][:]
    used = reading[0]
    rows = np.flatnonzero(reading == used)
    labels = [f"{case[row]}: {quantity[row]} ({100 * abs(error[row]):.2g} %)" for row in rows]
    place = {(case[row], quantity[row]): y for y, row in enumerate(rows)}
    names = [name for name in dict.fromkeys(reading) if name != used]
    figure, axis = plt.subplots(figsize=(11, 5.5), constrained_layout=True)
    for number, name in enumerate(names):
        of_it = np.flatnonzero(reading == name)
        y = np.array([place[case[row], quantity[row]] for row in of_it]) + 0.11 * (number - 0.5 * (len(names) - 1))
        axis.plot(ratio[of_it], y, "os^vDP"[number % 6], label=name)
        for row, at in zip(of_it, y):
            if np.isnan(error[row]):
                axis.annotate(f"{name}: breaks down at {done[row]:.0%}", (0.99, at), va="center", ha="right", fontsize=8,
                              xycoords=axis.get_yaxis_transform())
    axis.axvline(1, color="k", lw=1)
    axis.set_xscale("log")
    axis.set_yticks(range(len(labels)), labels)
    axis.invert_yaxis()
    axis.grid(True, axis="x", lw=0.3)
    axis.set_xlabel("error over that of what is used, which is in brackets [1]")
    axis.legend(fontsize=8)
    figure.savefig(out, dpi=150)


main()
