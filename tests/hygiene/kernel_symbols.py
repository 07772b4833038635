#!/usr/bin/env python3
"""No symbol of a wide instruction set can be linked into another: the weak symbols that kernel objects of different
instruction sets share must be none, for the linker keeps one copy of each and may keep the widest.

usage: kernel_symbols.py SOURCE_DIR BUILD_DIR
"""
import collections
import pathlib
import re
import subprocess
import sys

build = pathlib.Path(sys.argv[2])
holders = collections.defaultdict(set)
objects = 0
for folder in sorted((build / "CMakeFiles").glob("g27_*.dir")):
    isa = re.search(r"_(x86_64|x86_64_v3|x86_64_v4|baseline)\.dir$", folder.name)
    for path in folder.glob("scheme/kernel/*_kernel.cpp.o") if isa else ():
        objects += 1
        out = subprocess.run(["nm", "--defined-only", "-C", path], capture_output=True, text=True, check=True).stdout
        for line in out.splitlines():
            kind, _, name = line[17:].partition(" ")
            if kind in "WVu":
                holders[name].add(isa[1])
shared = sorted(name for name, isas in holders.items() if len(isas) > 1)
if objects < 2:
    print(f"{objects} kernel objects in the build folder")
    sys.exit(1)
print("\n".join(f"shared by {', '.join(sorted(holders[n]))}: {n}" for n in shared) or
      f"{objects} kernel objects share no weak symbol")
sys.exit(bool(shared))
