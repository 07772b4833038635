"""Error against CPU time: one panel a problem, with the reference error and the extrapolation of Godunov's curve.

usage: work-precision-1d.py study.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STYLES = {"godunov": ("tab:gray", "Godunov", "s"), "linear": ("tab:blue", "linear, graded switch", "o"),
          "parabolic": ("tab:red", "parabolic", "D"), "muscl": ("tab:green", "MUSCL van Leer", "^")}


def columns(table):
    return {name: data.asstr()[:] if h5py.check_string_dtype(data.dtype) else data[:] for name, data in table.items()}


def panel(axis, curves, ratios, k):
    problem, eos, target = ratios["problem"][k], ratios["eos"][k], ratios["error"][k]
    here = (curves["problem"] == problem) & (curves["eos"] == eos)
    for scheme, (colour, label, marker) in STYLES.items():
        rows = here & (curves["scheme"] == scheme)
        time, error, spread = (curves[c][rows] for c in ("cpu", "density_l1", "spread"))
        axis.errorbar(error, time, yerr=[np.zeros_like(time), time * np.expm1(spread)], color=colour, marker=marker,
                      ms=3, lw=1, capsize=2, label=label)
        if scheme == "godunov" and error.min() > target:
            line = np.polyfit(np.log(error[-4:]), np.log(time[-4:]), 1)
            ends = np.array([error[-1], target])
            axis.plot(ends, np.exp(np.polyval(line, np.log(ends))), ":", color=colour,
                      label="extrapolated")
    axis.axvline(target, color="k", lw=0.6, ls="--")
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.grid(alpha=0.25)
    axis.set_title(f"{problem}, {eos}:  G/L {ratios['godunov_over_linear'][k]:.3g},  "
                   f"G/P {ratios['godunov_over_parabolic'][k]:.3g},  M/P {ratios['muscl_over_parabolic'][k]:.3g}",
                   fontsize=7.5)
    axis.tick_params(labelsize=7)


def main():
    source, out = sys.argv[1], sys.argv[-1]
    with h5py.File(source) as study:
        curves, ratios = columns(study["curves"]), columns(study["ratios"])
    count = len(ratios["problem"])
    figure, axes = plt.subplots(-(-count // 3), 3, figsize=(11, 2.6 * -(-count // 3)), constrained_layout=True)
    for k, axis in enumerate(axes.flat):
        if k < count:
            panel(axis, curves, ratios, k)
        else:
            axis.set_axis_off()
    for axis in axes[-1]:
        axis.set_xlabel("L1 error of density [kg/m$^3$]", fontsize=8)
    for axis in axes[:, 0]:
        axis.set_ylabel("CPU time [s]", fontsize=8)
    axes[0, 0].legend(loc="upper left", fontsize=6, framealpha=0.6)
    figure.suptitle("To the same error the modified schemes take a small share of Godunov's time\n"
                    "dashed: error of M on 320 (smooth) or 400 cells, at which times are compared; bars: repeatability\n"
                    "ratios of times there, of G Godunov, L linear, P parabolic, M van Leer", fontsize=12)
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
