#!/usr/bin/env python3
"""No symbol of a wide instruction set can be linked into another: the weak symbols that kernel objects of different
instruction sets share must be none, for the linker keeps one copy of each and may keep the widest.

usage: kernel_symbols.py SOURCE_DIR BUILD_DIR
"""
import collections
import pathlib
import subprocess
import sys

build = pathlib.Path(sys.argv[2])
holders = collections.defaultdict(set)
objects = 0
for folder in sorted((build / "CMakeFiles").glob("g27_kernel_*.dir")):
    isa = folder.name[len("g27_kernel_"):-len(".dir")]
    for path in folder.rglob("*.o"):
        objects += 1
        out = subprocess.run(["nm", "--defined-only", "-C", path], capture_output=True, text=True, check=True).stdout
        for line in out.splitlines():
            kind, _, name = line[17:].partition(" ")
            if kind in "WVu":
                holders[name].add(isa)
shared = sorted(name for name, isas in holders.items() if len(isas) > 1)
if objects == 0:
    print("no kernel objects in the build folder")
    sys.exit(1)
print("\n".join(f"shared by {', '.join(sorted(holders[n]))}: {n}" for n in shared) or
      f"{objects} kernel objects share no weak symbol")
sys.exit(bool(shared))
