#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of water that is slowed by a net: gears of the library with [flow] type = "flow/momentum" beside undisturbed water.

    slowed_water.py NETLOFT LIBRARY [--times 3] [--nodes N] [--only PART]

Pairs of runs, one after the other; processor time of the whole program, median of the ratios of each pair.
"""
import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import tempfile

GEARS = (("two-panel", ()), ("four-panel", ()), ("pelagic-with-doors", ()), ("pair-trawl", ()), ("gov-like-31m", ()), ("gov-like-67m", ()),
         ("83-112-at-sea-66m", ()), ("83-112-at-sea-99m", ()), ("83-112-flume-3.0kn", ("gear.nodes=500",)),
         ("83-112-flume-3.0kn", ("gear.nodes=2000",)), ("83-112-flume-2.0kn", ()), ("83-112-flume-4.0kn", ()))


def run(program, scene, flow, settings, folder):
    (folder / "scene.toml").write_text(f'include = ["{scene.resolve()}"]\n[flow]\ntype = "{flow}"\n')
    words = [word for each in settings for word in ("--set", each)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([program, "run", "scene.toml", "--json", "-o", "scene.hdf", *words], cwd=folder, capture_output=True, text=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    result = json.loads(done.stdout)
    return seconds, result["factorisations"], result["status"], result["gear"]["figures"].get("mouth/induction", 0)


def row(options, gear, settings, folder):
    if options.nodes:
        settings = (*(s for s in settings if not s.startswith("gear.nodes")), f"gear.nodes={options.nodes}")
    scene, ratios = options.library / f"scenes/{gear}.toml", []
    for _ in range(options.times):
        free, slowed = (run(options.program, scene, flow, settings, folder) for flow in ("none", "flow/momentum"))
        ratios.append(slowed[0] / free[0])
    ratio = statistics.median(ratios)
    print(f"| {gear}{', ' + settings[0].split('.')[-1] if settings else ''} | {100 * slowed[3]:.1f} | {free[1]} | {slowed[1]} | {free[0]:.2f} | "
          f"{slowed[0]:.2f} | {ratio:.2f} |{'' if free[2] == slowed[2] == 'converged' else ' ' + free[2] + ', ' + slowed[2]}", flush=True)
    return ratio, slowed[1] / free[1]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program", type=pathlib.Path)
    arguments.add_argument("library", type=pathlib.Path)
    arguments.add_argument("--times", type=int, default=3)
    arguments.add_argument("--nodes", type=int)
    arguments.add_argument("--only", default="")
    options = arguments.parse_args()
    options.program = options.program.resolve()
    print("| gear | speed lost [%] | factorisations, undisturbed | slowed | processor time [s], undisturbed | slowed | ratio |\n" + "|---" * 7 + "|")
    with tempfile.TemporaryDirectory() as folder:
        found = [row(options, gear, settings, pathlib.Path(folder)) for gear, settings in GEARS if options.only in gear]
    print(f"\nMedian ratio of processor times {statistics.median(r[0] for r in found):.2f}, of factorisations "
          f"{statistics.median(r[1] for r in found):.2f}.")


if __name__ == "__main__":
    main()
