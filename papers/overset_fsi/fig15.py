"""Density of the gas at the beginning of the interaction: section, and close to the cube on the axis.

usage: fig15.py RUN.h5 OUT.png
"""
# needs: three-cubes
import _density
from _paper import US, arguments


def main():
    runs, out = arguments()
    _density.draw(runs[0], runs[0].near(8 * US), out, "Density at the beginning of the interaction", close=True)


if __name__ == "__main__":
    main()
