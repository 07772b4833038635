"""Runs the script of a figure; where its results do not hold what it draws, one line says so.

usage: _run.py SCRIPT.py [RESULTS.h5 ...] OUT
"""
import pathlib
import runpy
import sys
import traceback

sys.argv = sys.argv[1:]
script, *sources, out = sys.argv
folder = pathlib.Path(script).parent
sys.path[0] = str(folder)
try:
    runpy.run_path(script, run_name="__main__")
except Exception as error:
    trace = traceback.extract_tb(error.__traceback__)
    lines = [f"{pathlib.Path(at.filename).name}:{at.lineno}" for at in trace if pathlib.Path(at.filename).parent == folder]
    sys.exit(f"{pathlib.Path(script).stem}: cannot be drawn from {' '.join(sources)}: {type(error).__name__}: "
             f"{' '.join(str(error).split())} ({lines[-1] if lines else 'read'})")
