#!/usr/bin/env python3
"""Counts the floating-point operations of a cell update, by scheme and law: the numbers of operations.hpp.

usage: count_operations.py BUILD_DIR [CELLS]      needs valgrind and objdump; x86-64

The target count_operations steps one grid of the benchmarks under callgrind, which counts how often every instruction
of the steps is executed; what an instruction does is read off its disassembly. Counted are additions, subtractions,
multiplications, divisions, square roots, minima and maxima of doubles, one a lane, fused multiply-adds two: as the
counters FP_ARITH_INST_RETIRED do (Intel, Software Developer's Manual, vol. 3B). Comparisons, selections and moves are
not.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ARITHMETIC = re.compile(r"^v?(add|sub|mul|div|sqrt|min|max|hadd|hsub|addsub)(pd|sd)$")
FUSED = re.compile(r"^vfn?m(add|sub|addsub|subadd)\d*(pd|sd)$")
SCHEMES = ("godunov", "modified", "parabolic", "muscl-hllc")
STEPS = ("g27::GasGrid::step(double)", "g27::SolidGrid::step(double)")


def operations_of(program):
    """Operations of the instruction at every address."""
    found = {}
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, capture_output=True, text=True)
    for line in text.stdout.splitlines():
        head, colon, rest = line.partition(":\t")
        words = rest.split()
        if not colon or not words:
            continue
        fused, plain = FUSED.match(words[0]), ARITHMETIC.match(words[0])
        if fused or plain:
            lanes = 1 if words[0].endswith("sd") else 8 if "%zmm" in rest else 4 if "%ymm" in rest else 2
            found[int(head, 16)] = lanes * (2 if fused else 1)
    return found


def executed(dump, program, of):
    total, here, skip = 0, False, False
    for line in dump.read_text().splitlines():
        if line.startswith("ob="):
            here = line.endswith(program.name)
        elif line.startswith("calls="):
            skip = True  # the next line is what the call costs as a whole
        elif line.startswith("0x"):
            if here and not skip:
                words = line.split()
                total += int(words[2]) * of.get(int(words[0], 16), 0)
            skip = False
    return total


def operations(program, of, kind, scheme, law, cells):
    """A cell and step."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "counts"
        done = subprocess.run(["valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-pos=no",
                               "--compress-strings=no", *[f"--toggle-collect={s}" for s in STEPS],
                               f"--callgrind-out-file={out}", program, kind, str(scheme), law, str(cells)],
                              check=True, capture_output=True, text=True)
        return executed(out, program, of) / int(done.stdout)


def main():
    build, cells = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 16
    subprocess.run(["cmake", "--build", build, "--target", "count_operations"], check=True)
    program = build / "count_operations"
    of = operations_of(program)
    for law in ("ideal", "jwl"):
        for k, scheme in enumerate(SCHEMES):
            print(f"gas {scheme} {law}: {operations(program, of, 'gas', k, law, cells):.0f}", flush=True)
    for law in ("linear", "mie-gruneisen"):
        for k, scheme in enumerate(SCHEMES[:3]):
            both = [operations(program, of, kind, k, law, cells) for kind in ("elastic", "yielding")]
            print(f"solid {scheme} {law}: elastic {both[0]:.0f}, yielding {both[1]:.0f}", flush=True)


main()
