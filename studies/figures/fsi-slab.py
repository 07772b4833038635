"""Pressure at the contact and place of the front face of plates that a shock meets, against the exact waves.

usage: fsi-slab.py study.h5 OUT.png     (histories.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    figure, axes = plt.subplots(1, 3, figsize=(15, 4), constrained_layout=True)
    with h5py.File(pathlib.Path(source).parent / "histories.h5", "r") as file:
        for name in sorted(file):
            h = {key: file[name][key][:] for key in file[name]}
            last = h["exact_front"][-1]
            axes[0].plot(h["time"], h["pressure"] / h["exact_pressure"] - 1, lw=1, label=name)
            axes[1].plot(h["time"], (h["front"] - h["exact_front"]) / last, lw=1, label=name)
            axes[2].plot(h["time"], (h["momentum"] - h["impulse"]) / h["impulse"][-1], lw=1, label=name)
    titles = ("pressure at the contact over the exact one, less 1", "error of the front face over its whole way",
              "momentum less impulse over the whole impulse")
    for axis, title, limit in zip(axes, titles, (0.25, 0.03, 0.02)):
        axis.set_title(title, fontsize=9)
        axis.set_xlabel("time", fontsize=8)
        axis.set_ylim(-limit, limit)
        axis.axhline(0, color="k", lw=0.5)
        axis.grid(True, lw=0.3)
    axes[0].legend(fontsize=7)
    figure.savefig(out, dpi=150)


main()
