"""The local grid of a triangle: three layers of 3x3 cells of gas outwards and three of solid inwards, as in fsi/overset.

It stands on the triangle's centre; its axes are the normal, the triangle's first side and what is across both. Cells
are as wide as those of the gas's grid and of the body's own.
"""
import itertools

import numpy as np
from _paper import US
from matplotlib.patches import Rectangle
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

CORES = 2  # layers, the middle cells of which are integrated
COLOURS = {"gas": "mediumseagreen", "solid": "peru"}
SIDES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))  # of a cell, by corners


class LocalGrid:
    def __init__(self, body, triangle, gas_cell):
        corners = body.vertices[body.triangles[triangle]]
        a, b, c = corners
        n, side = np.cross(b - a, c - a), b - a
        n, side = n / np.linalg.norm(n), side / np.linalg.norm(side)
        self.corners, self.centre, self.axes = corners, corners.mean(axis=0), np.array([n, side, np.cross(n, side)])
        self.widths = {"gas": gas_cell, "solid": body.cell}

    def box(self):
        """The outermost corners, in threes."""
        at = [(k, 1.5 * i * width, 1.5 * j * width)
              for k, width in ((3 * self.widths["gas"], self.widths["gas"]), (-3 * self.widths["solid"],
                                                                              self.widths["solid"]))
              for i, j in ((-1, -1), (-1, 1), (1, -1), (1, 1), (0, 0), (0, 0))]
        return (self.centre + np.array(at) @ self.axes).reshape(-1, 3, 3)

    def draw(self, axes, scale, alpha=0.25):
        """All cells in a 3D view."""
        for medium, width in self.widths.items():
            out = width if medium == "gas" else -width
            quads = []
            for k, i, j in itertools.product(range(3), (-1, 0, 1), (-1, 0, 1)):
                at = [((k + p) * out, (i - 0.5 + q) * width, (j - 0.5 + r) * width)
                      for p, q, r in itertools.product((0, 1), repeat=3)]
                cell = (self.centre + np.array(at) @ self.axes) / scale
                quads += [cell[list(side)] for side in SIDES]
            axes.add_collection3d(Poly3DCollection(quads, facecolors=COLOURS[medium], edgecolors="0.25",
                                                   linewidths=0.3, alpha=alpha))

    def draw_section(self, axes, scale, shift=0.0):
        """The middle slice along the normal, moved by `shift` [m]; crosses in the cells that are integrated."""
        for medium, width in self.widths.items():
            w = width / scale
            for k, i in itertools.product(range(3), (-1, 0, 1)):
                x, y = (i - 0.5) * w, (k if medium == "gas" else -k - 1) * w + shift / scale
                core = i == 0 and k < CORES
                axes.add_patch(Rectangle((x, y), w, w, facecolor=COLOURS[medium], edgecolor="0.25", lw=0.8,
                                         alpha=0.8 if core else 0.35))
                if core:
                    axes.plot([x + w / 2], [y + w / 2], "kx", ms=11, mew=2)
        half = 1.7 * max(self.widths.values()) / scale
        axes.plot([-half, half], [shift / scale] * 2, color="tab:red", lw=2.5, label="contact")
        axes.set_aspect("equal")
        axes.set_xlabel("along the surface [mm]")
        axes.set_ylabel("along the normal [mm]")


def triangle_facing(body, direction):
    """Of the triangles that face this way the one nearest to the middle of the body's surface, across it."""
    corners = body.vertices[body.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    direction = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
    aside = np.linalg.norm(np.cross(corners.mean(axis=1) - corners.mean(axis=(0, 1)), direction), axis=1)
    return int(np.argmin(np.where(normals @ direction > 0.7, aside, np.inf)))


def towards_charge(run):
    """At 8 us: the state, the body 'tilted', the triangle in the middle of its side towards the charge, and its grid."""
    state = run.near(8 * US)
    body = state.body("tilted")
    triangle = triangle_facing(body, -body.vertices.mean(axis=0))
    return state, body, triangle, LocalGrid(body, triangle, run.cell)
