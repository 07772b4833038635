"""CPU time saved by each skip of a charge's scene, and the difference it makes.

usage: blast-skips.py STUDY.h5 OUT.png
"""
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main():
    source, out = sys.argv[1:]
    with h5py.File(source, "r") as file:
        table = file["skips"]
        names, factor = table["left_out"].asstr()[:], table["factor"][:]
        difference, identical = table["difference"][:], table["identical"].asstr()[:]
    figure, axes = plt.subplots(figsize=(8, 4), constrained_layout=True)
    axes.barh(names, factor, color="C0")
    for row, (f, d, same) in enumerate(zip(factor, difference, identical)):
        note = "same bits" if same == "yes" else f"velocity {d:+.2g} %"
        axes.annotate(f" {f:.2f}, {note}", (f, row), va="center", fontsize=8)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.3 * max(factor))
    axes.set_xlabel("CPU time of leaving nothing out, over that of the run [1]")
    axes.set_title("left out of a scene with a cube beside a charge")
    figure.savefig(out, dpi=150)


if __name__ == "__main__":
    main()
