#!/usr/bin/env python3
"""Includes go one way, and headers of riemann/, scheme/ and fsi/ stay light.

usage: includes.py SOURCE_DIR [BUILD_DIR]
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
LAYERS = ["riemann", "scheme", "fsi", "verification", "studies"]
# What an exact solution may see of the code that it judges.
EXACT_MAY_SEE = {"riemann/base/lane.hpp", "riemann/base/lane_math.hpp", "riemann/state/gas.hpp",
                 "riemann/state/solid_point.hpp"}
LIGHT = {"algorithm", "array", "bit", "cassert", "cmath", "concepts", "cstddef", "cstdint", "experimental/simd",
         "functional", "limits", "map", "memory", "new", "numbers", "optional", "span", "stdexcept", "string", "string_view", "tuple",
         "type_traits", "utility", "variant", "vector"}

problems = []
count = 0
for layer in LAYERS:
    for path in sorted((root / layer).rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        count += 1
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
            if not match:
                continue
            kind, target = match.groups()
            where = f"{name}:{number}: includes {target}"
            if kind == '"':
                above = target.split("/")[0]
                if above not in LAYERS or not (root / target).exists():
                    problems.append(f"{where}: not a path from the source folder")
                elif LAYERS.index(above) > LAYERS.index(layer):
                    problems.append(f"{where}: upwards, from {layer} to {above}")
                elif name.startswith("verification/exact/") and above != "verification" and \
                        target not in EXACT_MAY_SEE:
                    problems.append(f"{where}: an exact solution must not see the solvers")
            elif name.endswith(".hpp") and layer in ("riemann", "scheme", "fsi") and target not in LIGHT:
                problems.append(f"{where}: too heavy for a header of {layer}")

if count < 20:
    problems.append(f"only {count} files found: is this the source folder?")
print("\n".join(problems) or f"{count} files, all includes in order")
sys.exit(bool(problems))
