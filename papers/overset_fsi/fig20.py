"""Residual shape of the tetrahedron, in section and from both sides.

usage: fig20.py RUN.h5 OUT.png
"""
# needs: tetrahedron --set variant=[]
import _residual

if __name__ == "__main__":
    _residual.draw("tetrahedron")
