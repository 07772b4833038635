"""Figures of the shape that a body on the axis is left in: section and view, and what the axis tells."""
import numpy as np
from _paper import CM, STEEL, LineCollection, arguments, axis_points, plt, save, section, section_axes, solid, view


def facts(first, last):
    """Thickness along the axis over the initial one; how far the faces' middles lie behind their outermost points
    [m]."""
    low_0, high_0 = axis_points(first)
    low, high = axis_points(last)
    far_rim, near_rim = last[:, :, 2].max(), last[:, :, 2].min()
    return {"thickness": high - low, "ratio": (high - low) / (high_0 - low_0),
            "far": far_rim - high, "near": low - near_rim}


def flank(corners, side):
    """z of the outermost surface on one side (1 far, -1 near) at half the body's radius in y = 0 [m]."""
    segments = section(corners, 1)
    half = 0.5 * segments[:, :, 0].max()
    crossing = segments[(segments[:, :, 0].min(axis=1) <= half) & (segments[:, :, 0].max(axis=1) >= half)]
    z = [a[1] + (b[1] - a[1]) * (half - a[0]) / (b[0] - a[0] or 1e-300) for a, b in crossing]
    return side * max(side * np.array(z))


def draw(name):
    runs, out = arguments()
    run = runs[0]
    first, last = (state.body("top").whole() for state in (run.states[0], run.states[-1]))
    of_axis = facts(first, last)
    low, high = axis_points(last)
    # positive: the middle stands out over the flank
    far, near = high - flank(last, 1), flank(last, -1) - low
    figure = plt.figure(figsize=(12, 5.4), constrained_layout=True)
    axes = figure.add_subplot(1, 3, 1)
    shift = last[:, :, 2].mean() - first[:, :, 2].mean()
    axes.add_collection(LineCollection((section(first, 1) + [0, shift]) / CM, colors="0.6", linewidths=1))
    axes.add_collection(LineCollection(section(last, 1) / CM, colors="k", linewidths=1.4))
    axes.plot([0, 0], [low / CM, high / CM], "o", color="tab:red", ms=4)
    section_axes(axes)
    axes.autoscale_view()
    axes.margins(0.1)
    axes.set_title("section y = 0 (grey: the initial shape, moved)", fontsize=9)
    for n, (elevation, side) in enumerate(((30, "far side"), (-30, "near side"))):
        axes = figure.add_subplot(1, 3, n + 2, projection="3d")
        solid(axes, last, STEEL, altitude=elevation)
        view(axes, last, elevation)
        axes.set_title(side, fontsize=9)

    def words(height):
        return f"{'bulge' if height > 0 else 'depression'} of {abs(height) * 1e3:.2f} mm"

    told = (f"thickness on the axis {of_axis['thickness'] * 1e3:.2f} mm, {of_axis['ratio']:.3f} of the initial one; "
            f"against half the radius: far side {words(far)}, near side {words(near)}")
    print(told)
    print(f"against the outermost points: far side {of_axis['far'] * 1e3:.2f} mm behind, near side "
          f"{of_axis['near'] * 1e3:.2f} mm behind")
    figure.suptitle(f"Residual shape: {name}\n{run.label(run.states[-1])}\n{told}", fontsize=10)
    save(figure, out)
