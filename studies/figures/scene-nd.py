"""Default figure of a scene in two or three dimensions: density and pressure through the domain, history.

usage: scene-nd.py RUN.h5 [RUN.h5 ...] OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

COLOURS = {"godunov": "tab:gray", "linear": "tab:blue", "parabolic": "tab:red", "muscl": "tab:green"}
STYLES = ("-", "--", ":", "-.")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def scaled(values, unit):
    """Values and label in a readable multiple of the SI unit."""
    steps = {"Pa": [(1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")], "s": [(1, "s"), (1e-3, "ms"), (1e-6, "us")],
             "m": [(1, "m"), (1e-2, "cm"), (1e-3, "mm")]}
    finite = np.abs(values[np.isfinite(values)])
    largest = finite.max() if finite.size else 0.0
    for factor, name in steps.get(unit, []):
        if largest >= factor:
            return values / factor, name
    return values, unit


def slices(state, field):
    """Planes to show: the whole plane, or in three dimensions z = const and y = const nearest to z = 0 and y = 0."""
    x, y = state["x"][:], state["y"][:]
    if "z" not in state:
        yield "x", x, "y", y, state[field][0], ""
        return
    z = state["z"][:]
    for name, nodes in (("z", z), ("y", y)):
        centres = (nodes[1:] + nodes[:-1]) / 2
        index = int(np.argmin(np.abs(centres)))
        where = f", {name} = {centres[index]:.3g} m"
        if name == "z":
            yield "x", x, "y", y, state[field][index], where
        else:
            yield "x", x, "z", z, state[field][:, index], where


def draw_slice(axis, state, field, plane):
    first, across, second, up, values, where = plane
    values = np.where(state_is_gas(values), values, np.nan)
    values, unit = scaled(values, text(state[field].attrs["units"]))
    # one unit for both axes: they are drawn to one scale
    both, length = scaled(np.concatenate([across, up]), "m")
    across, up = both[:across.size], both[across.size:]
    low, high = np.nanmin(values), np.nanmax(values)
    spread = low > 0 and high > 20 * low
    mesh = axis.pcolormesh(across, up, values, cmap="viridis" if field == "density" else "inferno",
                           norm=LogNorm(max(low, 1e-6 * high), high) if spread else None, rasterized=True)
    plt.colorbar(mesh, ax=axis, label=f"{field} [{unit}]")
    axis.set_aspect("equal")
    axis.set_facecolor("0.6")
    axis.set_xlabel(f"{first} [{length}]")
    axis.set_ylabel(f"{second} [{length}]")
    time, t_unit = scaled(np.array([state.attrs["time"]]), "s")
    axis.set_title(f"t = {time[0]:.4g} {t_unit}{where}", fontsize=9)


def state_is_gas(values):
    """Cells of solid blocks hold zeros."""
    return values != 0


def curves(run):
    """Pressures at the probes, or the largest; and shock radii where they were measured."""
    probes = run["history/probe"] if "probe" in run["history"] else {}
    pressures = {name: probes[name]["pressure"][:] for name in probes} or {"largest": run["history/max_pressure"][:]}
    rays = run["history/shock"] if "shock" in run["history"] else {}
    return pressures, {name: rays[name][:] for name in rays if np.isfinite(rays[name][:]).any()}


def history(axes, runs):
    for run in runs:
        scheme = text(run["run"].attrs["scheme"])
        t, t_unit = scaled(run["history/time"][:], "s")
        pressures, radii = curves(run)
        for style, (name, values) in zip(STYLES, pressures.items()):
            axes[0].plot(t, values, style, color=COLOURS.get(scheme), lw=1, label=f"{scheme}, {name}")
        for style, (name, values) in zip(STYLES, radii.items()):
            axes[1].plot(t, values, style, color=COLOURS.get(scheme), lw=1, label=f"{scheme}, {name}")
        if not radii:
            axes[1].plot(t, run["history/dt"][:], color=COLOURS.get(scheme), lw=1, label=scheme)
        axes[1].set_ylabel("shock radius [m]" if radii else "time step [s]")
        axes[2].plot(t, 100 * run["history/active_share"][:], color=COLOURS.get(scheme), lw=1,
                     label=f"{scheme}, computed")
        axes[2].plot(t, 100 * run["history/stored_share"][:], "--", color=COLOURS.get(scheme), lw=1,
                     label=f"{scheme}, stored")
        for axis in axes:
            axis.set_xlabel(f"t [{t_unit}]")
    low, high = axes[0].get_ylim()
    if high > 1e8 or low > 0 and high > 100 * low:
        axes[0].set_yscale("log")
    axes[0].set_ylabel("pressure [Pa]")
    axes[2].set_ylabel("share of the cells [%]")
    axes[2].set_ylim(0, 105)
    for axis in axes:
        axis.legend(fontsize=7)


def main():
    *sources, out = sys.argv[1:]
    runs = [h5py.File(source, "r") for source in sources]
    shown = runs[-1]
    last = shown["state"][sorted(shown["state"])[-1]]
    planes = {field: list(slices(last, field)) for field in ("density", "pressure")}
    shapes = planes["density"]
    wide = (shapes[0][1][-1] - shapes[0][1][0]) > 2 * (shapes[0][3][-1] - shapes[0][3][0])
    rows = [(field, k) for field in planes for k in range(len(shapes))]
    figure = plt.figure(figsize=(13, 4 + (2.6 * len(rows) if wide else 4.6 * ((len(rows) + 1) // 2))),
                        constrained_layout=True)
    upper, lower = figure.subfigures(2, 1, height_ratios=[(2.6 * len(rows) if wide else 4.6 * ((len(rows) + 1) // 2)), 4])
    grid = upper.subplots(len(rows), 1) if wide else upper.subplots((len(rows) + 1) // 2, 2)
    for axis, (field, k) in zip(np.ravel(grid), rows):
        draw_slice(axis, last, field, planes[field][k])
    history(lower.subplots(1, 3), runs)
    figure.suptitle(f"{text(shown['run'].attrs['title'])}\n{text(shown['run'].attrs['variant'])}, "
                    f"{text(shown['run'].attrs['scheme'])}", fontsize=11)
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main()
