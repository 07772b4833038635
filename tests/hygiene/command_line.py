#!/usr/bin/env python3
"""The program's contract with scripts: exit status, and JSON alone on stdout.

usage: command_line.py SOURCE_DIR BUILD_DIR
"""
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

program = pathlib.Path(sys.argv[2]) / "g27"
problems = []


def run(*arguments, status=0, stdout=None):
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    if done.returncode != status:
        problems.append(f"g27 {' '.join(map(str, arguments))}: status {done.returncode}, not {status}: {done.stderr}")
    return done


def run_json(*arguments, status=0):
    done = run(*arguments, "--json", status=status)
    try:
        return json.loads(done.stdout)
    except ValueError as error:
        problems.append(f"g27 {' '.join(map(str, arguments))} --json: {error}: {done.stdout[:200]!r}")
        return {}


run("--help")
run("--version")
if "read a scene and say" not in run(status=2).stderr:
    problems.append("g27 alone does not list its commands")
for wrong in (["rnu"], ["run", "no-such-scene"], ["case", "no-such-case"], ["study", "no-such-study"],
              ["exact", "no-such-solution"], ["figure", "no-such-figure"], ["bench", "no-such-benchmark"],
              ["list", "no-such-kind"], ["run", "sod", "--set", "domain.cels=3"], ["run", "--threads", "0"],
              ["case", "sod", "--cure", "on"], ["case", "noh-2d", "--feet", "conservative"],
              ["case", "wedge-2d", "--set", "angle_deg=60"], ["case", "wedge-2d", "--set", "angel=10"],
              ["case", "forward-step", "--cells", "8"], ["case", "sedov-2d", "--set", "source_cells=1.5"],
              ["case", "sedov-2d", "--set", "source_cells=31"], ["case", "be-shell", "--set", "u0=10"],
              ["case", "solid-step-1d", "--set", "normal=0", "--set", "shear=0"],
              ["case", "be-shell", "--set", "u0=600 kg"], ["exact", "sedov", "t=1 kg"],
              ["case", "no-such-case", "--help"], ["exact", "no-such-solution", "--help"], ["case", "vortex-2d", "--mesh", "random"],
              ["check"], ["run", "sod", "--no-such-option"], ["exact", "riemann", "nonsense"]):
    done = run(*wrong, status=2)
    if done.stdout:
        problems.append(f"g27 {' '.join(wrong)} prints on stdout: {done.stdout[:80]!r}")
    if not done.stderr.strip():
        problems.append(f"g27 {' '.join(wrong)} says nothing")
    if wrong[0] != "figure" and not run_json(*wrong, status=2).get("error", {}).get("problem"):
        problems.append(f"g27 {' '.join(wrong)} --json has no error")

for arguments, hint in ((["frob"], "known: run, check"), (["exact", "jwl-card", "rho0=1.65"], "1000 kg/m^3"),
                        (["stl", "--make", "sphere"], "needs radius (of its surface)")):
    said = run(*arguments, status=2).stderr
    if hint not in said:
        problems.append(f"g27 {' '.join(arguments)} does not say '{hint}': {said}")

everything = run_json("list")
if set(everything) != {"scenes", "cases", "studies", "exact", "eos", "schemes", "figures", "benchmarks"}:
    problems.append(f"g27 list --json has the keys {sorted(everything)}")
for scene in everything.get("scenes", []):
    run_json("check", scene["name"])

if run_json("exact", "sedov", "t=2 ms").get("shock") != run_json("exact", "sedov", "t=0.002").get("shock"):
    problems.append("g27 exact sedov t='2 ms' is not t=0.002")

# A line and a grid report the same things.
line = run_json("case", "sod", "--cells", "40")
grid = run_json("case", "carbuncle-2d", "--cells", "20", "--set", "steps=5", "--set", "mach=5", "--transverse",
                "averaged", "--cure", "off", "--skip", "off", "--threads", "2", "--tile", "8", "8", "1")
keys = {"case", "dimensions", "cells", "order", "switch", "steps", "cpu_s", "wall_s", "cell_updates_per_s", "errors",
        "switch_fraction", "fallbacks", "ledger", "cells_skipped", "facts"}
if not keys <= set(line) or set(line) != set(grid):
    problems.append(f"g27 case --json: a line has {sorted(line)}, a grid {sorted(grid)}, expected {sorted(keys)}")
if grid.get("dimensions") != 2 or grid.get("steps") != 5 or grid.get("fallbacks", {}).get("cured") != 0:
    problems.append(f"g27 case carbuncle-2d does not do as it is told: {grid}")

