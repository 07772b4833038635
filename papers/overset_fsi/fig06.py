"""The local grid before a step: the cells that are to be integrated.

usage: fig06.py RUN.h5 OUT.png
"""
# needs: three-cubes
from _local_grid import LocalGrid, triangle_facing
from _paper import US, arguments, plt, save


def main():
    runs, out = arguments()
    state = runs[0].near(8 * US)
    body = state.body("tilted")
    grid = LocalGrid(body, triangle_facing(body, -body.vertices.mean(axis=0)), runs[0].cell)
    figure, axes = plt.subplots(figsize=(5.5, 6.5), constrained_layout=True)
    grid.draw_section(axes, 1e-3)
    axes.legend(loc="upper right", fontsize=9)
    axes.set_title(f"Before the step; crosses: cells integrated\n{runs[0].label(state)}", fontsize=9)
    save(figure, out)


if __name__ == "__main__":
    main()
