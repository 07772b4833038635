"""The local grid before a step: the cells that are to be integrated.

usage: fig06.py RUN.h5 OUT.png
"""
# needs: three-cubes
from _local_grid import towards_charge
from _paper import arguments, plt, save


def main():
    runs, out = arguments()
    state, _, _, grid = towards_charge(runs[0])
    figure, axes = plt.subplots(figsize=(5.5, 6.5), constrained_layout=True)
    grid.draw_section(axes, 1e-3)
    axes.legend(loc="upper right", fontsize=9)
    axes.set_title(f"Before the step; crosses: cells integrated\n{runs[0].label(state)}", fontsize=9)
    save(figure, out)


if __name__ == "__main__":
    main()
