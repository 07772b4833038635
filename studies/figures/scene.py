"""Default figure of a scene: profiles, x-t map and history of the runs given.

usage: scene.py RUN.h5 [RUN.h5 ...] OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLOURS = {"godunov": "tab:gray", "linear": "tab:blue", "parabolic": "tab:red", "muscl": "tab:green"}


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


def profiles(axes, runs):
    for axis, field in zip(axes, ("density", "velocity", "pressure")):
        for run in runs:
            scheme = text(run["run"].attrs["scheme"])
            last = sorted(run["state"])[-1]
            state = run["state"][last]
            faces, x_unit = scaled(state["faces"][:], "m")
            values, unit = scaled(state[field][:], text(state[field].attrs["units"]))
            axis.plot((faces[1:] + faces[:-1]) / 2, values, color=COLOURS.get(scheme), lw=1, label=scheme)
            time, t_unit = scaled(np.array([state.attrs["time"]]), "s")
            axis.set_title(f"t = {time[0]:.4g} {t_unit}", fontsize=9)
        axis.set_xlabel(f"x [{x_unit}]")
        axis.set_ylabel(f"{field} [{unit}]")
        if field != "velocity" and np.nanmin(values) > 0 and np.nanmax(values) > 100 * np.nanmin(values):
            axis.set_yscale("log")
    axes[0].legend(fontsize=8)


def space_time_map(axis, run):
    if "map" not in run:
        axis.set_axis_off()
        return
    x, x_unit = scaled(run["map/x"][:], "m")
    t, t_unit = scaled(run["map/time"][:], "s")
    p = run["map/pressure"][:]
    spread = p.min() > 0 and p.max() > 100 * p.min()
    shown = np.log10(p) if spread else p
    moving = not np.allclose(x, x[0])  # cells that move have no common edges: colours between their centres instead
    mesh = axis.pcolormesh(x, np.broadcast_to(t[:, None], x.shape), shown, shading="gouraud" if moving else "nearest", cmap="inferno",
                           rasterized=True)
    plt.colorbar(mesh, ax=axis, label="log10 of pressure [Pa]" if spread else "pressure [Pa]")
    axis.set_xlabel(f"x [{x_unit}]")
    axis.set_ylabel(f"t [{t_unit}]")
    axis.set_title(text(run["run"].attrs["scheme"]), fontsize=9)


def history(axis, runs):
    """Probes' pressures; without probes the largest pressure and that on the right boundary."""
    for run in runs:
        scheme = text(run["run"].attrs["scheme"])
        t, t_unit = scaled(run["history/time"][:], "s")
        probes = run["history/probe"] if "probe" in run["history"] else {}
        curves = {name: probes[name]["pressure"] for name in probes}
        curves = curves or {"largest": run["history/max_pressure"], "right": run["history/right_pressure"]}
        for style, (name, data) in zip(("-", "--", ":", "-."), curves.items()):
            axis.plot(t, data[:], style, color=COLOURS.get(scheme), lw=1, label=f"{scheme}, {name}")
    axis.set_xlabel(f"t [{t_unit}]")
    axis.set_ylabel("pressure [Pa]")
    low, high = axis.get_ylim()
    if low > 0 and high > 100 * low or high > 1e8:
        axis.set_yscale("log")
    axis.legend(fontsize=7)


def main():
    *sources, out = sys.argv[1:]
    runs = [h5py.File(source, "r") for source in sources]
    for source, run in zip(sources, runs):
        if "faces" not in run["state"][min(run["state"])]:
            sys.exit(f"{source}: results of a grid: draw scene-nd or scene-bodies")
    figure, axes = plt.subplots(2, 3, figsize=(13, 7), constrained_layout=True)
    figure.suptitle(f"{text(runs[0]['run'].attrs['title'])}\n{text(runs[0]['run'].attrs['variant'])}", fontsize=11)
    profiles(axes[0], runs)
    space_time_map(axes[1, 0], runs[-1])
    history(axes[1, 1], runs)
    position = axes[1, 2]
    for run in runs:
        scheme = text(run["run"].attrs["scheme"])
        t, t_unit = scaled(run["history/time"][:], "s")
        x, x_unit = scaled(run["history/shock_position"][:], "m")
        if np.isfinite(x).any():
            position.plot(t, x, color=COLOURS.get(scheme), lw=1, label=scheme)
            position.set_ylabel(f"shock position [{x_unit}]")
        else:
            largest, unit = scaled(run["history/max_pressure"][:], "Pa")
            position.plot(t, largest, color=COLOURS.get(scheme), lw=1, label=scheme)
            position.set_ylabel(f"largest pressure [{unit}]")
    position.set_xlabel(f"t [{t_unit}]")
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main()
