#!/usr/bin/env python3
"""The sources are finished and speak of themselves alone.

usage: words.py SOURCE_DIR [BUILD_DIR]
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
# Spelled in pieces, so that this file passes its own test.
FORBIDDEN = {
    r"\b(TO" r"DO|FIX" r"ME|X" r"XX|HA" r"CK)\b": "unfinished work",
    r"/(wo" r"rk|tm" r"p|ho" r"me|ro" r"ot)/[a-z]": "a path of one machine",
    r"^\s*(//|#)\s*[-=*#/]{10,}": "a banner line",
    r"^(<{7}|>{7}|={7})( |$)": "a merge conflict",
}
TEXT = {".cpp", ".hpp", ".py", ".sh", ".toml", ".cmake", ".md", ".txt", ".json", ""}
problems = []
names = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
for name in filter(None, names):
    path = root / name
    if path.suffix not in TEXT or name == "LICENSE" or not path.is_file():
        continue
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        for pattern, what in FORBIDDEN.items():
            if re.search(pattern, line):
                problems.append(f"{name}:{number}: {what}: {line.strip()[:80]}")
    if path.suffix in {".cpp", ".hpp"} and len(path.read_text().splitlines()) > 900:
        problems.append(f"{name}: longer than 900 lines")
if len(names) < 50:
    problems.append(f"only {len(names)} files found")
print("\n".join(problems) or f"{len(names)} files checked")
sys.exit(bool(problems))