with tempfile.TemporaryDirectory() as folder:
    result = run_json("run", "sod", "--out", folder, "--no-figures")
    if not result.get("holds") or len(result.get("runs", [])) != 3:
        problems.append("g27 run sod does not hold")
    produced = {path.name for path in pathlib.Path(folder).iterdir()}
    for name in ("main-linear.h5", "main-linear.xdmf", "summary.json", "runs.csv", "verdict.csv"):
        if name not in produced:
            problems.append(f"g27 run sod wrote no {name}")
    # XDMF: every grid's data items name data sets of the file beside it, as long as they say.
    items = [item.text.strip() for item in
             xml.etree.ElementTree.parse(pathlib.Path(folder) / "main-linear.xdmf").iter("DataItem")
             if item.get("Format") == "HDF"]
    if len(items) < 8 or not all(item.startswith("main-linear.h5:/state/") for item in items):
        problems.append(f"the XDMF file refers to {items}")
    # A grid: a state a file, beside a table of what was left out.
    plane = run_json("run", "shock-tube-2d", "--out", folder, "--no-figures", "--set", "skip=off")
    if not plane.get("holds") or "factor" not in plane.get("runs", [{}])[0].get("saved", {}):
        problems.append("g27 run shock-tube-2d does not hold, or does not tell what it left out")
    items = [item.text.strip() for item in
             xml.etree.ElementTree.parse(pathlib.Path(folder) / "main-linear.xdmf").iter("DataItem")
             if item.get("Format") == "HDF"]
    if len(items) != 8 or not all((pathlib.Path(folder) / item.split(":")[0]).is_file() for item in items):
        problems.append(f"the XDMF file of a grid refers to {items}")
    run("run", "sod", "--out", folder, "--no-figures")
    if (pathlib.Path(folder) / "main-linear.state").exists() or (pathlib.Path(folder) / "earlier").exists():
        problems.append("a run leaves the results of an earlier one")
    # A claim that fails: status 1. The pressure at a tenth of the time is not the star pressure.
    failing = run_json("run", "sod", "--out", folder, "--no-figures", "--set", "expect.0.time=0.01 s", status=1)
    if failing.get("holds") is not False:
        problems.append("a wrong expectation holds")
    # No place to write to: a slip of the user's, and the reason.
    done = run("run", "sod", "--out", "/dev/null/x", "--no-figures", status=2)
    if "cannot create" not in done.stderr:
        problems.append(f"an impossible folder gives: {done.stderr}")
    # Surfaces: healthy 0, faulty 1, repaired 0, unreadable or mistaken 2.
    cube, holed, sound, fine = (pathlib.Path(folder) / f"{n}.stl" for n in ("cube", "holed", "sound", "fine"))
    made = run_json("stl", "--make", "cube", "--set", "side=1 cm", "--set", "edge=2 mm", "--unit", "cm", "--out", cube)
    if not made.get("healthy") or abs(made.get("volume", 0) / 1e-6 - 1) > 1e-6:
        problems.append(f"g27 stl --make cube gives {made}")
    looked = run_json("stl", cube, "--unit", "cm", "--density", "7.8 g/cm3", "--cell", "2 mm")
    if abs(looked.get("mass", 0) / 7.8e-3 - 1) > 1e-6 or looked.get("cell", {}).get("share_usable") != 1:
        problems.append(f"g27 stl of a cube gives {looked}")
    content = cube.read_bytes()
    count = int.from_bytes(content[80:84], "little")
    holed.write_bytes(content[:80] + (count - 1).to_bytes(4, "little") + content[84:-50])
    faulty = run_json("stl", holed, status=1)
    if [f["fault"] for f in faulty.get("faults", [])] != ["open edges"] or not faulty["faults"][0]["triangles"]:
        problems.append(f"g27 stl of a cube with a hole gives {faulty}")
    repaired = run_json("stl", holed, "--unit", "cm", "--repair", sound, "--remesh", "1 mm", "--out", fine)
    if not repaired.get("healthy") or not repaired.get("repaired") or not sound.exists() or not fine.exists():
        problems.append(f"g27 stl --repair gives {repaired}")
    for wrong in ([holed.with_name("none.stl")], [cube, "--unit", "kg"], [cube, "--cell", "-1 mm"],
                  ["--make", "cub"], ["--make", "cube", "--set", "side=1 cm"], [cube, "--out", fine]):
        run("stl", *wrong, status=2)
    nowhere = pathlib.Path(folder) / "nowhere" / "x.stl"
    if str(nowhere) not in run("stl", cube, "--unit", "cm", "--remesh", "1 mm", "--out", nowhere, status=2).stderr:
        problems.append("g27 stl does not name the file that it cannot write")
    holed.write_bytes(content[:500])
    if "truncated" not in run("stl", holed, status=2).stderr:
        problems.append("g27 stl of a truncated file does not say so")
    # A run that cannot go on, the piston reaching the wall: status 1 and a capsule.
    squeeze = pathlib.Path(folder) / "squeeze.toml"
    squeeze.write_text("""title = "squeezed"
time = { end = "3 ms" }
material.gas.eos = { type = "ideal", gamma = 1.4 }
region = [{ extent = ["0 m", "1 m"], density = "1 kg/m3", pressure = "1 bar" }]
[domain]
extent = ["0 m", "1 m"]
cells = 8
motion = "stretched"
boundary = { left = { type = "piston", velocity = "1 km/s" }, right = "wall" }
""")
    done = run("run", squeeze, "--out", folder, "--no-figures", status=1)
    kept = pathlib.Path(folder) / "earlier"
    if not (kept / "main-parabolic.h5").exists() or str(kept) not in done.stderr:
        problems.append("a run that fails does not keep the results before it, or does not say where")
    if (pathlib.Path(folder) / "runs.csv").exists():
        problems.append("a failed run leaves an empty table")
    capsule = pathlib.Path(folder) / "main-linear.failure.json"
    if not capsule.exists() or "stencil" not in json.loads(capsule.read_text()):
        problems.append("a failed run leaves no capsule")

