"""Error against cell size of solids, and the orders fitted to it.

usage: order-solid.py STUDY.h5 OUT.png
"""
import pathlib
import runpy
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

shared = runpy.run_path(str(pathlib.Path(__file__).with_name("order-2d.py")))
STYLE, read = shared["STYLE"], shared["read"]


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        orders, errors = read(file["orders"]), read(file["errors"])
    rows = list(dict.fromkeys(zip(errors["group"], errors["case"], errors["law"])))
    columns = min(4, len(rows))
    lines = -(-len(rows) // columns)
    figure, axes = plt.subplots(lines, columns, figsize=(4 * columns, 3.4 * lines), squeeze=False, constrained_layout=True)
    for axis, (group, case, law) in zip(axes.flat, rows):
        here = (errors["group"] == group) & (errors["case"] == case) & (errors["law"] == law)
        godunov = np.where(here & (errors["scheme"] == "godunov"))[0]
        variable = errors["variable"][godunov[np.nanargmax(errors["l1"][godunov])]]  # the one that errs most
        for scheme, (colour, marker) in STYLE.items():
            chosen = here & (errors["scheme"] == scheme) & (errors["variable"] == variable)
            fit = ((orders["group"] == group) & (orders["case"] == case) & (orders["law"] == law)
                   & (orders["scheme"] == scheme) & (orders["variable"] == variable))
            if chosen.any() and fit.any():
                axis.loglog(1 / errors["h"][chosen], errors["l1"][chosen], marker + "-", color=colour, ms=4, lw=1,
                            label=f"{scheme}: {orders['l1_order'][fit][0]:.2f}")
        axis.set_title(f"{case}, {group}, {law}", fontsize=9)
        axis.set_xlabel("cells per length [1]", fontsize=8)
        axis.set_ylabel(f"L1 error of {variable}, over the wave [1]", fontsize=8)
        axis.tick_params(labelsize=7, which="both")
        axis.legend(fontsize=7)
    for axis in axes.flat[len(rows):]:
        axis.axis("off")
    figure.savefig(out, dpi=130)


if __name__ == "__main__":
    main()
