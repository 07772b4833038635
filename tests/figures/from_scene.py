#!/usr/bin/env python3
"""A figure of the paper computes its scene once, reuses it, computes it again for another, and stops without a trace.

usage: from_scene.py SOURCE_DIR BUILD_DIR
"""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

program = pathlib.Path(sys.argv[2]).resolve() / "g27"
QUICK = ["--scene", "three-cubes-quick", "--threads", "1", "--set", "time.end=6.62 us"]
problems = []


def check(what, holds):
    if not holds:
        problems.append(what)


with tempfile.TemporaryDirectory() as folder:
    def figure(*words, status=0):
        done = subprocess.run([program, "figure", *words], cwd=folder, capture_output=True, text=True)
        check(f"figure {' '.join(words)} ends with {done.returncode}: {done.stderr}", done.returncode == status)
        return done

    cache, pictures = pathlib.Path(folder) / "results/cache", pathlib.Path(folder) / "results/figures"
    check("a first figure does not compute", "computed in" in figure("fig18", *QUICK).stderr)
    for name in ("fig11", "fig16", "fig18"):
        check(f"{name} computes again", "reused from results/cache" in figure(name, *QUICK).stderr)
        png = pictures / f"{name}.png"
        check(f"{name} is no PNG", png.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n")
        check(f"{name} is too large", png.stat().st_size < 300_000)
    check("not one cache", len(list(cache.iterdir())) == 1)
    figure("fig18", *QUICK, "--set", "scheme.closure=false")
    check("another scene, no other cache", len(list(cache.iterdir())) == 2)
    figure("fig18", "--from", str(next(cache.iterdir())), "--out", "elsewhere")
    check("--out is not heeded", (pathlib.Path(folder) / "elsewhere/fig18.png").exists())
    figure("fig18", "--scene", "three-cubs-quick", status=2)
    figure("fig18", "--scene", "sod", status=2)
    figure("fig18", "--from", "nowhere", status=2)

    page = pathlib.Path(figure("gallery", *QUICK).stdout.splitlines()[-1])
    text = (pathlib.Path(folder) / page).read_text()
    check("the gallery has no figures", text.count("data:image/png;base64,") >= 3)
    check("the gallery needs other files", "<script" not in text and 'src="http' not in text)

    # Ctrl-C while a figure is drawn, after its run is found
    drawing = subprocess.Popen([program, "figure", "fig16", *QUICK], cwd=folder, stderr=subprocess.PIPE, text=True)
    seen = drawing.stderr.readline()
    time.sleep(0.3)
    drawing.send_signal(signal.SIGINT)
    rest = drawing.communicate()[1]
    check(f"Ctrl-C gives {drawing.returncode}: {seen} {rest}", drawing.returncode == 130)
    check(f"Ctrl-C gives a traceback: {rest}", "Traceback" not in rest)
    check("Ctrl-C leaves half a figure", not list(pictures.glob("*.part*")))
print("\n".join(problems) or "figures from scenes in order")
sys.exit(bool(problems))
