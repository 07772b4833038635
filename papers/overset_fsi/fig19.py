"""Residual shape of the cylinder, in section and from both sides.

usage: fig19.py RUN.h5 OUT.png
"""
# needs: cylinder
import _residual

if __name__ == "__main__":
    _residual.draw("cylinder")
