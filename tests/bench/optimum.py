#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Optimises the 83-112 in the flume tank at 3 knots, from several starts, and prints the results.

    optimum.py NETLOFT LIBRARY [--nodes 1000] [--starts 5]

The drag is least with the headline at 2.0 m or more and the upper wing ends 17.5 m apart (± 1 cm), where no rope has more tension than at the start.
Variables that the program refuses, because figures have no derivatives with respect to them or the ends of their ranges cannot be sewn, are
listed and left out.
The first start is the scene; the others are drawn from the ranges, always the same.
"""
import argparse
import json
import random
import re
import subprocess
import tempfile
from pathlib import Path

SCENE, TWINE, SIDES = "83-112-flume-3.0kn.toml", 2.3, ("top", "bottom")
PANELS = [f"{side}-{panel}" for panel in ("wing", "body", "intermediate", "codend") for side in SIDES]
MESHES = {"wing": 101.6, "body": 101.6, "intermediate": 88.9, "codend": 88.9}
ROPES = ("headrope", "footrope", "upper-bridle", "lower-bridle", "upper-breast", "lower-breast", "ribline")
LIFT = 2.506  # kgf, of one of 47 floats


def mesh_of(panel):
    return MESHES[panel.partition("-")[2]]


class Variable:
    """A number of the scene: its path, its value at the start, its range and its unit, and texts that must be set before it."""

    def __init__(self, name, path, start, low, high, unit, needs=()):
        self.name, self.path, self.start, self.low, self.high, self.unit, self.needs = name, path, start, low, high, unit, list(needs)

    def set(self):
        return [*self.needs, f"{self.path}={self.start} {self.unit}"]

    def table(self, start):
        return (f'[variables.{self.name}]\nkey = "{self.path}"\nrange = ["{self.low} {self.unit}", "{self.high} {self.unit}"]\n'
                f'start = "{start} {self.unit}"\n')


def around(value, part):
    return round(value * (1 - part), 6), round(value * (1 + part), 6)


PLAIN = [Variable("floats", "elements.floats.float.buoyancy", LIFT, 0.5 * LIFT, 2 * LIFT, "kgf"),  # as if their number were a real
         Variable("across", "points.towing-point.at[1]", 29.47, 27, 32, "m"),
         Variable("upper-bridle", "ropes.upper-bridle.length", 54.9, 53.9, 55.9, "m"),
         Variable("lower-bridle", "ropes.lower-bridle.length", 54.9, 53.9, 55.9, "m"),
         *(Variable(f"{p}-mesh", f"panels.{p}.mesh", mesh_of(p), *around(mesh_of(p), 0.15), "mm") for p in PANELS[:4])]
TWINES = [Variable(f"{p}-twine", f"panels.{p}.twine.diameter", TWINE, *around(TWINE, 0.2), "mm", [f"panels.{p}.twine.part=pa-twisted-2.3mm"])
          for p in PANELS]


class Bench:
    def __init__(self, netloft, library, nodes, folder):
        self.netloft, self.scene, self.nodes, self.folder = netloft, library / "scenes" / SCENE, nodes, folder

    def call(self, *words):
        return subprocess.run([self.netloft, *words], cwd=self.folder, capture_output=True, text=True, check=False)

    def settings(self, variables):
        return [f"gear.nodes={self.nodes}", "analysis.tolerance=1e-9", *(word for v in variables for word in v.set())]

    def run(self, words):
        """A run of the scene, as JSON."""
        sets = [w for word in words for w in ("--set", word)]
        out = self.call("run", str(self.scene), *sets, "--json", "-o", "run.hdf", "--overwrite")
        return json.loads(out.stdout)

    def text(self, variables, starts, tensions):
        limits = "".join(f'[[constraints]]\nfigure = "gear/ropes/{rope}/tension_largest"\nat_most = "{t} N"\n' for rope, t in tensions.items())
        return (f'scene = "{self.scene}"\nset = {json.dumps(self.settings(variables))}\n' + "".join(v.table(s) for v, s in zip(variables, starts))
                + '[objective]\nminimise = "gear/drag/all/x"\nunit = "kN"\n'
                '[[constraints]]\nfigure = "gear/mouth/headline_height"\nat_least = "2 m"\n'
                '[[constraints]]\nfigure = "gear/mouth/upper_wing_spread"\nat_least = "17.49 m"\nat_most = "17.51 m"\n' + limits)

    def optimise(self, name, variables, starts, tensions):
        (self.folder / f"{name}.toml").write_text(self.text(variables, starts, tensions))
        out = self.call("optimise", f"{name}.toml", "--json")
        return (json.loads(out.stdout) if out.stdout else None), out.stderr

    def allowed(self, variables, tensions):
        """The accepted and the refused variables; an error names the table of its variable."""
        text = self.text(variables, [v.start for v in variables], tensions).splitlines()
        _, said = self.optimise("allowed", variables, [v.start for v in variables], tensions)
        wrong = {text[int(line) - 1] for line in re.findall(r"^allowed\.toml:(\d+):\d+: error", said, re.MULTILINE)}
        refused = [v for v in variables if f"[variables.{v.name}]" in wrong]
        return [v for v in variables if v not in refused], refused


def drawn(variables, seed):
    chance = random.Random(seed)
    return [round(v.low + chance.random() * (v.high - v.low), 6) for v in variables]


def row(name, found, drag):
    """A row of the table; `drag` is that of the scene as it is."""
    if found is None:
        return f"| {name} | wrong input | | | | |"
    after = found["objective"]["after"] or float("nan")
    return (f"| {name} | {found['status']} | {found['points']} | {found['remainder'] or float('nan'):.1e} | {after:.4f} | "
            f"{100 * (1 - after / drag):.2f} % |")


HEAD = "| start | answer | solves | remainder | drag [kN] | less than now |\n|---|---|---|---|---|---|"


def spread(found, variables):
    """The spread of the optima: for each variable, as a fraction of its range."""
    answers = [f for f in found if f and f["status"] == "optimal"]
    for k, v in enumerate(variables):
        values = [f["variables"][k]["after"] for f in answers]
        print(f"| {v.name} | {v.start:g} | {values[0]:.5g} | {v.low:g} to {v.high:g} {v.unit} | {(max(values) - min(values)) / (v.high - v.low):.1e} |")


def loads(bench, variables, best):
    """The load of each part as a fraction of its breaking load, before and after; a twine breaks in proportion to its section."""
    before = bench.run(bench.settings(variables))["materials"]
    after = bench.run(best["set"])["materials"]
    part = {v.name: row["after"] / v.start for v, row in zip(variables, best["variables"]) if v in TWINES}
    print("\n| part | load before | load after, of what it breaks at [%] |\n|---|---|---|")
    for a, b in zip(before, after):
        if a.get("breaking_load"):
            print(f"| {a['name']} | {100 * a['load'] / a['breaking_load']:.2f} | "
                  f"{100 * b['load'] / (a['breaking_load'] * part.get(a['name'] + '-twine', 1) ** 2):.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft", type=lambda p: str(Path(p).resolve()))
    parser.add_argument("library", type=lambda p: Path(p).resolve())
    parser.add_argument("--nodes", type=int, default=1000)
    parser.add_argument("--starts", type=int, default=5)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.netloft, arguments.library, arguments.nodes, Path(folder))
        everything = PLAIN + TWINES
        figures = bench.run(bench.settings(everything[:1]))["gear"]["figures"]
        tensions = {rope: figures[f"ropes/{rope}/tension_largest"] for rope in ROPES}
        drag = figures["drag/all/x"] / 1000
        variables, refused = bench.allowed(everything, tensions)
        plain = [v for v in variables if v not in TWINES]
        print(f"drag now: {drag:.3f} kN, headline {figures['mouth/headline_height']:.3f} m, wings {figures['mouth/upper_wing_spread']:.3f} m")
        print("refused: " + (", ".join(v.name for v in refused) or "none"))
        print("\n" + HEAD)
        for name, limits in (("as it is, without twines", tensions), ("as it is, without twines and limits of tension", {})):
            print(row(name, bench.optimise(f"plain{len(limits)}", plain, [v.start for v in plain], limits)[0], drag))
        found = []
        for seed in range(arguments.starts):
            answer, _ = bench.optimise(f"start{seed}", variables, drawn(variables, seed) if seed else [v.start for v in variables], tensions)
            found.append(answer)
            print(row(f"drawn, {seed}" if seed else "as it is", answer, drag), flush=True)
        if not found[0] or found[0]["status"] != "optimal":
            return
        print("\n| variable | before | after | range | spread over the starts |\n|---|---|---|---|---|")
        spread(found, variables)
        print("\n| figure | price |\n|---|---|")
        for limit in found[0]["constraints"] + found[0]["variables"]:
            if abs(limit["price"]) > 1e-9:
                print(f"| {limit['name']} | {limit['price']:+.4g} kN per {limit['unit']} |")
        loads(bench, variables, found[0])


if __name__ == "__main__":
    main()
