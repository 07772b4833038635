"""Motion of a surface: a body's outline between two states, and the cells that are filled from around them.

usage: fig10.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _paper import CM, US, LineCollection, arguments, body_plane, draw_section, plt, save, section_axes

SHALLOW = 2  # as the results number the kinds of cells


def main():
    runs, out = arguments()
    run = runs[0]
    new = run.near(13 * US)
    old = max((state for state in run.states if state.time < new.time), key=lambda state: state.time)
    before, after = old.body("top"), new.body("top")
    if "kind" not in after.group["grid"]:
        raise SystemExit("fig10: these results do not hold the kinds of cells")
    figure, axes = plt.subplots(figsize=(7.5, 7), constrained_layout=True)
    x, _, z = (nodes / CM for nodes in after.nodes())
    sides = [[(a, z[0]), (a, z[-1])] for a in np.concatenate([x, -x])]
    sides += [[(-x[-1], b), (x[-1], b)] for b in z]
    axes.add_collection(LineCollection(sides, colors="0.8", linewidths=0.4))
    k, i = np.nonzero(body_plane(after, after.group["grid/kind"][:]) == SHALLOW)
    middle = (0.5 * (x[1:] + x[:-1])[i], 0.5 * (z[1:] + z[:-1])[k])
    for sign in (1, -1) if 0 in after.mirrors else (1,):
        axes.plot(sign * middle[0], middle[1], "kx", ms=4, label="filled at the new time" if sign == 1 else None)
    for body, state, colour in ((before, old, "k"), (after, new, "tab:red")):
        draw_section(axes, body, colors=colour, linewidths=1.5, label=f"surface at {state.time / US:.3g} us")
    points = np.concatenate([body.whole().reshape(-1, 3) / CM for body in (before, after)])
    section_axes(axes)
    axes.set_xlim(points[:, 0].min() - 0.2, points[:, 0].max() + 0.2)
    axes.set_ylim(points[:, 2].min() - 0.2, points[:, 2].max() + 0.2)
    axes.legend(loc="upper right", fontsize=9)
    axes.set_title(f"Motion of the surface between two states, y = 0\n{run.label(new)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
