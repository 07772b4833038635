"""The local grid after a number of steps: it has moved with the contact.

usage: fig07.py RUN.h5 OUT.png
"""
# needs: three-cubes
from _local_grid import towards_charge
from _paper import US, arguments, plt, save


def main():
    runs, out = arguments()
    run = runs[0]
    state, body, triangle, grid = towards_charge(run)
    motion = float(body.group["velocity"][triangle] @ grid.axes[0]) * US
    figure, axes = plt.subplots(figsize=(5.5, 6.5), constrained_layout=True)
    grid.draw_section(axes, 1e-3, motion)
    axes.axhline(0, color="k", ls="--", lw=1.2, label="contact 1 us before, by its velocity")
    axes.legend(loc="upper right", fontsize=9)
    axes.set_title(f"After steps of 1 us: {motion * 1e3:.3g} mm along the normal\n{run.label(state)}", fontsize=9)
    save(figure, out)


if __name__ == "__main__":
    main()
