"""Zone of influence on the state at a face of a solid: where its characteristics start.

usage: fig04.py RUN.h5 OUT.png; in the body's grid, the face along z with the steepest pressure
"""
# needs: three-cubes
import _characteristics
import numpy as np
from _paper import US, arguments, plt, save, si


def main():
    runs, out = arguments()
    run = runs[0]
    state = run.near(8 * US)
    body = state.body("top")
    steel = run.material("steel")
    K, mu = si(steel["eos"]["K"]), si(steel["strength"]["shear"])
    p, rho, w = (body.field(name) for name in ("pressure", "density", "velocity_z"))
    k, j, i = np.unravel_index(np.nanargmax(np.abs(np.diff(p, axis=0))), np.diff(p, axis=0).shape)
    rho, w = (0.5 * (q[k, j, i] + q[k + 1, j, i]) for q in (rho, w))
    a, beta = np.sqrt((K + 4 / 3 * mu) / rho), np.sqrt(mu / rho)
    dt = float(np.interp(state.time, run.history("time"), run.history("dt")))
    figure, axes = plt.subplots(figsize=(8, 5), constrained_layout=True)
    _characteristics.draw(axes, body.cell, dt, {
        "u + a": (w + a, "tab:blue"), "u + beta, twice": (w + beta, "tab:cyan"), "u, five times": (w, "tab:green"),
        "u - beta, twice": (w - beta, "tab:orange"), "u - a": (w - a, "tab:red")})
    axes.set_title(f"A face of the body '{body.name}': u = {w:.3g}, a = {a:.4g}, beta = {beta:.4g} m/s\n"
                   f"{run.label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
