"""Density of the gas at the end.

usage: fig14.py RUN.h5 OUT.png
"""
# needs: three-cubes
import _density
from _paper import arguments


def main():
    runs, out = arguments()
    _density.draw(runs[0], runs[0].states[-1], out, "Density at the end")


if __name__ == "__main__":
    main()
