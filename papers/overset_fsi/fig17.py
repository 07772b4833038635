"""Residual shape of the cube on the axis, in section and from both sides.

usage: fig17.py RUN.h5 OUT.png
"""
# needs: three-cubes
import _residual

if __name__ == "__main__":
    _residual.draw("cube on the axis")
