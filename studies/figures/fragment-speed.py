"""Velocity of a cube beside a detonating sphere, and what the spherical field gives a plate in its place.

usage: fragment-speed.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = {name: file["speeds"][name][:] for name in file["speeds"]}
    figure, axes = plt.subplots(figsize=(7, 4.5), constrained_layout=True)
    for name, style in (("rigid wall", "k--"), ("p + rho w^2", "C0-"), ("rho w^2", "C0--")):
        axes.plot(table["time"], table[name], style, label=f"plate, {name}")
    axes.plot(table["time"], table["cube"], "C3o-", lw=2, label="cube, computed")
    axes.set_xlabel("t [us]")
    axes.set_ylabel("velocity [m/s]")
    axes.set_ylim(0, 3 * max(table["cube"]))
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
