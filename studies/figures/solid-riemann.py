"""Shocks of solids: stress and velocity of every problem against the exact solution.

usage: solid-riemann.py study.h5 OUT.png     (profiles.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STYLES = {"godunov": ("tab:gray", "Godunov"), "linear": ("tab:blue", "linear, graded"), "parabolic": ("tab:red", "parabolic")}


def main():
    source, out = sys.argv[1:]
    with h5py.File(pathlib.Path(source).parent / "profiles.h5", "r") as file:
        problems = list(file)
        figure, axes = plt.subplots(len(problems), 3, figsize=(13, 2.7 * len(problems)), squeeze=False,
                                    constrained_layout=True)
        for row, problem in zip(axes, problems):
            for scheme, (colour, label) in STYLES.items():
                group = file[problem][scheme]
                x = group["x"][:]
                shown = [("s11 [GPa]", lambda g, p: (g[p + "sxx"][:] - g[p + "pressure"][:]) / 1e9),
                         ("velocity_x [m/s]", lambda g, p: g[p + "velocity_x"][:]),
                         ("velocity_y [m/s]", lambda g, p: g[p + "velocity_y"][:])]
                for axis, (name, value) in zip(row, shown):
                    if scheme == "godunov":
                        axis.plot(x, value(group, "reference_"), "k--", lw=0.9, label="exact", zorder=5)
                        axis.set_ylabel(name, fontsize=8)
                        axis.set_xlabel("x [m]", fontsize=8)
                        axis.tick_params(labelsize=7)
                    axis.plot(x, value(group, ""), color=colour, lw=1, label=label)
            row[0].set_title(problem, fontsize=9)
            row[0].legend(fontsize=7)
        figure.savefig(out, dpi=130)


if __name__ == "__main__":
    main()
