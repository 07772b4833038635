"""Two bodies as surfaces of triangles, and local grids on them.

usage: fig08.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _local_grid import LocalGrid, triangle_facing
from _paper import CM, US, arguments, plt, save, solid, view

SURFACES = {"top": (0.45, 0.6, 0.9), "tilted": (0.9, 0.45, 0.4)}


def main():
    runs, out = arguments()
    state = runs[0].near(8 * US)
    figure = plt.figure(figsize=(8.5, 7), constrained_layout=True)
    axes = figure.add_subplot(projection="3d", computed_zorder=False)
    bodies = [body for body in state.bodies() if body.name in SURFACES]
    shown = []
    for body in bodies:
        solid(axes, body.vertices[body.triangles], SURFACES[body.name], alpha=0.6)
        shown.append(body.vertices[body.triangles])
        for direction in (-body.vertices.mean(axis=0), (0, 1, 0)):
            grid = LocalGrid(body, triangle_facing(body, direction), runs[0].cell)
            grid.draw(axes, CM, alpha=0.15)
            shown.append(grid.box())
    view(axes, np.concatenate(shown), azimuth=30)
    counts = ", ".join(f"'{body.name}' {len(body.triangles)}" for body in bodies)
    axes.set_title(f"Surfaces ({counts} triangles) and some of their local grids\n{runs[0].label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
