"""Error against cell size in three dimensions: drawn as in two.

usage: order-3d.py STUDY.h5 OUT.png
"""
import pathlib
import runpy

runpy.run_path(str(pathlib.Path(__file__).with_name("order-2d.py")), run_name="__main__")
