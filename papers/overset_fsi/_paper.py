"""What the figures of the paper share: runs, whole bodies beyond their planes of symmetry, sections, labels.

Scripts are called with HDF5 files of runs and the figure's file: figNN.py RUN.h5 [RUN.h5 ...] OUT.png
"""
import io
import sys
import tomllib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import LightSource, LogNorm
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from PIL import Image

CM, US = 1e-2, 1e-6
LARGEST = 300_000  # bytes of a figure
STEEL = np.array([0.62, 0.66, 0.72])


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def si(value):
    """"175 GPa" in Pa, "1.65 g/cm3" in kg/m3."""
    number, unit = value.split()
    return float(number) * {"Pa": 1, "MPa": 1e6, "GPa": 1e9, "kg/m3": 1, "g/cm3": 1e3}[unit]


class Body:
    """A body at one time; `whole` is it with its images beyond planes of symmetry."""

    def __init__(self, name, group):
        self.name, self.group = name, group
        self.vertices, self.triangles = group["vertices"][:], group["triangles"][:]
        self.pressure = group["pressure"][:]
        self.lower, self.cell = group["grid/lower"][:], float(group["grid"].attrs["cell"])
        self.mirrors = self._mirrors()

    def _mirrors(self):
        """Axes whose plane x = 0 cuts the body: there its surface is open."""
        edges = np.sort(self.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        unique, counts = np.unique(edges, axis=0, return_counts=True)
        rim = self.vertices[unique[counts == 1]]
        near = 1e-6 * np.ptp(self.vertices, axis=0).max()
        return [d for d in range(3) if rim.size and (np.abs(rim[:, :, d]) < near).all(axis=1).any()]

    def whole(self):
        """Corners of all triangles, [n][3][3]."""
        corners = self.vertices[self.triangles]
        for d in self.mirrors:
            image = corners[:, ::-1].copy()
            image[:, :, d] *= -1
            corners = np.concatenate([corners, image])
        return corners

    def field(self, name):
        """[nz][ny][nx], nan where a cell is not of the body."""
        values = self.group["grid/" + name][:]
        return np.where(self.group["grid/density"][:] > 0, values, np.nan)

    def nodes(self):
        """Faces along x, y, z."""
        count = self.group["grid/density"].shape
        return [self.lower[d] + self.cell * np.arange(count[2 - d] + 1) for d in range(3)]


class State:
    def __init__(self, group):
        self.time, self.group = float(group.attrs["time"]), group
        self.nodes = [group[a][:] for a in "xyz"]

    def bodies(self):
        return [Body(name, group) for name, group in self.group["body"].items()]

    def body(self, name):
        bodies = self.bodies()
        return next((b for b in bodies if b.name == name), bodies[0])

    def gas(self, name):
        """[nz][ny][nx], nan where a body is."""
        values = self.group[name][:]
        return np.where(self.group["density"][:] > 0, values, np.nan)


class Run:
    def __init__(self, file):
        try:
            self.file = h5py.File(file, "r")
        except OSError as error:
            sys.exit(f"{file}: cannot be read as results: {error}")
        about = self.file["run"].attrs
        self.scene, self.scheme = text(about.get("scene", "?")), text(about["scheme"])
        self.variant = text(about["variant"])
        if "body" not in self.file["history"]:
            sys.exit(f"{file}: a run without bodies")
        self.states = [State(self.file["state"][s]) for s in sorted(self.file["state"])]
        nodes = self.states[-1].nodes[0]
        self.cell = float(nodes[1] - nodes[0])
        self.end = self.states[-1].time

    def near(self, time):
        """The state whose time is nearest to this [s]."""
        return min(self.states, key=lambda s: abs(s.time - time))

    def history(self, name):
        return self.file["history/" + name][:]

    def material(self, name):
        """As the scene gives it."""
        return tomllib.loads(text(self.file["provenance/scene"][()]))["material"][name]

    def has(self, name):
        return "history/" + name in self.file

    @property
    def elastic(self):
        """By the variant's name, else whether nothing yielded."""
        if self.variant in ("elastic", "elastoplastic"):
            return self.variant == "elastic"
        return all(body["plastic_strain"][-1] == 0 for body in self.file["history/body"].values())

    @property
    def complete(self):
        return self.file["run"].attrs["complete"] != 0

    def label(self, state=None):
        """Scheme, grid, time: for titles."""
        cells = sorted({round(b.cell * 1e3, 3) for b in self.states[-1].bodies()})
        solid = ", ".join(f"{c:g}" for c in cells)
        when = f", t = {state.time / US:.3g} us" if state else f", to {self.end / US:.3g} us"
        stopped = "" if self.complete else " (unfinished)"
        grids = f"cells: gas {self.cell * 1e3:.3g} mm, steel {solid} mm"
        return f"{self.scene}: {self.scheme} scheme, {grids}{when}{stopped}"


def arguments():
    """Runs, from fine to coarse, and the figure's file."""
    *sources, out = sys.argv[1:]
    return sorted((Run(source) for source in sources), key=lambda run: run.cell), out


def save(figure, out, dpi=110):
    """As PNG of a palette, on fewer points where it would be too large."""
    while True:
        buffer, small = io.BytesIO(), io.BytesIO()
        figure.savefig(buffer, format="png", dpi=dpi)
        Image.open(buffer).convert("RGB").quantize(192, dither=Image.Dither.NONE).save(small, "png", optimize=True)
        if small.tell() < LARGEST or dpi < 50:
            break
        dpi *= 0.85
    with open(out, "wb") as file:
        file.write(small.getvalue())


def section(corners, axis, at=0.0):
    """Segments in which x[axis] = at cuts triangles, in the other two coordinates: [n][2][2]."""
    others = [d for d in range(3) if d != axis]
    shifted = at + 1e-9 * np.ptp(corners)  # not through vertices
    segments = []
    for triangle in corners[(corners[:, :, axis].min(axis=1) < shifted) & (corners[:, :, axis].max(axis=1) > shifted)]:
        height = triangle[:, axis] - shifted
        points = [triangle[i] + (triangle[j] - triangle[i]) * height[i] / (height[i] - height[j])
                  for i, j in ((0, 1), (1, 2), (2, 0)) if (height[i] > 0) != (height[j] > 0)]
        if len(points) == 2:
            segments.append([point[others] for point in points])
    return np.array(segments).reshape(-1, 2, 2)


def draw_section(axes, body, **style):
    """The outline of a whole body in the plane y = 0, [cm]."""
    shown = dict(colors="k", linewidths=1.0) | style
    axes.add_collection(LineCollection(section(body.whole(), 1) / CM, **shown))


def polygons(segments):
    """Closed lines that segments make up, [points][2] each."""
    def key(point):
        return tuple(np.round(point / span, 7))

    span = np.ptp(segments) or 1.0
    ends = {}
    for n, pair in enumerate(segments):
        for point in pair:
            ends.setdefault(key(point), []).append(n)
    left, out = set(range(len(segments))), []
    while left:
        n = left.pop()
        line = list(segments[n])
        while (follower := next((m for m in ends[key(line[-1])] if m in left), None)) is not None:
            left.discard(follower)
            a, b = segments[follower]
            line.append(b if key(a) == key(line[-1]) else a)
        out.append(np.array(line))
    return out


def fill_section(axes, body, **style):
    """The section of a whole body with y = 0, [cm]."""
    for polygon in polygons(section(body.whole(), 1)):
        axes.fill(*polygon.T / CM, **dict(facecolor="0.85", edgecolor="k", linewidth=1.0) | style)


def plane(values):
    """The layer of [nz][ny][nx] beside the plane of symmetry y = 0, the first one."""
    return values[:, 0, :]


def body_plane(body, values):
    """The layer of a body's own grid nearest to y = 0."""
    middles = body.nodes()[1][:-1] + body.cell / 2
    return values[:, int(np.argmin(np.abs(middles - body.cell / 4))), :]


def draw_density(axes, state, limits):
    """Density of the gas in y = 0 by its logarithm, with images beyond x = 0 and z = 0, and outlines of the bodies;
    returns the image."""
    x, z = state.nodes[0] / CM, state.nodes[2] / CM
    density = plane(state.gas("density"))
    shown = dict(cmap="turbo", norm=LogNorm(*limits), rasterized=True)
    for sign_x in (1, -1) if state.nodes[0][0] == 0 else (1,):
        for sign_z in (1, -1) if state.nodes[2][0] == 0 else (1,):
            image = axes.pcolormesh(sign_x * x, sign_z * z, density, **shown)
    axes.set_facecolor("0.85")
    for body in state.bodies():
        fill_section(axes, body)
    return image


def density_limits(state):
    density = plane(state.gas("density"))
    high = float(np.nanmax(density))
    return max(float(np.nanmin(density)), 1e-4 * high), high


def section_axes(axes, nodes=None):
    """Equal scales; with `nodes` the domain and a strip beyond its planes of symmetry, that bodies there show whole."""
    axes.set_aspect("equal")
    axes.set_xlabel("x [cm]")
    axes.set_ylabel("z [cm]")
    if nodes is not None:
        axes.set_xlim(nodes[0][0] / CM - 1, nodes[0][-1] / CM)
        axes.set_ylim(nodes[2][0] / CM - 1, nodes[2][-1] / CM)


def solid(axes, corners, colour=STEEL, alpha=1.0, altitude=35):
    """Shaded triangles [cm] in a 3D view, lit from this altitude [deg]."""
    corners = corners / CM
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    shade = 0.45 + 0.55 * np.clip(normals @ LightSource(azdeg=120, altdeg=altitude).direction, 0, 1)
    colours = np.broadcast_to(np.atleast_2d(colour)[:, :3], (len(corners), 3)) * shade[:, None]
    faces = np.column_stack([colours, np.full(len(corners), alpha)])
    axes.add_collection3d(Poly3DCollection(corners, facecolors=faces, edgecolors=faces * [0.85, 0.85, 0.85, 1],
                                           linewidths=0.2))


def view(axes, corners, elevation=22, azimuth=-62):
    """Equal scales about all of `corners`."""
    low, high = corners.min(axis=(0, 1)) / CM, corners.max(axis=(0, 1)) / CM
    half = 0.55 * (high - low).max()
    for limit, middle in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), (low + high) / 2):
        limit(middle - half, middle + half)
    axes.set_box_aspect((1, 1, 1))
    axes.set_proj_type("ortho")
    axes.view_init(elevation, azimuth)
    for name in "xyz":
        getattr(axes, f"set_{name}label")(f"{name} [cm]", fontsize=8)
    axes.tick_params(labelsize=7)


def axis_points(corners):
    """Where the axis x = y = 0 cuts a surface: lowest and highest z [m]."""
    a, b, c = (corners[:, k, :2] for k in range(3))
    away = np.array([1e-9, 2e-9])  # beside the corners that lie on the axis
    ab, ac, to = b - a, c - a, away - a
    det = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (to[:, 0] * ac[:, 1] - to[:, 1] * ac[:, 0]) / det
        t = (ab[:, 0] * to[:, 1] - ab[:, 1] * to[:, 0]) / det
        hit = (det != 0) & (s >= 0) & (t >= 0) & (s + t <= 1)
    z = corners[hit, 0, 2] + s[hit] * (corners[hit, 1, 2] - corners[hit, 0, 2]) \
        + t[hit] * (corners[hit, 2, 2] - corners[hit, 0, 2])
    z = z[np.isfinite(z)]
    if z.size < 2:
        sys.exit("the body is not on the axis x = y = 0")
    return z.min(), z.max()
