"""Grids of steel and gas near the charge, in the plane y = 0.

usage: fig12.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _paper import (CM, LineCollection, arguments, body_plane, density_limits, draw_density, plt, save, section_axes)


def lines(across, up, where=None):
    """Sides of the cells [up][across] that are wanted, once each."""
    out = []
    where = np.ones((len(up) - 1, len(across) - 1), bool) if where is None else where
    tall = np.pad(where, ((0, 0), (1, 1)))
    wide = np.pad(where, ((1, 1), (0, 0)))
    for k, i in np.argwhere(tall[:, 1:] | tall[:, :-1]):
        out.append([(across[i], up[k]), (across[i], up[k + 1])])
    for k, i in np.argwhere(wide[1:] | wide[:-1]):
        out.append([(across[i], up[k]), (across[i + 1], up[k])])
    return np.array(out)


def main():
    runs, out = arguments()
    state = runs[0].states[0]
    figure, axes = plt.subplots(figsize=(8, 7), constrained_layout=True)
    image = draw_density(axes, state, density_limits(state))
    figure.colorbar(image, ax=axes, label="density of the gas [kg/m3]", shrink=0.8)
    cells = lines(state.nodes[0] / CM, state.nodes[2] / CM)
    for mirror in ((1, 1), (-1, 1), (1, -1)):
        axes.add_collection(LineCollection(cells * mirror, colors="0.6", linewidths=0.4))
    corners = []
    for body in state.bodies():
        nodes = body.nodes()
        grid = lines(nodes[0] / CM, nodes[2] / CM, np.isfinite(body_plane(body, body.field("density"))))
        for axis in (0, 2):
            if axis in body.mirrors:
                grid = np.concatenate([grid, grid * ([-1, 1] if axis == 0 else [1, -1])])
        axes.add_collection(LineCollection(grid, colors="tab:red", linewidths=0.5))
        corners.append(body.whole().reshape(-1, 3) / CM)
    corners = np.concatenate(corners)
    section_axes(axes)
    axes.set_xlim(-0.8, corners[:, 0].max() + 0.7)
    axes.set_ylim(-0.8, corners[:, 2].max() + 0.7)
    axes.set_title(f"Grids of gas (grey) and steel (red), y = 0\n{runs[0].label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
