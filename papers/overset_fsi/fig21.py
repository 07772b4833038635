"""Velocities of the centres of mass of disc, tetrahedron and cube of equal mass; elastic ones dashed.

usage: fig21.py RUN.h5 [RUN.h5 ...] OUT.png; three grids of a body carry a band of their convergence (GCI)
"""
# needs: equal-mass-disc
# needs: tetrahedron
# needs: equal-mass-cube
import _gci
from _paper import US, arguments, plt, save

SHAPES = ("disc", "tetrahedron", "cube")


def curve(run):
    bodies = run.file["history/body"]
    body = bodies["top"] if "top" in bodies else next(iter(bodies.values()))
    return run.history("time"), body["velocity_z"][:]


def groups(runs):
    """Runs by shape and law, each from fine to coarse."""
    out = {}
    for run in runs:
        shape = next((s for s in SHAPES if s in run.scene), run.scene)
        out.setdefault((shape, run.elastic), []).append(run)
    return dict(sorted(out.items(), key=lambda item: (SHAPES + (item[0][0],)).index(item[0][0])))


def draw_group(axes, colour, shape, elastic, runs):
    """The finest grid's curve, with the band where there are three grids; returns what to say of it."""
    time, velocity = curve(runs[0])
    law = "elastic" if elastic else "elastoplastic"
    axes.plot(time / US, velocity, "--" if elastic else "-", color=colour, lw=1.4, label=f"{shape}, {law}")
    print(f"{shape}, {law}: {velocity[-1]:.1f} m/s at {time[-1] / US:.3g} us")
    if len(runs) < 3:
        return None
    return _gci.draw_band(axes, [run.cell for run in runs[:3]], [curve(run) for run in runs[:3]], colour,
                          f"{shape}, {law}", US)


def main():
    runs, out = arguments()
    figure, axes = plt.subplots(figsize=(8, 5.5), constrained_layout=True)
    found = groups(runs)
    shapes = list(dict.fromkeys(shape for shape, _ in found))
    said = [draw_group(axes, f"C{shapes.index(shape)}", shape, elastic, group)
            for (shape, elastic), group in found.items()]
    said = [line for line in said if line]
    for line in said:
        print(line)
    axes.set_xlabel("t [us]")
    axes.set_ylabel("velocity of the centre of mass along the axis [m/s]")
    axes.grid(alpha=0.3)
    axes.legend()
    axes.set_title("\n".join(["Bodies of equal mass", runs[0].label(), *said]), fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