with tempfile.TemporaryDirectory() as folder:
    # Ctrl-C: a checkpoint, status 130, and the command that goes on.
    running = subprocess.Popen([program, "run", "sod", "--set", "domain.cells=8000", "--set", "expect=[]", "--no-figures",
                                "--out", folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    running.stderr.readline()
    time.sleep(0.5)
    if "another process" not in run("run", "sod", "--out", folder, "--no-figures", status=2).stderr:
        problems.append("two runs write into one folder")
    running.send_signal(signal.SIGINT)
    said = running.communicate()[1]
    command = re.search(r"to continue: g27 (.*)", said)
    if running.returncode != 130 or not command:
        problems.append(f"Ctrl-C gives the status {running.returncode} and says {said}")
    else:
        checkpoint = pathlib.Path(folder) / "main-linear.h5"
        sound = checkpoint.read_bytes()
        checkpoint.write_bytes(sound[:-1])
        done = run(*shlex.split(command.group(1)), status=2)
        if "main-linear.h5" not in done.stderr or "without --resume" not in done.stderr:
            problems.append(f"a damaged checkpoint gives: {done.stderr}")
        checkpoint.write_bytes(sound)
        run(*shlex.split(command.group(1)), "--no-figures")

# A case that a signal stops: an object all the same.
running = subprocess.Popen([program, "case", "sedov-3d", "--cells", "200", "--json"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True)
time.sleep(0.5)
running.send_signal(signal.SIGTERM)
said = running.communicate()[0]
if running.returncode != 143 or json.loads(said or "{}").get("error", {}).get("problem") != "interrupted":
    problems.append(f"a case that SIGTERM stops ends with {running.returncode} and prints {said!r}")

# Figures of results that are none, or of something else: one reason, no traceback.
with tempfile.TemporaryDirectory() as folder:
    run("run", "sod", "--out", folder, "--no-figures")
    text = pathlib.Path(folder) / "text.h5"
    text.write_text("no HDF5")
    for name in ("detonation", "scene-bodies", "fig18"):
        for source, reason in ((text, "no HDF5 file"), (folder, "was not drawn from")):
            said = run("figure", name, "--from", source, "--out", folder, status=2).stderr
            if reason not in said or "Traceback" in said:
                problems.append(f"figure {name} --from {source} says {said}")

# The launcher answers at once where nothing needs to be built.
launcher = pathlib.Path(sys.argv[1]) / "g27"
said = subprocess.run([launcher, "test", "--help"], capture_output=True, text=True)
if said.returncode != 0 or "usage: ./g27 test" not in said.stdout or said.stderr:
    problems.append(f"./g27 test --help says {said}")
presets = json.loads((launcher.parent / "CMakePresets.json").read_text())["buildPresets"]
said = subprocess.run([launcher, "list"], capture_output=True, text=True, env=os.environ | {"G27_PRESET": "no-such"})
if said.returncode != 2 or not all(preset["name"] in said.stderr for preset in presets):
    problems.append(f"G27_PRESET=no-such gives {said}")

print("\n".join(problems) or "command line in order")
sys.exit(bool(problems))
