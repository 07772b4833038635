"""Zone of influence on the state at a face of gas: where its characteristics start.

usage: fig02.py RUN.h5 OUT.png; on the axis through the charge, the face along z with the fastest waves. The steps of a
run go by the waves in steel: drawn is one that the gas alone would allow
"""
# needs: three-cubes
import _characteristics
import numpy as np
from _paper import CM, US, arguments, plt, save, si

COURANT = 0.8


def sound_speed(eos, rho, p):
    """Of products after Jones, Wilkins and Lee [m/s]."""
    v = si(eos["rho0"]) / rho
    a, b = (si(eos[k]) * np.exp(-eos[r] * v) for k, r in (("A", "R1"), ("B", "R2")))
    return np.sqrt(((eos["R1"] * a + eos["R2"] * b) * v + (1 + eos["omega"]) * (p - a - b)) / rho)


def main():
    runs, out = arguments()
    run = runs[0]
    state = run.near(13 * US)
    i, j = (int(np.argmin(np.abs(0.5 * (nodes[:-1] + nodes[1:])))) for nodes in state.nodes[:2])
    rho, w, p = (state.gas(name)[:, j, i] for name in ("density", "velocity_z", "pressure"))
    rho, w, p = (0.5 * (q[:-1] + q[1:]) for q in (rho, w, p))
    c = sound_speed(run.material("products")["eos"], rho, p)
    k = int(np.nanargmax(np.abs(w) + c))
    w, c = float(w[k]), float(c[k])
    dt, own = COURANT * run.cell / (abs(w) + c), float(np.interp(state.time, run.history("time"), run.history("dt")))
    figure, axes = plt.subplots(figsize=(8, 5), constrained_layout=True)
    _characteristics.draw(axes, run.cell, dt, {
        "u + c": (w + c, "tab:blue"), "u, three times": (w, "tab:green"), "u - c": (w - c, "tab:red")})
    axes.set_title(f"A face of the gas on the axis at z = {state.nodes[2][k + 1] / CM:.3g} cm: "
                   f"u = {w:.4g}, c = {c:.4g} m/s; "
                   f"step {dt / US:.2g} us, the run's {own / US:.2g} us\n{run.label(state)}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
