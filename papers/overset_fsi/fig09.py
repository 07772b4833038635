"""Slice of a body with its own grid: the four kinds of cells.

usage: fig09.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _paper import CM, US, arguments, body_plane, draw_section, plt, save, section_axes
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

# as the results number them
KINDS = (("outside", "0.93"), ("cut by the surface", "mediumseagreen"),
         ("inside, from the model problems and by interpolation", "gold"),
         ("inside, full stencil: the scheme's own", "peru"))


def main():
    runs, out = arguments()
    state = runs[0].near(13 * US)
    body = state.body("tilted")
    if "kind" not in body.group["grid"]:
        raise SystemExit("fig09: these results do not hold the kinds of cells")
    kind = body_plane(body, body.group["grid/kind"][:])
    nodes = body.nodes()
    figure, axes = plt.subplots(figsize=(7.5, 7.5), constrained_layout=True)
    axes.pcolormesh(nodes[0] / CM, nodes[2] / CM, kind, cmap=ListedColormap([colour for _, colour in KINDS]),
                    vmin=-0.5, vmax=3.5, edgecolors="0.4", linewidth=0.3)
    draw_section(axes, body, linewidths=1.8)
    section_axes(axes)
    points = body.whole().reshape(-1, 3) / CM
    margin = 3 * body.cell / CM
    axes.set_xlim(points[:, 0].min() - margin, points[:, 0].max() + margin)
    axes.set_ylim(points[:, 2].min() - margin, points[:, 2].max() + margin)
    counts = [int(np.count_nonzero(kind == k)) for k in range(4)]
    axes.legend(handles=[Patch(facecolor=colour, edgecolor="0.4", label=f"{name} ({count})")
                         for (name, colour), count in zip(KINDS, counts)], loc="upper center",
                bbox_to_anchor=(0.5, -0.08), ncol=2, fontsize=9)
    axes.set_title(f"Cells of the body '{body.name}', beside y = 0\n{runs[0].label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
