"""Computational domain: charge, bodies and axes in the plane y = 0 at the start.

usage: fig11.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _paper import CM, arguments, fill_section, plane, plt, save, section, section_axes


def charge_radius(state):
    """Farthest cell in the plane where the gas is denser than half of the densest [m]."""
    density = plane(state.gas("density"))
    x, z = (0.5 * (n[1:] + n[:-1]) for n in (state.nodes[0], state.nodes[2]))
    dense = density > 0.5 * np.nanmax(density)
    return np.hypot(*np.meshgrid(x, z))[dense].max()


def main():
    runs, out = arguments()
    state = runs[0].states[0]
    figure, axes = plt.subplots(figsize=(7.5, 7), constrained_layout=True)
    x, z = state.nodes[0] / CM, state.nodes[2] / CM
    density = plane(state.gas("density"))
    image = axes.pcolormesh(x, z, density, cmap="YlOrBr", vmin=0, rasterized=True)
    figure.colorbar(image, ax=axes, label="density of the gas [kg/m3]", shrink=0.8)
    for body in state.bodies():
        fill_section(axes, body, facecolor="tab:red", linewidth=0)
        middle = section(body.whole(), 1).mean(axis=(0, 1)) / CM
        axes.annotate(body.name, middle, color="w", ha="center", va="center", fontsize=9)
    angle = np.linspace(0, np.pi / 2, 100)
    radius = charge_radius(state) / CM
    axes.plot(radius * np.cos(angle), radius * np.sin(angle), "k--", lw=0.8)
    axes.annotate(f"dense gas to r = {radius:.2f} cm", (0.35 * radius, 0.35 * radius), ha="center", fontsize=9)
    section_axes(axes, state.nodes)
    for axis in (axes.axhline, axes.axvline):
        axis(0, color="k", lw=1, ls="-.")
    axes.set_title(f"Computational domain, an octant: section y = 0\n{runs[0].label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
