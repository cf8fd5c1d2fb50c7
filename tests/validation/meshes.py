#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The 83-112 in the flume on finer and finer meshes: convergence, figures and cost.

    meshes.py NETLOFT GEAR_LIBRARY [--nodes 500,1000,2000,4000,8000] [--knots 2.0,3.0,4.0] [--raised 0,0.8] [--set KEY=VALUE ...]
              [--csv FILE] [--check]

Prints a row for each mesh, at each speed and height of the towing point. `over the law` is processor time over the power law through all meshes
of that speed and height, c N^p, by least squares of the logarithms. `off` is the median, over all figures
of the report, of the difference from the finest mesh. For a mesh on which the gear does not converge, the row says how the run ended.
--csv: all figures on all meshes.
--check: exit 1 if there is one, or one that takes more than 600 factorisations, those of the coarser meshes it began on included.
"""
import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import processor_time  # noqa: E402

HEIGHT_OF_POINT = -19.6  # [m], as in the scenes
MOST_FACTORISATIONS = 600  # more than any of the table takes that converges at 3 and 4 knots
FIGURES = (("height [m]", "mouth/headline_height", 1, ".3f"), ("upper spread [m]", "mouth/upper_wing_spread", 1, ".3f"),
           ("lower spread [m]", "mouth/lower_wing_spread", 1, ".3f"), ("mouth [m²]", "mouth/area", 1, ".2f"),
           ("bridles [kN]", "rigging/bridle/tension_start", 1e-3, ".3f"), ("drag [kN]", "drag/all/x", 1e-3, ".3f"))


def solve(program, library, knots, raised, nodes, settings=()):
    """The report of a run, with the processor time of the whole run."""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, "run", str(library / f"scenes/83-112-flume-{knots}kn.toml"), "--json", "-o", f"{folder}/out.hdf",
                 "--set", f"gear.nodes={nodes}", "--set", f"points.towing-point.at[2]={HEIGHT_OF_POINT + raised} m",
                 *(word for each in settings for word in ("--set", each))]
        before = processor_time.of_children()
        done = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        spent = processor_time.of_children() - before
    if not done.stdout:
        sys.exit(done.stderr)
    report = json.loads(done.stdout)
    report["cpu"] = spent
    return report


def power_law(sizes, times):
    """c and p of c N^p."""
    x, y = [math.log(n) for n in sizes], [math.log(t) for t in times]
    middle, level = sum(x) / len(x), sum(y) / len(y)
    spread = sum((a - middle) ** 2 for a in x)
    p = sum((a - middle) * (b - level) for a, b in zip(x, y)) / spread if spread else 0
    return math.exp(level - p * middle), p


def verdict(report):
    if report["status"] not in ("converged", "unstable"):
        return f"{report['status']}, {report['residual'] / report['largest_load']:.0e} of the load"
    swing = report["swing"]
    if not swing:
        return report["stability"]
    period = f"swings in {swing['period']:.2g} s" if swing["period"] else "diverges"
    return f"{period}, tenfold in {swing['tenfold_in']:.2g} s"


def off(report, finest):
    """Median relative difference of the figures on a mesh from those on the finest mesh."""
    here, there = report["gear"]["figures"], finest["gear"]["figures"]
    both = [(here[name], there[name]) for name in there if isinstance(here.get(name), float) and isinstance(there[name], float)]
    return statistics.median(abs(a / b - 1) for a, b in both if b != 0)


def write_figures(file, all_of):
    """A line for each speed, height, mesh and figure."""
    with open(file, "w", newline="", encoding="utf-8") as out:
        lines = csv.writer(out)
        lines.writerow(["knots", "raised [m]", "nodes", "figure", "value"])
        for where, report in all_of.items():
            lines.writerows([*where, name, value] for name, value in report["gear"]["figures"].items())


def row(knots, raised, nodes, report, law, finest):
    figures = report["gear"]["figures"]
    cells = [f"{factor * figures[key]:{form}}" for _, key, factor, form in FIGURES]
    cost = report["cpu"] / (law[0] * report["unknowns"] ** law[1])
    return " | ".join([f"| {knots}", f"{raised:g}", str(nodes), str(report["unknowns"]), verdict(report), *cells, str(report["factorisations"]),
                       f"{report['cpu']:.1f}", f"{cost:.2f}", f"{100 * off(report, finest):.1f} |"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("library", type=Path)
    parser.add_argument("--nodes", default="500,1000,2000,4000,8000")
    parser.add_argument("--knots", default="2.0,3.0,4.0")
    parser.add_argument("--raised", default="0,0.8")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--csv", type=Path)
    parser.add_argument("--check", action="store_true")
    a = parser.parse_args()
    faults, all_of = [], {}
    heads = ["knots", "raised [m]", "nodes", "unknowns", "verdict", *(f[0] for f in FIGURES), "factorisations", "CPU [s]", "over the law", "off [%]"]
    print("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    exponents = []
    for knots in a.knots.split(","):
        for raised in (float(r) for r in a.raised.split(",")):
            found = {int(n): solve(a.program, a.library, knots, raised, int(n), a.set) for n in a.nodes.split(",")}
            law = power_law([r["unknowns"] for r in found.values()], [r["cpu"] for r in found.values()])
            exponents.append(f"{knots} kn, {raised:g} m: {law[1]:.2f}")
            for nodes, report in found.items():
                print(row(knots, raised, nodes, report, law, found[max(found)]), flush=True)
                all_of[knots, raised, nodes] = report
                if report["status"] != "converged" or report["factorisations"] > MOST_FACTORISATIONS:
                    faults.append(f"{knots} kn, {raised:g} m, {nodes} nodes: {report['status']}, {report['factorisations']} factorisations")
    print("\nExponent of processor time over unknowns: " + "; ".join(exponents))
    if a.csv:
        write_figures(a.csv, all_of)
    if a.check and faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
