"""One HTML page of all figures that are there, the tables of runs and studies, and where they come from.

usage: _gallery.py RESULTS_FOLDER PROGRAM [FIGURE.png ...] OUT.html
"""
import base64
import csv
import html
import json
import pathlib
import sys

import h5py

STYLE = """body { font: 15px/1.45 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222 }
img { max-width: 100%; border: 1px solid #ddd } table { border-collapse: collapse; margin: .6em 0 1.4em; font-size: 13px }
td, th { border: 1px solid #ccc; padding: .15em .5em; text-align: right } th { background: #f2f2f2 }
td:first-child { text-align: left } .fails { background: #fbdcdc } .holds { background: #e3f4e3 }
figure { margin: 1em 0 2em } div { overflow-x: auto } nav a { margin-right: 1em }"""


def number(text):
    try:
        return f"{float(text):.4g}"
    except (TypeError, ValueError):
        return str(text)


def table(head, rows):
    cells = "".join(f"<th>{html.escape(str(h))}</th>" for h in head)
    lines = []
    for row in rows:
        verdict = next((word for word in map(str, row) if word in ("holds", "FAILS")), "")
        lines.append(f'<tr class="{verdict.lower()}">'
                     + "".join(f"<td>{html.escape(number(v))}</td>" for v in row) + "</tr>")
    return f"<div><table><tr>{cells}</tr>{''.join(lines)}</table></div>"


def of_csv(path, most=60):
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    more = f"<p>first {most} of {len(rows) - 1} rows</p>" if len(rows) > most + 1 else ""
    return f"<h4>{html.escape(path.stem)}</h4>" + table(rows[0], rows[1:most + 1]) + more if rows else ""


def picture(path, title):
    data = base64.b64encode(path.read_bytes()).decode()
    return (f'<figure><img alt="{html.escape(title)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{html.escape(title)}</figcaption></figure>")


def title_of(name):
    """The first line of the docstring of the figure's script."""
    here = pathlib.Path(__file__).parent
    for script in (here / f"{name}.py", here.parents[1] / "papers/overset_fsi" / f"{name}.py"):
        if script.exists():
            return f"{name}: {script.read_text().splitlines()[0].strip(chr(34))}"
    return name


def provenance(folder):
    """Facts that the first of a folder's HDF5 files holds."""
    for path in sorted(folder.glob("*.h5")):
        with h5py.File(path, "r") as file:
            group = file.get("provenance", {})
            return {name: group[name].asstr()[()] for name in group if name not in ("scene", "identity")}
    return {}


def run_section(folder):
    summary = json.loads((folder / "summary.json").read_text())
    out = [f"<h3>{html.escape(summary.get('title', folder.name))}</h3>", f"<p>{html.escape(str(folder))}</p>"]
    cost = summary.get("cost", {})
    if cost:
        out.append(f"<p>last computed in {cost['wall_s']:.0f} s ({cost['cpu_s']:.0f} s of CPU), "
                   f"{cost['peak_bytes'] / 1e6:.0f} MB</p>")
    rows = [[run["name"], run.get("cells", ""), run.get("steps", ""), run.get("wall_s", ""), run.get("time_s", ""),
             run.get("failure") or ("complete" if run.get("complete") else "unfinished")] for run in summary["runs"]]
    out.append(table(["run", "cells", "steps", "wall [s]", "time [s]", "state"], rows))
    if summary.get("expect"):
        out.append(table(["quantity", "variant", "scheme", "expected", "tolerance", "measured", "verdict"],
                         [[e["quantity"], e["variant"], e["scheme"], e["expected"], e["tolerance"], e["measured"],
                           "shown" if not e["judged"] else "holds" if e["holds"] else "FAILS"]
                          for e in summary["expect"]]))
    out += [of_csv(path) for path in sorted(folder.glob("bodies.csv"))]
    facts = provenance(folder)
    if facts:
        out.append(table(["provenance", ""], facts.items()))
    out += [picture(path, path.stem) for path in sorted(folder.glob("*.png"))]
    return "".join(out)


def main():
    results, program, *figures, out = sys.argv[1:]
    results, figures = pathlib.Path(results), [pathlib.Path(figure) for figure in figures]
    parts = [f"<h1>godunov27</h1><p>Drawn by {html.escape(program)}.</p>",
             '<nav><a href="#figures">Figures</a><a href="#runs">Runs</a><a href="#studies">Studies</a></nav>',
             '<h2 id="figures">Figures</h2>']
    parts += [picture(path, title_of(path.stem)) for path in figures]
    parts.append('<h2 id="runs">Runs</h2>')
    parts += [run_section(path.parent) for path in sorted(results.rglob("summary.json"))
              if "earlier" not in path.parts]
    parts.append('<h2 id="studies">Studies</h2>')
    for folder in sorted({path.parent for path in results.glob("studies/*/study.h5")}):
        parts.append(f"<h3>{html.escape(folder.name)}</h3>")
        parts += [of_csv(path) for path in sorted(folder.glob("*.csv"))]
    pathlib.Path(out).write_text(f'<!doctype html><html lang="en"><meta charset="utf-8"><title>godunov27</title>'
                                 f"<style>{STYLE}</style>{''.join(parts)}</html>\n")


if __name__ == "__main__":
    main()
