#!/usr/bin/env python3
"""Every command, file and scene that the README names exists, and its scene is one that the program accepts.

usage: readme.py SOURCE_DIR BUILD_DIR
"""
import pathlib
import re
import subprocess
import sys
import tempfile

root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
text = (root / "README.md").read_text()
program = build / "g27"
problems = []

lines = text.splitlines()
if not (lines[1].startswith("./g27 run") and lines[2].startswith("./g27 test")):
    problems.append("the README does not open with ./g27 run and ./g27 test")

for command in sorted(set(re.findall(r"\./g27 ([a-z]+)", text))):
    done = subprocess.run([program, command, "--help"], capture_output=True, text=True)
    if done.returncode != 0:
        problems.append(f"g27 {command} does not exist")
documented = set(re.findall(r"`\./g27 ([a-z]+)", text))
listed = set(re.findall(r"^  ([a-z]+) {2,}", subprocess.run([program, "--help"], capture_output=True,
                                                          text=True).stdout.split("Subcommands:")[1], re.M))
problems += [f"g27 {command} is not in the README" for command in sorted(listed - documented)]

for option in sorted(set(re.findall(r"`(--[a-z]+)", text))):
    if not any(option in subprocess.run([program, c, "--help"], capture_output=True, text=True).stdout
               for c in listed):
        problems.append(f"no command has the option {option}")
for path in sorted(set(re.findall(r"`((?:riemann|scheme|fsi|verification|studies|tests)(?:/[a-z_.]+)*)`", text))):
    if not (root / path).exists():
        problems.append(f"{path} does not exist")
for name in ("three-cubes-quick",):
    if name not in text or not (root / f"studies/scenes/{name}.toml").exists():
        problems.append(f"scene {name} is missing")

scenes = re.findall(r"```toml\n(.*?)```", text, re.S)
with tempfile.TemporaryDirectory() as folder:
    for i, scene in enumerate(scenes):
        file = pathlib.Path(folder) / f"readme{i}.toml"
        file.write_text(scene)
        done = subprocess.run([program, "run", file, "--out", folder, "--no-figures"], capture_output=True, text=True)
        if done.returncode != 0:
            problems.append(f"the README's scene {i} ends with {done.returncode}: {done.stderr.strip()} {done.stdout}")
if not scenes:
    problems.append("the README shows no scene")
print("\n".join(problems) or "README in order")
sys.exit(bool(problems))
