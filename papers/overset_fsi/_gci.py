"""Grid convergence of curves: observed order and band of the finest of three grids (Roache 1994, Celik et al. 2008)."""
import numpy as np

SAFETY = 1.25  # three grids


def observed_order(fine, medium, coarse, r21, r32):
    """p of (coarse - medium)/(medium - fine) = r21^p (r32^p - 1)/(r21^p - 1); nan where not monotone and decreasing."""
    d21, d32 = medium - fine, coarse - medium
    if d21 * d32 <= 0 or d32 / d21 <= np.log(r32) / np.log(r21):
        return np.nan

    def excess(p):
        return r21**p * np.expm1(p * np.log(r32)) / np.expm1(p * np.log(r21)) - d32 / d21

    low, high = 1e-9, 20.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if excess(middle) > 0 else (middle, high)
    return (low + high) / 2


def band(times, curves, cells, formal=2.0):
    """Half width of the band about the first of three curves [(t, v), ...] at `times`, and the order it is for.

    The order is that of the curves' means over `times`, limited to 0.5 .. formal for the band; where these do not
    converge monotonically the order is nan and the band is three times the spread of the grids at each time.
    """
    fine, medium, coarse = (np.interp(times, t, v) for t, v in curves)
    r21, r32 = cells[1] / cells[0], cells[2] / cells[1]
    if not (r21 > 1 and r32 > 1):
        raise ValueError("the grids must be given from fine to coarse")
    order = observed_order(fine.mean(), medium.mean(), coarse.mean(), r21, r32)
    if np.isnan(order):
        return 3 * np.ptp([fine, medium, coarse], axis=0), order
    used = np.clip(order, 0.5, formal)
    return SAFETY * np.abs(medium - fine) / (r21**used - 1), order


def draw_band(axes, cells, curves, colour, what, unit=1.0):
    """Draws the band about the first of three curves [(t, v), ...], times in `unit`; what to say of it [m/s]."""
    if not cells[0] < cells[1] < cells[2]:
        return f"{what}: no band, the runs are not of three grids from fine to coarse"
    times = np.linspace(max(t[0] for t, _ in curves), min(t[-1] for t, _ in curves), 400)
    width, order = band(times, curves, cells)
    fine = np.interp(times, *curves[0])
    axes.fill_between(times / unit, fine - width, fine + width, color=colour, alpha=0.15, lw=0)
    if np.isnan(order):
        return f"{what}: no order, the grids' differences do not fall; band is 3 times their spread"
    return f"{what}: observed order {order:.2f}, GCI {width[-1]:.3g} m/s at the end"
