"""Two solids bonded end to end: an impact in which both yield, and errors of waves that cross the face.

usage: bonded-1d.py study.h5 OUT.png     (profiles.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

STYLES = {"godunov": ("tab:gray", "Godunov"), "linear": ("tab:blue", "linear, graded"), "parabolic": ("tab:red", "parabolic")}


def column(table, name):
    data = table[name]
    return data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:]


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        errors = {name: column(file["errors"], name) for name in file["errors"]}
    figure, axes = plt.subplots(1, 4, figsize=(17, 4), constrained_layout=True)
    with h5py.File(pathlib.Path(source).parent / "profiles.h5", "r") as file:
        shown = [("velocity [m/s]", lambda g, p: g[p + "velocity_x"][:]),
                 ("s11 [GPa]", lambda g, p: (g[p + "sxx"][:] - g[p + "pressure"][:]) / 1e9)]
        for axis, (name, value) in zip(axes, shown):
            for scheme, (colour, label) in STYLES.items():
                group = file[scheme]
                x = group["x"][:]
                if scheme == "godunov":
                    axis.plot(x, value(group, "reference_"), "k--", lw=0.9, label="exact", zorder=5)
                axis.plot(x, value(group, ""), color=colour, lw=1, label=label)
            axis.set_xlabel("x [m]", fontsize=8)
            axis.set_title(f"steel at 300 m/s on aluminium: {name}", fontsize=9)
    for axis, (group, variable) in zip(axes[2:], (("P", "right_velocity_x"), ("S, pre-stress", "contact_velocity_y"))):
        for scheme in sorted(set(errors["scheme"])):
            rows = ((errors["scheme"] == scheme) & (errors["variable"] == variable) & (errors["group"] == group)
                    & (errors["law"] == "steel-aluminium"))
            axis.loglog(errors["h"][rows], errors["l1"][rows], "o-", ms=4, lw=1, label=scheme)
        axis.set_xlabel("cell width [m]", fontsize=8)
        axis.set_title(f"{group}: L1 error of {variable.replace('_', ' ')}", fontsize=9)
        axis.grid(True, which="both", lw=0.3)
    for axis in axes:
        axis.legend(fontsize=7)
    figure.savefig(out, dpi=150)


main()
