"""Shock tubes: one page a problem, and the errors of all of them.

usage: shock-tubes.py study.h5 OUT.png     (profiles.h5 lies beside study.h5; pages become OUT-PROBLEM.png)
"""
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STYLES = {"godunov": ("tab:gray", "Godunov", "s"), "linear": ("tab:blue", "linear, graded switch", "o"),
          "binary": ("tab:cyan", "linear, binary switch", "v"), "literal": ("tab:orange", "linear, literal switch", "x"),
          "parabolic": ("tab:red", "parabolic", "D"), "muscl": ("tab:green", "MUSCL van Leer", "^")}
SWITCHED = ("linear", "binary", "literal", "parabolic")


def unit(dataset):
    value = dataset.attrs["units"]
    return value.decode() if isinstance(value, bytes) else value


def draw_profiles(axes, group):
    x = group["x"][:]
    for axis, field in zip(axes, ("density", "velocity", "pressure")):
        reference = group[f"reference/{field}"]
        for scheme, (colour, label, _) in STYLES.items():
            if scheme in group:
                thin = scheme in ("literal", "binary")
                axis.plot(x, group[f"{scheme}/{field}"][:], color=colour, lw=0.7 if thin else 1.1,
                          alpha=0.7 if thin else 1, label=label)
        axis.plot(x, reference[:], "k--", lw=0.9, label="reference", zorder=5)
        low, high = np.nanmin(reference), np.nanmax(reference)  # a true vacuum has no velocity
        if field != "velocity" and low > 0 and high > 300 * low:
            axis.set_yscale("log")
        else:
            room = 0.12 * (high - low) if high - low > 1e-9 * max(abs(high), abs(low)) else 0.1 * max(abs(high), 1e-9)
            axis.set_ylim(low - room, high + room)
        axis.set_ylabel(f"{field} [{unit(reference)}]")


def draw_switch_map(axis, group):
    x = group["x"][:]
    half = 0.5 * (x[1] - x[0])
    faces = np.concatenate([x - half, [x[-1] + half]])
    shown = [s for s in SWITCHED if s in group]
    share = np.array([group[f"{s}/switched"][:] for s in shown])
    edges = np.concatenate([[faces[0] - half], 0.5 * (faces[1:] + faces[:-1]), [faces[-1] + half]])
    mesh = axis.pcolormesh(edges, np.arange(len(shown) + 1), share, cmap="Greys", vmin=0, vmax=1, rasterized=True)
    axis.set_yticks(np.arange(len(shown)) + 0.5, [STYLES[s][1] for s in shown], fontsize=8)
    axis.invert_yaxis()
    plt.colorbar(mesh, ax=axis, label="share of steps\nswitched", pad=0.01, aspect=8)


def page(name, group, rows, out):
    figure, axes = plt.subplots(4, 1, figsize=(8.5, 11), sharex=True, constrained_layout=True,
                                gridspec_kw={"height_ratios": [3, 3, 3, 1.1]})
    x = group["x"][:]
    draw_profiles(axes[:3], group)
    draw_switch_map(axes[3], group)
    axes[0].legend(fontsize=8, loc="best", framealpha=0.8)
    axes[3].set_xlabel(f"x [{unit(group['x'])}]")
    axes[3].set_xlim(x[0], x[-1])
    ratio = {s: r for p, s, r in rows if p == name}
    figure.suptitle(f"{name}: {len(x)} cells, t = {group.attrs['time']:.4g} s, CFL 0.8\ndensity error over Godunov's: "
                    f"parabolic {ratio['parabolic']:.2f}, linear {ratio['linear']:.2f}, "
                    f"van Leer {ratio['muscl']:.2f}", fontsize=11)
    figure.savefig(out, dpi=150)
    plt.close(figure)


def summary(rows, out):
    problems = list(dict.fromkeys(p for p, _, _ in rows))
    figure, axis = plt.subplots(figsize=(10, 6.5), constrained_layout=True)
    for offset, (scheme, (colour, label, marker)) in zip(np.linspace(-0.25, 0.25, len(STYLES)), STYLES.items()):
        y = [next((r for p, s, r in rows if p == problem and s == scheme), np.nan) for problem in problems]
        axis.plot(np.arange(len(problems)) + offset, y, marker, color=colour, ms=5, label=label)
    axis.axhline(1, color="tab:gray", lw=0.8)
    axis.set_yscale("log")
    axis.set_xticks(range(len(problems)), problems, rotation=55, ha="right")
    axis.set_ylabel("density error (L1) over Godunov's [1]")
    axis.set_title("The modified schemes follow the exact solution more closely than Godunov's on all but slow shocks")
    axis.grid(axis="y", which="both", alpha=0.25)
    axis.legend(fontsize=8, ncol=2)
    figure.savefig(out, dpi=150)


def main():
    source, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[-1])
    with h5py.File(source) as study, h5py.File(source.with_name("profiles.h5")) as profiles:
        table = study["tubes"]
        rows = list(zip(table["problem"].asstr()[:], table["scheme"].asstr()[:], table["over_godunov"][:]))
        summary(rows, out)
        for name in profiles:
            page(name, profiles[name], rows, out.with_name(f"{out.stem}-{name}.png"))


if __name__ == "__main__":
    main()
