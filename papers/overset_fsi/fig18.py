"""Velocity of the centres of the near and the far face of the cube on the axis against time.

usage: fig18.py RUN.h5 [RUN.h5 ...] OUT.png; three grids carry a band of their convergence (GCI)
"""
# needs: three-cubes
import _gci
import numpy as np
from _paper import US, arguments, plt, save

COLOURS = {"near face": "tab:red", "far face": "tab:blue"}
STYLES = ("-", "--", ":")


def curve(run, probe):
    return run.history("time"), run.history(f"probe/{probe}/velocity_z")


def main():
    runs, out = arguments()
    figure, axes = plt.subplots(figsize=(8, 5), constrained_layout=True)
    probes = [name for name in COLOURS if runs[0].has(f"probe/{name}")]
    if not probes:
        raise SystemExit("fig18: the runs have no probes 'near face' and 'far face'")
    said = []
    for probe in probes:
        for run, style in zip(runs[:3], STYLES):
            time, velocity = curve(run, probe)
            axes.plot(time / US, velocity, style, color=COLOURS[probe], lw=1.3,
                      label=f"{probe}, cells {run.cell * 1e3:.3g} mm")
            print(f"{probe}, cells {run.cell * 1e3:.3g} mm: {np.nanmax(velocity):.1f} m/s at most, "
                  f"{velocity[-1]:.1f} m/s at {time[-1] / US:.3g} us")
        if len(runs) >= 3:
            said.append(_gci.draw_band(axes, [run.cell for run in runs[:3]], [curve(run, probe) for run in runs[:3]],
                                       COLOURS[probe], probe, US))
    for line in said:
        print(line)
    axes.set_xlabel("t [us]")
    axes.set_ylabel("velocity along the axis [m/s]")
    axes.grid(alpha=0.3)
    axes.legend()
    axes.set_title("\n".join(["Faces of the cube on the axis (means over each face)", runs[0].label(), *said]),
                   fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
