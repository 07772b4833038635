#!/usr/bin/env python3
"""Every numbered equation of a paper is accounted for, and what its entry names is in the code.

usage: papers.py SOURCE_DIR [BUILD_DIR]
"""
import pathlib
import re
import sys
import tomllib

root = pathlib.Path(sys.argv[1])
folder = root / "papers" / "overset_fsi"
NUMBERED = {2: 5, 3: 11, 4: 12}  # equations of the sections
problems, seen = [], set()
misprints = (folder / "misprints.md").read_text()
entries = tomllib.loads((folder / "equations.toml").read_text())["equation"]
for entry in entries:
    name = ", ".join(entry.get("number", [])) or "an entry"
    for key in ("number", "what", "used", "where", "status"):
        if not entry.get(key):
            problems.append(f"{name}: no {key}")
    if entry.get("status") not in {"used", "corrected", "ablation"}:
        problems.append(f"{name}: status {entry.get('status')}")
    for number in entry["number"]:
        if number.startswith("section "):
            continue
        first, _, last = number.partition("-")
        section, low = map(int, first.split("."))
        high = int((last or first).split(".")[1])
        seen |= {(section, n) for n in range(low, high + 1)}
    for place in entry["where"]:
        path, _, symbol = place.partition(": ")
        file = root / path
        if not file.is_file():
            problems.append(f"{name}: no file {path}")
        elif not symbol or not re.search(rf"\b{re.escape(symbol)}\b", file.read_text()):
            problems.append(f"{name}: no {symbol or 'symbol'} in {path}")
wanted = {(s, n) for s, count in NUMBERED.items() for n in range(1, count + 1)}
problems += [f"equation {s}.{n} is missing" for s, n in sorted(wanted - seen)]
problems += [f"equation {s}.{n} is not in the paper" for s, n in sorted(seen - wanted)]
if len(misprints) < 1000:
    problems.append("misprints.md is empty")
tomllib.loads((folder / "parameters.toml").read_text())
print("\n".join(problems) or f"{len(entries)} entries, {len(seen)} equations")
sys.exit(bool(problems))
