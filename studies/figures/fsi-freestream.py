"""Largest deviation from a uniform stream that carries bodies along, by body, speed and gap.

usage: fsi-freestream.py STUDY.h5 OUT.png
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
        table = file["deviation"]
        body, speed, gap = table["body"].asstr()[:], table["speed"][:], table["gap"][:]
        values = {name: table[name][:] for name in ("gas", "solid", "surface")}
    labels = [f"{b}\n{s:g} m/s" + (f"\ngap {g:g}" if g > 0 else "") for b, s, g in zip(body, speed, gap)]
    figure, axis = plt.subplots(figsize=(10, 4), constrained_layout=True)
    x = np.arange(len(labels))
    for k, (name, value) in enumerate(values.items()):
        axis.bar(x + 0.27 * (k - 1), np.maximum(value, 1e-17), 0.25, label=name)
    axis.axhline(1e-12, color="k", ls="--", lw=1, label="claim")
    axis.set_yscale("log")
    axis.set_xticks(x, labels, fontsize=7)
    axis.set_ylabel("largest deviation, relative", fontsize=8)
    axis.legend(fontsize=8)
    figure.savefig(out, dpi=150)


main()
