#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of equilibria: bench_arrival, and whole runs of the trawl 83-112, with ratios to another version of the program.

    arrival.py NETLOFT BUILD/bin/bench_arrival SOURCE_FOLDER [--against OTHER_NETLOFT OTHER_SOURCE_FOLDER] [--largest 1e5]
               [--newton 1000,2000,8000] [--knots 2.0,3.0,4.0] [--nodes 2000,8000] [--times 5]

First bench_arrival: panels of fig. 6a and 6b of the trawl-gear paper up to --largest unknowns, with the power of the unknowns by which their time
grows, and the cost of one iteration of Newton's method for the 83-112, in factorisations of its tangent, at --newton nodes. Then `netloft run`
of the 83-112: processor time of the whole program, of the search for the equilibrium, and of the assessment of stability, the medians of --times
runs. With --against, the two programs run in turn, each with the scenes of its own sources, and the ratio is the median of pairs.
"""
import argparse
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import processor_time  # noqa: E402


def numbers(text):
    return text.split(",") if text else []


def run(program, source, knots, nodes):
    """Returns the report of a run, with the processor time of the whole program."""
    with tempfile.TemporaryDirectory() as folder:
        before = processor_time.of_children()
        done = subprocess.run([program, "run", Path(source) / f"gear-library/scenes/83-112-flume-{knots}kn.toml", "--json",
                               "--set", f"gear.nodes={nodes}", "-o", f"{folder}/out.hdf"], capture_output=True, text=True)
        spent = processor_time.of_children() - before
    if not done.stdout:
        sys.exit(done.stderr)
    report = json.loads(done.stdout)
    report["program_seconds"] = spent
    return report


def median_of(reports, key):
    return statistics.median(report[key] for report in reports)


def row(knots, nodes, here, there):
    one = here[0]
    cells = [knots, nodes, one["unknowns"], one["status"], one["stability"], one["iterations"], one["factorisations"],
             *(f"{median_of(here, key):.2f}" for key in ("program_seconds", "cpu_seconds", "judging_cpu_seconds"))]
    if there:
        ratios = [a["program_seconds"] / b["program_seconds"] for a, b in zip(here, there)]
        other = there[0]
        cells += [other["status"], other["stability"], other["iterations"], other["factorisations"], f"{median_of(there, 'program_seconds'):.2f}",
                  f"{statistics.median(ratios):.2f}"]
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("bench")
    parser.add_argument("source")
    parser.add_argument("--against", nargs=2, metavar=("PROGRAM", "SOURCE"))
    parser.add_argument("--largest", default="1e5")
    parser.add_argument("--newton", default="1000,2000,8000")
    parser.add_argument("--knots", default="2.0,3.0,4.0")
    parser.add_argument("--nodes", default="2000,8000")
    parser.add_argument("--times", type=int, default=5)
    options = parser.parse_args()
    subprocess.run([options.bench, options.largest, *numbers(options.newton)], check=True)
    heads = ["knots", "nodes", "unknowns", "status", "stability", "iterations", "factorisations", "CPU [s]", "search [s]", "judgement [s]"]
    heads += ["other's status", "stability", "iterations", "factorisations", "CPU [s]", "CPU over the other's"] if options.against else []
    print("\n| " + " | ".join(heads) + " |\n|" + "---|" * len(heads), flush=True)
    for nodes in numbers(options.nodes):
        for knots in numbers(options.knots):
            here, there = [], []
            for _ in range(options.times):
                here.append(run(options.program, options.source, knots, nodes))
                if options.against:
                    there.append(run(*options.against, knots, nodes))
            print(row(knots, nodes, here, there), flush=True)


if __name__ == "__main__":
    main()
