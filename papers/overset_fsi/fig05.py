"""The local grid of one triangle of a body's surface: cells of gas and of solid.

usage: fig05.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _local_grid import COLOURS, towards_charge
from _paper import CM, arguments, plt, save, solid, view
from matplotlib.patches import Patch


def main():
    runs, out = arguments()
    state, body, _, grid = towards_charge(runs[0])
    figure = plt.figure(figsize=(7.5, 7), constrained_layout=True)
    axes = figure.add_subplot(projection="3d", computed_zorder=False)
    solid(axes, body.whole(), alpha=0.35)
    grid.draw(axes, CM)
    view(axes, np.concatenate([body.whole(), grid.box()]), azimuth=-100)
    axes.legend(handles=[Patch(facecolor=c, edgecolor="0.25", label=f"{m}: 3 x 3 x 3 cells") for m, c in COLOURS.items()])
    axes.set_title(f"Local grid of a triangle of the body '{body.name}'\n{runs[0].label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
