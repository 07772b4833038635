"""Zone of influence on the state at a face of gas: where its characteristics start.

usage: fig02.py RUN.h5 OUT.png; the face of the run's last state with the steepest pressure
"""
# needs: sod --set scheme.order=2
import sys
import tomllib

import _characteristics
import h5py
import numpy as np
from _paper import plt, save, text


def main():
    source, out = sys.argv[1], sys.argv[-1]
    with h5py.File(source) as file:
        gas = tomllib.loads(text(file["provenance/scene"][()]))["material"]["gas"]["eos"]
        state = file["state"][sorted(file["state"])[-1]]
        x, rho, u, p = (state[name][:] for name in ("faces", "density", "velocity", "pressure"))
        dt, scene = file["history/dt"][-2], text(file["run"].attrs["scene"])  # the last step was cut to the end
    c = np.sqrt(gas["gamma"] * p / rho)
    i = _characteristics.steepest(p)
    u, c = (0.5 * (q[i] + q[i + 1]) for q in (u, c))
    figure, axes = plt.subplots(figsize=(8, 5), constrained_layout=True)
    _characteristics.draw(axes, x[1] - x[0], dt, {"u + c": (u + c, "tab:blue"), "u": (u, "tab:green"),
                                                  "u - c": (u - c, "tab:red")})
    axes.set_title(f"{scene}: the face at x = {x[i + 1]:.3g} m, u = {u:.3g} m/s, c = {c:.3g} m/s", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
