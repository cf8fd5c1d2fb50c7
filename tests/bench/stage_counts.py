#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the work of the default strategy on fixed scenes: iterations and factorisations by stage, and the work of the whole search.

  stage_counts.py NETLOFT SOURCE_FOLDER [--check PAGE.md] [--only PART]

Counts depend on neither load nor clock, but on last digits, and so on the processor. Each scene is therefore solved five times,
with one number changed by up to 0.2 %, and the table has the median, the least and the most. --check compares with a table that
this script printed. It fails if a median, of the work of a scene or of the factorisations on its own mesh, is a quarter above
the most of the table, and where the medians of all scenes have grown by a quarter on average.
"""
import argparse
import collections
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

MOST_GROWTH = 1.25
# name -> scene, its settings, the number that is changed with its value and unit
SCENES = {
    "hanging panel, fig. 6a": ("dead-weight-panel", ["parts.net.cells=[64,64]"], "water.density", 1025, ""),
    "stretched panel, fig. 6b": ("verification/stretched-panel", ["parts.net.cells=[64,64]"], "parts.net.twine.opening_stiffness", 0.001, "N.m/rad"),
    "cod-end from a plan": ("codend-from-plan", [], "water.density", 1025, ""),
    "83-112 in a flume": ("83-112-flume-3.0kn", ["gear.nodes=2000"], "tow.speed", 3, "kn"),
    "83-112 at sea": ("83-112-at-sea-66m", ["gear.nodes=2000"], "ship.speed", 3, "kn"),
    "gov-like bottom trawl": ("gov-like-31m", ["gear.nodes=2500"], "ship.speed", 3.7, "kn"),
    "two panels": ("two-panel", ["gear.nodes=2000"], "water.current[0]", 1.2, "m/s"),
    "four panels": ("four-panel", ["gear.nodes=2000"], "water.current[0]", 1.5, "m/s"),
    "pelagic trawl": ("pelagic-with-doors", ["gear.nodes=2000"], "ship.speed", 3, "kn"),
    "pair trawl": ("pair-trawl", ["gear.nodes=2000"], "water.density", 1025, ""),
}
CHANGES = (-2e-3, -1e-3, 0, 1e-3, 2e-3)


def solve(program, source, scene, settings, folder):
    words = [word for one in settings for word in ("--set", one)]
    file = source / "gear-library/scenes" / f"{scene}.toml"
    ended = subprocess.run([program, "run", file, "--strategy", "auto", "--threads", "1", "--json", "--overwrite",
                            "-o", folder / "found.hdf", *words], capture_output=True, text=True)
    report = json.loads(ended.stdout) if ended.stdout.startswith("{") else {}
    if "stages" not in report:
        sys.exit(f"{scene}: {ended.stderr}{ended.stdout}")
    return report


def counts_of(report):
    """(stage, unknowns) -> [iterations, factorisations], in the order in which they were first solved."""
    counts = collections.OrderedDict()
    for stage in report["stages"]:
        if not stage["iterations"] and not stage["factorisations"]:
            continue
        one = counts.setdefault((stage["name"], stage["unknowns"]), [0, 0])
        one[0] += stage["iterations"]
        one[1] += stage["factorisations"]
    return counts


def measure(program, source, name, folder):
    scene, settings, path, value, unit = SCENES[name]
    reports = []
    for change in CHANGES:
        number = value * (1 + change)
        reports.append(solve(program, source, scene, [*settings, f'{path}="{number} {unit}"' if unit else f"{path}={number}"], folder))
    each = [counts_of(report) for report in reports]
    middle = sorted(range(len(reports)), key=lambda i: reports[i]["work"])[len(reports) // 2]
    own = [sum(one[1] for (_, unknowns), one in counts.items() if unknowns == report["unknowns"]) for counts, report in zip(each, reports)]
    return {"name": name, "unknowns": reports[0]["unknowns"], "status": "/".join(sorted({r["status"] for r in reports})),
            "own": own, "work": [r["work"] for r in reports], "stages": each[middle]}


def spread(counts):
    return f"{statistics.median(counts):.0f} ({min(counts):.0f} to {max(counts):.0f})"


def table(rows):
    print("| scene | unknowns | ended | factorisations of its own mesh | work of all meshes, in Newton iterations of the scene |\n|---|---|---|---|---|")
    for row in rows:
        print(f"| {row['name']} | {row['unknowns']} | {row['status']} | {spread(row['own'])} | {spread(row['work'])} |")
    print("\n| scene | stage of the run of median work | unknowns | iterations | factorisations |\n|---|---|---|---|---|")
    for row in rows:
        for (stage, unknowns), (iterations, factorisations) in row["stages"].items():
            print(f"| {row['name']} | {stage} | {unknowns} | {iterations} | {factorisations} |")


def check(rows, page):
    before = {}
    for line in page.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        if len(cells) == 5 and cells[0] in SCENES and "(" in cells[4]:
            before[cells[0]] = [tuple(float(number) for number in re.findall(r"[\d.]+", cell)) for cell in cells[3:]]
    faults = [f"{row['name']}: not on {page}" for row in rows if row["name"] not in before]
    known = [row for row in rows if row["name"] in before]
    for i, (key, what) in enumerate((("own", "factorisations of its own mesh"), ("work", "work"))):
        growths = []
        for row in known:
            now, (then, _, most) = statistics.median(row[key]), before[row["name"]][i]
            growths.append(now / then)
            if now > MOST_GROWTH * most + 1:
                faults.append(f"{row['name']}: {what} {now:.0f}, at most {most:.0f} on {page}")
        mean = math.exp(statistics.fmean(map(math.log, growths))) if growths else 1
        if mean > MOST_GROWTH:
            faults.append(f"all scenes: {what} {mean:.2f} times that on {page}, on average")
    return faults


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("--check", type=pathlib.Path)
    options.add_argument("--only", default="")
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [measure(asked.program, asked.source, name, pathlib.Path(folder)) for name in SCENES if asked.only in name]
    table(rows)
    if asked.check and (faults := check(rows, asked.check)):
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
