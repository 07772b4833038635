"""Velocity and thickness of a cube beside a detonating sphere, by its distance from the charge.

usage: stand-off.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = {name: file["outcome"][name][:] for name in file["outcome"]}
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
    left.plot(table["stand_off"], table["velocity"], "C0o-")
    left.set_ylabel("velocity at 55 us [m/s]")
    right.plot(table["stand_off"], table["thickness"], "C3o-", label="at 55 us")
    right.plot(table["stand_off"], table["thickness_at_13_us"], "C1s--", label="at 13 us")
    right.axhline(0.5, color="0.5", lw=0.8, label="the paper: almost halved")
    right.set_ylabel("thickness over that at the start")
    right.legend()
    for axes in (left, right):
        axes.set_xlabel("distance of the near face from the charge [mm]")
        axes.grid(alpha=0.3)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
