#!/usr/bin/python3
"""The figures' grid convergence finds order and limit of curves that are known.

usage: gci.py SOURCE_DIR BUILD_DIR
"""
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "papers/overset_fsi"))
import _gci

problems = []


def check(what, holds):
    if not holds:
        problems.append(what)


times = np.linspace(0, 1, 50)
exact = 3 + np.sin(times)
for order, cells in ((1.3, (1, 1.5, 2.4)), (2.0, (1, 2, 4)), (0.7, (0.7, 1, 1.4))):
    curves = [(times, exact + (0.05 + 0.02 * times) * h**order) for h in cells]
    width, found = _gci.band(times, curves, cells)
    check(f"order {order} found as {found}", abs(found - order) < 1e-6)
    error = np.abs(curves[0][1] - exact)
    check(f"order {order}: the band is not 1.25 times the error", np.allclose(width, 1.25 * error, rtol=1e-6))
up_and_down = [(times, exact + d) for d in (0, 0.1, -0.1)]
width, found = _gci.band(times, up_and_down, (1, 2, 4))
check("an oscillation has an order", np.isnan(found))
check("the band of an oscillation is not three times the spread", np.allclose(width, 0.6))
growing = [(times, exact + d) for d in (0, 0.1, 0.11)]
check("differences that grow with refinement have an order", np.isnan(_gci.band(times, growing, (1, 2, 4))[1]))
# above the formal order the band is that of the formal one
steep = [(times, exact + h**4) for h in (1, 2, 4)]
width, found = _gci.band(times, steep, (1, 2, 4))
check(f"order 4 found as {found}", abs(found - 4) < 1e-6)
check("the band of order 4 is too narrow", np.allclose(width, 1.25 * 15 / 3))
try:
    _gci.band(times, steep, (4, 2, 1))
    problems.append("grids from coarse to fine are taken")
except ValueError:
    pass
print("\n".join(problems) or "grid convergence in order")
sys.exit(bool(problems))
