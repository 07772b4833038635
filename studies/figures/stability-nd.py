"""Largest stable CFL number by transverse term: predicted for Fourier modes beside measured on noise.

usage: stability-nd.py STUDY.h5 OUT.png
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
        table = file["limits"]
        dims, predicted, measured = table["dimensions"][:], table["predicted"][:], table["measured"][:]
        scheme, term, rule = (table[k].asstr()[:] for k in ("scheme", "transverse", "rule"))
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.5), sharey=True, constrained_layout=True)
    for axis, which in zip(axes, ("sum", "max")):
        rows = np.flatnonzero(rule == which)
        x = np.arange(rows.size)
        axis.bar(x - 0.2, predicted[rows], 0.4, label="predicted, Fourier modes", color="tab:blue")
        axis.bar(x + 0.2, measured[rows], 0.4, label="measured, noise", color="tab:orange")
        axis.axhline(0.8, color="black", lw=1)
        names = [f"{dims[r]:.0f}D {scheme[r]}\n{term[r]}" for r in rows]
        axis.set_xticks(x, names, rotation=90, fontsize=7)
        axis.set_title({"sum": "CFL number summed over the directions", "max": "of the fastest direction"}[which], fontsize=9)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("largest stable CFL number [1]")
    own = (term == "own cell") & (rule == "sum")
    figure.suptitle(f"each side's own transverse term, sum rule: stable to {measured[own].min():.2f}; the line is what is used")
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
