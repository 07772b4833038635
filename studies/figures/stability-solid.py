"""Largest stable CFL number of solids by transverse term: predicted for Fourier modes beside measured on noise.

usage: stability-solid.py STUDY.h5 OUT.png
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
        mach = table["mach"][:]
        scheme, term = (table[k].asstr()[:] for k in ("scheme", "transverse"))
    figure, axis = plt.subplots(figsize=(9, 4.5), constrained_layout=True)
    x = np.arange(dims.size)
    axis.bar(x - 0.2, predicted, 0.4, label="predicted, Fourier modes", color="tab:blue")
    axis.bar(x + 0.2, measured, 0.4, label="measured, noise", color="tab:orange")
    axis.axhline(0.8, color="black", lw=1)
    axis.set_xticks(x, [f"{d:.0f}D {s}\n{t}, Mach {m:g}" for d, s, t, m in zip(dims, scheme, term, mach)], rotation=90, fontsize=7)
    axis.set_ylabel("largest stable CFL number, summed over the directions [1]", fontsize=8)
    axis.set_title("moving and pre-stressed steel; the line is what an elastic body is run with", fontsize=9)
    axis.legend(fontsize=8)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
