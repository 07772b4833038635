"""Motion of an elastic sphere under a pulse on three grids, and errors of a contact on a line.

usage: fsi-order.py study.h5 OUT.png     (histories.h5 lies beside study.h5)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def column(table, name):
    data = table[name]
    return data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:]


def main():
    source, out = sys.argv[1:]
    figure, axes = plt.subplots(1, 4, figsize=(17, 4), constrained_layout=True)
    with h5py.File(source, "r") as file:
        errors = {name: column(file["errors"], name) for name in file["errors"]}
    for axis, variable in zip(axes, ("interface_position", "interface_velocity")):
        for scheme in sorted(set(errors["scheme"])):
            rows = (errors["scheme"] == scheme) & (errors["variable"] == variable)
            axis.loglog(errors["h"][rows], errors["l1"][rows], "o-", ms=4, lw=1, label=scheme)
        axis.set_xlabel("cell width [m]", fontsize=8)
        axis.set_title(f"line: L1 error of {variable.replace('_', ' ')}", fontsize=9)
        axis.grid(True, which="both", lw=0.3)
    with h5py.File(pathlib.Path(source).parent / "histories.h5", "r") as file:
        for axis, quantity in zip(axes[2:], ("velocity", "momentum")):
            for scheme, colour in (("godunov", "tab:gray"), ("linear, graded", "tab:blue")):
                for cells, style in zip(sorted(file[scheme], key=int), (":", "--", "-")):
                    group = file[scheme][cells]
                    axis.plot(group["time"][:], group[quantity][:], style, color=colour, lw=1,
                              label=f"{scheme}, {cells} cells")
            axis.set_xlabel("time [s]", fontsize=8)
            axis.set_title(f"sphere: {quantity} along the pulse", fontsize=9)
    for axis in axes:
        axis.legend(fontsize=7)
    figure.savefig(out, dpi=150)


main()
