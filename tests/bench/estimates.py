#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the errors of `netloft study estimate`: estimates between the points of a computed study are compared with solves there.

    estimates.py NETLOFT FOLDER [--places 20] [--seed 1] [--figure NAME]

Places are random, within the middle nine tenths of the range of every variable. Prints, for every figure, the largest and the root mean square
difference between estimate and solve, the median error that the estimates report, the range over the study, and how many solves are within the
reported error. Variables without numbers are not varied.
"""
import argparse
import json
import math
import pathlib
import random
import statistics
import subprocess
import tempfile


def manifest_of(folder):
    lines = (folder / "manifest.jsonl").read_text().splitlines()
    return json.loads(lines[0]), [json.loads(line) for line in lines[1:]]


def values_of(head, items):
    """Returns all numbers of each variable, in the order of the study's manifest: those of items, then those of points."""
    values = [[] for _ in head["variables"]]
    for item in items:
        for point in item["points"]:
            for kept, value in zip(values, item["values"] + point["values"]):
                kept.append(value[1])
    return values


def place(dice, values):
    at = []
    for kept in values:
        low, high = min(kept), max(kept)
        at.append(low + (high - low) * (0.05 + 0.9 * dice.random()))
    return at


def estimated(options, head, at):
    words = [f"--at={v['name']}={x!r} {v['unit']}".strip() for v, x in zip(head["variables"], at)]
    words += [f"--figure={figure}" for figure in options.figure]
    said = subprocess.run([options.netloft, "study", "estimate", options.folder, "--json", *words], capture_output=True, text=True, check=True)
    return json.loads(said.stdout)["figures"]


def solved(options, head, at):
    """Solves one point as a study, so that figures have the names of the study, and returns the figures."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = (options.folder / head["scene"]).resolve()
        text = f"scene = {json.dumps(str(scene))}\nset = {json.dumps(head['set'])}\nfigures = {json.dumps(head['figures'])}\n"
        for variable, x in zip(head["variables"], at):
            keys = ", ".join("{ key = %s, factor = %r, offset = %s }" % (json.dumps(k["key"]), k["factor"], quantity(k["offset"], variable["unit"]))
                             for k in variable["keys"])
            text += f"[variables.{variable['name']}]\nkey = [{keys}]\nvalues = [{quantity(x, variable['unit'])}]\n"
        (folder / "one.toml").write_text(text if head["figures"] else text.replace("figures = []\n", ""))
        for action, target in (("plan", "one.toml"), ("run", "one.study")):
            subprocess.run([options.netloft, "study", action, target], cwd=folder, capture_output=True, check=True)
        record = json.loads(next((folder / "one.study/items").glob("*.json")).read_text().splitlines()[0])
        point = record["points"][0]
        names = [figure["name"] for figure in record["figures"]]
        return dict(zip(names, point["values"])) if point["status"] == "converged" else None


def quantity(number, unit):
    return json.dumps(f"{number!r} {unit}") if unit else repr(number)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--places", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--figure", action="append", default=[])
    options = parser.parse_args()
    head, items = manifest_of(options.folder)
    values, dice, found, lost = values_of(head, items), random.Random(options.seed), {}, 0
    for _ in range(options.places):
        at = place(dice, values)
        truth = solved(options, head, at)
        lost += truth is None
        for figure, told in (estimated(options, head, at) if truth else {}).items():
            if "why_not" not in told and isinstance(truth.get(figure), (int, float)):
                found.setdefault(figure, []).append((told["value"] - truth[figure], told["error"], truth[figure]))
    print(f"{'figure':<40} {'largest':>10} {'rms':>10} {'told':>10} {'of':>12}   within")
    for figure, all_of_it in found.items():
        off = [abs(difference) for difference, _, _ in all_of_it]
        told = statistics.median(error for _, error, _ in all_of_it)
        print(f"{figure:<40} {max(off):>10.3g} {math.sqrt(sum(x * x for x in off) / len(off)):>10.3g} {told:>10.3g} "
              f"{statistics.fmean(truth for _, _, truth in all_of_it):>12.5g}   "
              f"{sum(abs(d) <= error for d, error, _ in all_of_it)} of {len(all_of_it)}")
    if lost:
        print(f"{lost} places without a stable equilibrium")


if __name__ == "__main__":
    main()
