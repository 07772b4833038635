"""Default figure of a scene with bodies: gas and the stress in the bodies in planes through the first one; histories.

usage: scene-bodies.py RUN.h5 [RUN.h5 ...] OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm

AXES = "xyz"
STYLES = ("-", "--", ":", "-.")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def unit_of(size, steps):
    """The largest unit of (factor, name) below `size`."""
    return next((step for step in steps if size >= step[0]), steps[-1])


def nodes_of(grid):
    """Faces along z, y, x of a body's own grid."""
    lower, cell = grid["lower"][:], grid.attrs["cell"]
    counts = grid["density"].shape
    return [lower[2 - k] + cell * np.arange(counts[k] + 1) for k in range(3)]


def outline(body, axis, at):
    """Segments in which the plane x[axis] = at cuts a surface, in the other two coordinates."""
    corners = body["vertices"][:][body["triangles"][:]]
    others = [d for d in range(3) if d != axis]
    segments = []
    for triangle in corners:
        height = triangle[:, axis] - at
        points = [triangle[i] + (triangle[j] - triangle[i]) * height[i] / (height[i] - height[j])
                  for i, j in ((0, 1), (1, 2), (2, 0)) if (height[i] > 0) != (height[j] > 0)]
        if len(points) == 2:
            segments.append([point[others] for point in points])
    return segments


def plane(values, nodes, axis, at):
    """The cells of [nz][ny][nx] whose middle is nearest to x[axis] = at, as [up][across]."""
    faces = nodes[2 - axis]
    index = int(np.argmin(np.abs((faces[1:] + faces[:-1]) / 2 - at)))
    return np.take(values, index, axis=2 - axis)


def draw_plane(axes, state, axis, at, length):
    factor, unit = length
    across, up = [d for d in range(3) if d != axis]
    nodes = [state[AXES[2 - k]][:] for k in range(3)]
    density = plane(state["density"][:], nodes, axis, at)
    density = np.where(density != 0, density, np.nan)
    low, high = np.nanmin(density), np.nanmax(density)
    spread = low > 0 and high > 20 * low
    gas = axes.pcolormesh(nodes[2 - across] / factor, nodes[2 - up] / factor, density, cmap="viridis", rasterized=True,
                          norm=LogNorm(max(low, 1e-6 * high), high) if spread else None)
    plt.colorbar(gas, ax=axes, label="density of the gas [kg/m3]", shrink=0.8)
    # rigid bodies have no grid
    grids = {name: body["grid"] for name, body in state["body"].items() if "grid" in body}
    solid, most = None, max((grid["von_mises"][:].max() for grid in grids.values()), default=0)
    for name, body in state["body"].items():
        own = nodes_of(grids[name]) if name in grids else None
        if own and own[2 - axis][0] < at < own[2 - axis][-1]:
            mises = np.where(grids[name]["density"][:] != 0, grids[name]["von_mises"][:], np.nan)
            solid = axes.pcolormesh(own[2 - across] / factor, own[2 - up] / factor, plane(mises, own, axis, at) / 1e6,
                                    cmap="inferno", vmin=0, vmax=most / 1e6, rasterized=True)
        segments = np.array(outline(body, axis, at))
        if segments.size:
            axes.add_collection(LineCollection(segments / factor, colors="k", linewidths=1.0))
            axes.annotate(name, segments.max(axis=(0, 1)) / factor, color="w", fontsize=8)
    if solid is not None:
        plt.colorbar(solid, ax=axes, label="von Mises stress [MPa]", shrink=0.8)
    axes.set_aspect("equal")
    axes.set_facecolor("0.7")  # cells that a surface cuts
    axes.set_xlabel(f"{AXES[across]} [{unit}]")
    axes.set_ylabel(f"{AXES[up]} [{unit}]")
    axes.set_title(f"t = {state.attrs['time'] * 1e6:.4g} us, {AXES[axis]} = {at / factor:.3g} {unit}", fontsize=9)


def draw_histories(axes, runs):
    for run in runs:
        label = text(run["run"].attrs["scheme"])
        t = run["history/time"][:] * 1e6
        for colour, (name, body) in enumerate(run["history/body"].items()):
            for d, style in zip(AXES, STYLES):
                shown = dict(color=f"C{colour}", ls=style, lw=1, label=f"{name}, {d}, {label}")
                axes[0].plot(t, body[f"velocity_{d}"][:], **shown)
                thickness = body[f"extent_{d}"][:]
                axes[2].plot(t, 100 * (thickness / thickness[0] - 1), **shown)
                given = body[f"impulse_{d}"][:]
                axes[1].plot(t, body[f"momentum_{d}"][:] - body[f"momentum_{d}"][0], **shown)
                axes[1].plot(t, given, color="k", ls=style, lw=0.5)
        probes = run["history/probe"] if "probe" in run["history"] else {}
        for style, (name, probe) in zip(STYLES, probes.items()):
            axes[3].plot(t, probe["pressure"][:] / 1e5, ls=style, lw=1, label=f"{name}, {label}")
    for axis, what in zip(axes, ("velocity [m/s]", "momentum, and impulse (thin) [N s]", "change of extent [%]",
                                 "pressure at probes [bar]")):
        axis.set_xlabel("t [us]")
        axis.set_ylabel(what)
        axis.margins(x=0)
        if axis.lines:
            axis.legend(fontsize=6)


def main():
    *sources, out = sys.argv[1:]
    runs = [h5py.File(source, "r") for source in sources]
    shown = runs[-1]
    last = shown["state"][sorted(shown["state"])[-1]]
    first = next(iter(last["body"].values()))
    middle = first["vertices"][:].mean(axis=0)
    length = unit_of(max(last[a][-1] - last[a][0] for a in AXES), [(1, "m"), (1e-2, "cm"), (1e-3, "mm")])
    figure, axes = plt.subplots(3, 2, figsize=(13, 14), constrained_layout=True)
    for panel, axis in zip(axes[0], (2, 1)):
        draw_plane(panel, last, axis, middle[axis], length)
    draw_histories(axes[1:].ravel(), runs)
    figure.suptitle(f"{text(shown['run'].attrs['title'])}\n{text(shown['run'].attrs['variant'])}, "
                    f"{text(shown['run'].attrs['scheme'])}", fontsize=11)
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main()
