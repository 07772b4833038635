"""Solids on cells that move with the material: profiles of the plates, and the radius at which the shell stops.

usage: solid-lagrange.py study.h5 OUT.png     (profiles.h5 lies beside study.h5)
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
        figure, (velocity, stress, stop) = plt.subplots(1, 3, figsize=(14, 4), constrained_layout=True)
        plates = file["plates"]
        for name, scale, axis, label in (("velocity", 1, velocity, "velocity [m/s]"),
                                         ("stress", 1e-9, stress, "-s11 [GPa]")):
            reference = plates["reference"]
            axis.plot(1e3 * reference["x"][:], scale * reference[name][:], "k--", lw=0.9, label="16000 cells", zorder=5)
            for scheme, (colour, title) in STYLES.items():
                axis.plot(1e3 * plates[scheme]["x"][:], scale * plates[scheme][name][:], color=colour, lw=1,
                          label=title + ", 1000")
            axis.set_xlabel("x [mm]")
            axis.set_ylabel(label)
        velocity.legend(fontsize=8)
        for scheme, (colour, title) in STYLES.items():
            group = file["shell"][scheme]
            stop.semilogx(group["cells"][:], 100 * group["stop_radius"][:], "o-", color=colour, label=title)
        stop.axhline(100 * file["shell"]["linear"]["exact"][0], color="k", ls="--", lw=0.9, label="exact, incompressible")
        stop.set_xlabel("cells")
        stop.set_ylabel("radius at the stop [cm]")
        stop.legend(fontsize=8)
        figure.savefig(out, dpi=130)


if __name__ == "__main__":
    main()
