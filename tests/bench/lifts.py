#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Solves the 83-112 at sea with 201 lifts of its boards, close to each other, to see whether a study loses rows.

    lifts.py NETLOFT GEAR_LIBRARY [--nodes 2000] [--points 201] [--alone] [--check]

The gears hardly differ, but a few slack nodes at the tips of the wings may rest in one and not in the next. Prints a Markdown table: points,
rows that converged, their stability, the work, and the largest distance of each figure from a parabola through all points. With --alone every
point is solved by itself, not from its neighbour. --check exits with 1 if a row is lost, or if a figure is off the parabola by a tenth of 1 %,
which is what makes no difference to a gear.
"""
import argparse
import collections
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

LEAST, MOST = 0.900, 0.936
MATTERS = 1e-3
FIGURES = {"headline height": "gear/mouth/headline_height", "wing spread": "gear/mouth/upper_wing_spread",
           "spread of the boards": "gear/pairs/door/spread", "pull": "gear/towing/pull"}


def rows_of(options, folder):
    lifts = ", ".join(f"{lift:.6f}" for lift in numpy.linspace(LEAST, MOST, options.points))
    scene = (options.library / "scenes/83-112-at-sea-66m.toml").resolve()
    figures = ", ".join(f'"{figure}"' for figure in FIGURES.values())
    path = "path = []\n" if options.alone else ""
    (folder / "lifts.toml").write_text(f'scene = "{scene}"\n{path}set = ["gear.nodes={options.nodes}"]\nfigures = [{figures}]\n'
                                       f'[variables.lift]\nkey = "bodies.door.board.lift"\nvalues = [{lifts}]\n')
    for words in (["plan", "lifts.toml"], ["run", "lifts.study", "--jobs", "1"], ["collect", "lifts.study"]):
        ended = subprocess.run([options.netloft, "study", *words], cwd=folder, capture_output=True, text=True)
        if not (folder / "lifts.study").is_dir():
            sys.exit(ended.stdout + ended.stderr)
    with open(folder / "lifts.study/table.csv", newline="") as table:
        return list(csv.DictReader(table))


def distance_from_parabola(rows, figure):
    """Returns the largest distance of a figure from a parabola, relative to the figure."""
    name = next(column for column in rows[0] if column.startswith(figure + " "))
    lifts, values = (numpy.array([float(row[column]) for row in rows]) for column in ("lift", name))
    if len(rows) < 4:
        return 0.0
    curve = numpy.polynomial.Polynomial.fit(lifts, values, 2)
    return float(numpy.max(numpy.abs(curve(lifts) - values) / numpy.abs(values)))


def main(arguments):
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("netloft", type=Path)
    p.add_argument("library", type=Path)
    p.add_argument("--nodes", type=int, default=2000)
    p.add_argument("--points", type=int, default=201)
    p.add_argument("--alone", action="store_true", help="every point by itself")
    p.add_argument("--check", action="store_true", help="exit 1 if a row is lost or a figure is off the curve")
    options = p.parse_args(arguments)
    options.netloft = options.netloft.resolve()
    with tempfile.TemporaryDirectory() as folder:
        rows = rows_of(options, Path(folder))
    found = [row for row in rows if row["status"] == "converged"]
    stable = collections.Counter(row["stability"] for row in found)
    off = {name: distance_from_parabola(found, figure) for name, figure in FIGURES.items()} if found else {}
    print("| points | rows found | stability | factorisations | off a parabola |\n|---|---|---|---|---|")
    print(f"| {options.points} | {len(found)} | {', '.join(f'{count} {word}' for word, count in stable.most_common())} "
          f"| {sum(int(row['factorisations']) for row in rows)} | {', '.join(f'{name} {part:.0e}' for name, part in off.items())} |")
    is_lost = len(found) < options.points or max(off.values()) > MATTERS
    return 1 if options.check and is_lost else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
