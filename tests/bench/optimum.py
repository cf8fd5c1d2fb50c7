#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Optimises the 83-112 in the flume tank at 3 knots: least drag with the headline at 2 m or more, the upper wing ends 17.5 m apart (± 1 cm), and
the footrope no higher over the bed than at the start.

    optimum.py NETLOFT LIBRARY [--nodes 600] [--starts 5] [--draws 20] [--check] [--write]

Prints optimum.md without its words. --write also writes gear-library/optima: the file of the search, and the plan that can be sewn. --check fails if
a goal is missed: 15 % less drag in 60 solves, with a remainder of at most 1e-4, and a plan that `netloft check` passes.
Starts and common uncertainties are drawn with fixed seeds.
"""
import argparse
import json
import math
import random
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

SCENE, TWINE, LIFT, FLOATS, MESH = "83-112-undisturbed-water.toml", 2.3, 2.506, 47, 0.1016  # twines [mm], lift of a float [kgf], their number, mesh [m]
FORE = ("top-wing", "top-body", "bottom-wing", "bottom-body")  # panels whose mesh size is a variable
PANELS = FORE + ("top-intermediate", "bottom-intermediate", "top-codend", "bottom-codend")
ROPES = ("headrope", "footrope", "upper-bridle", "lower-bridle", "lower-extension", "upper-breast", "lower-breast", "ribline")
LARGEST = 1.15  # most of the mesh size of the plan
COUNTS = {"panels.top-wing.fore": 3, "panels.top-wing.depth": 95.5, "panels.top-wing.aft": 127.5, "panels.top-wing.outer[0].meshes": 43,
          "panels.top-wing.outer[1].depth": 70, "panels.top-body.fore[0].meshes": 72, "panels.top-body.fore[1].meshes": 128.5,
          "panels.top-body.depth": 191, "panels.top-body.aft": 56, "panels.bottom-wing.fore": 3, "panels.bottom-wing.depth": 149.5,
          "panels.bottom-wing.aft": 89.5, "panels.bottom-wing.outer[0].meshes": 25.5, "panels.bottom-body.fore[0].meshes": 72,
          "panels.bottom-body.fore[1].meshes": 89.5, "panels.bottom-body.depth": 137, "panels.bottom-body.aft": 56}
TAKE_UPS = {"join[3].take_up": 60 / 56, "join[4].take_up": 60 / 56}  # of the 60 meshes aft of the bodies
COMMON = {"tow.speed": "0.1 kn", "elements.netting.drag.shielding": "0.07", "elements.footrope.rope.density": "390",
          "points.towing-point.at[2]": "0.19 m", "water.density": "3"}  # what is not well known of both gears, and its deviation
DRAG, HEIGHT, WINGS, FOOT = "gear/drag/all/x", "gear/mouth/headline_height", "gear/mouth/upper_wing_spread", "results/footrope"


class Variable:
    """A number of the scene: its keys as TOML, its start, its range and its unit."""

    def __init__(self, name, key, start, low, high, unit):
        self.name, self.key, self.start, self.low, self.high, self.unit = name, key, start, low, high, unit

    def table(self, start):
        def say(x):
            return f'"{x:.10g} {self.unit}"' if self.unit else f"{x:.10g}"
        return f"[variables.{self.name}]\nkey = {self.key}\nrange = [{say(self.low)}, {say(self.high)}]\nstart = {say(start)}\n\n"


def mesh_keys():
    """The keys that a relative mesh size sets. Counts fall with it, so that the stretched netting keeps its size: exactly at both ends of the range,
    and within 0.5 % between."""
    fall = (1 - 1 / LARGEST) / (LARGEST - 1)
    rows = [(f"panels.{p}.mesh", 0, MESH) for p in FORE] + [(key, count * (1 + fall), -count * fall) for key, count in COUNTS.items()]
    rows += [(key, 0, ratio) for key, ratio in TAKE_UPS.items()]
    return "[\n" + "".join(f'  {{ key = "{key}", offset = {offset:.10g}, factor = {factor:.10g} }},\n' for key, offset, factor in rows) + "]"


def variables(start):
    """The variables, without those of twines, and those of twines. `start` has the floats and the place of the towing point."""
    plain = [Variable("floats", '"elements.floats.float.buoyancy"', start[0], 0.5 * LIFT, 2 * LIFT, "kgf"),
             Variable("across", '"points.towing-point.at[1]"', start[1], 27, 32, "m"),
             Variable("upper-bridle", '"ropes.upper-bridle.length"', 54.9, 53.9, 55.9, "m"),
             Variable("lower-bridle", '"ropes.lower-bridle.length"', 54.9, 53.9, 55.9, "m"),
             Variable("fore-mesh", mesh_keys(), 1, 1, LARGEST, "")]
    return plain, [Variable(p, f'"panels.{p}.twine.diameter"', TWINE, 0.8 * TWINE, 1.2 * TWINE, "mm") for p in PANELS]


class Bench:
    def __init__(self, netloft, library, nodes, folder):
        self.netloft, self.library, self.scene, self.folder = netloft, library, library / "optima" / SCENE, folder
        self.settings = [f"gear.nodes={nodes}", "analysis.tolerance=1e-9", f"elements.floats.float.buoyancy={LIFT} kgf",
                         'results.footrope={ of = "footrope", take = "mean z" }', *(f"panels.{p}.twine.part=pa-twisted-2.3mm" for p in PANELS)]

    def call(self, *words):
        return subprocess.run([self.netloft, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)

    def run(self, words):
        out = self.call("run", self.scene, *(w for word in words for w in ("--set", word)), "--json", "-o", "run.hdf", "--overwrite")
        return json.loads(out.stdout)

    def text(self, chosen, starts, limits, more=(), scene=None):
        rows = {HEIGHT: 'at_least = "2 m"', WINGS: 'at_least = "17.49 m"\nat_most = "17.51 m"', **limits}
        return (f'scene = "{scene or self.scene}"\nset = {json.dumps([*self.settings, *more])}\n\n'
                + "".join(v.table(s) for v, s in zip(chosen, starts)) + f'[objective]\nminimise = "{DRAG}"\nunit = "kN"\n\n'
                + "".join(f'[[constraints]]\nfigure = "{name}"\n{limit}\n\n' for name, limit in rows.items()))

    def optimise(self, name, text):
        (self.folder / f"{name}.toml").write_text(text)
        out = self.call("optimise", f"{name}.toml", "--json", "-o", f"{name}.optimum")
        if not out.stdout:
            raise SystemExit(out.stderr)
        return json.loads(out.stdout)


def limits_of(figures, bill, own):
    """The limits of stresses and tensions: of each twine and rope as at the start if `own`, else as of the twine and the rope that are
    nearest to their breaking loads there. A twine breaks in proportion to its section."""
    breaks = {row["name"]: row["breaking_load"] for row in bill if row.get("breaking_load")}
    stress = {p: figures[f"panels/{p}/stress_largest"] for p in PANELS}
    used = {r: figures[f"ropes/{r}/tension_largest"] / breaks[r] for r in ROPES}
    limits = {f"gear/panels/{p}/stress_largest": f'at_most = "{stress[p] if own else max(stress.values()):.10g} Pa"' for p in PANELS}
    return limits | {f"gear/ropes/{r}/tension_largest": f'at_most = "{breaks[r] * (used[r] if own else max(used.values())):.10g} N"' for r in ROPES}


def drawn(chosen, seed):
    chance = random.Random(seed)
    return [round(v.low + chance.random() * (v.high - v.low), 6) for v in chosen]


def after_of(found):
    return [row["after"] for row in found["variables"]]


HEAD = "| limits, variables, start | answer | solves | remainder | drag [kN] | less than at the start |\n|---|---|---|---|---|---|"


def row(name, found, drag):
    after = found["objective"]["after"] or float("nan")
    return (f"| {name} | {found['status']} | {found['points']} | {found['remainder'] or float('nan'):.1e} | {after:.4f} | "
            f"{100 * (1 - after / drag):.2f} % |")


def half(count):
    return round(2 * count) / 2


def sewn_settings(ratio):
    """The fore netting of a relative mesh size with counts of half meshes, as it is cut."""
    counts = {key: half(count / ratio) for key, count in COUNTS.items()}
    words = [f"panels.{p}.mesh={1000 * MESH * ratio:.6g} mm" for p in FORE] + [f"{key}={count:g}" for key, count in counts.items()]
    return words + [f"{key}={60 / counts['panels.top-body.aft']:.5g}" for key in TAKE_UPS]


def print_changes(found, starts):
    print("\n| variable | at the start | optimum | range | spread over the starts |\n|---|---|---|---|---|")
    for k, before in enumerate(found["variables"]):
        values = [after_of(f)[k] for f in starts if f["status"] == "optimal"]
        low, high = before["low"], before["high"]
        print(f"| {before['name']} | {before['before']:.5g} | {before['after']:.5g} | {low:g} to {high:g} {before['unit']} | "
              f"{(max(values) - min(values)) / (high - low):.0e} |")
    print("\n| limit | price |\n|---|---|")
    for limit in found["constraints"] + found["variables"]:
        if abs(limit["price"]) > 1e-9:
            print(f"| {limit['name']} | {limit['price']:+.4g} kN per {limit['unit']} |")


def slopes(bench, words):
    """The drag of a gear, and its change by one deviation of every common number [kN]."""
    to = [w for path, deviation in COMMON.items() for w in ("--to", f"{path}={deviation}")]
    out = bench.call("sensitivity", bench.scene, *(w for word in words for w in ("--set", word)), *to, "--of", "drag/all/x", "--json")
    found = json.loads(out.stdout)
    size = {path: float(deviation.split()[0]) for path, deviation in COMMON.items()}
    return (found["figures"][0]["value"], {n["path"]: n["per_unit"][0] * size[n["path"]] for n in found["numbers"]},
            {n["path"]: (n["value"], n["unit"]) for n in found["numbers"]})


def print_band(bench, before, after, draws):
    """The deviation of the gain: by the derivatives of both drags, and by pairs of solves with common numbers that are drawn."""
    (D, by_before, values), (E, by_after, _) = slopes(bench, before), slopes(bench, after)
    parts = {path: -by_after[path] / D + E / D * by_before[path] / D for path in by_before}
    band = 1.96 * math.sqrt(sum(p * p for p in parts.values()))
    chance, gains = random.Random(1), []
    for _ in range(draws):
        common = [f"{path}={value + chance.gauss(0, 1) * float(COMMON[path].split()[0])!r} {unit}".strip() for path, (value, unit) in values.items()]
        pair = [bench.run([*words, *common])["gear"]["figures"]["drag/all/x"] for words in (before, after)]
        gains.append(1 - pair[1] / pair[0])
    print(f"\ngain {100 * (1 - E / D):.2f} %, 95 % band by derivatives ± {100 * band:.2f} %, of which "
          + ", ".join(f"{path} {196 * abs(p):.2f}" for path, p in sorted(parts.items(), key=lambda x: -abs(x[1]))))
    if draws > 1:
        print(f"{draws} pairs of solves: mean {100 * statistics.mean(gains):.2f} %, ± {196 * statistics.stdev(gains):.2f} %")


class Study:
    def __init__(self, bench, words):
        self.bench, self.words, self.missed = bench, words, []
        first = variables([LIFT, 29.47])[0][:2]
        self.at_start = bench.optimise("start", bench.text(first, [v.start for v in first], {}))
        self.plain, self.twines = variables(after_of(self.at_start))
        self.start = bench.settings + self.at_start["set"][len(bench.settings):]
        result = bench.run(self.start)
        self.figures, self.bill, self.foot = result["gear"]["figures"], result["materials"], result["results"]["footrope"]
        self.drag = self.figures["drag/all/x"] / 1000

    def limits(self, own=False, lifts=False):
        """Limits of loads and, unless the gear may lift off the bed, of the mean height of the footrope."""
        height = {} if lifts else {FOOT: f'at_most = "{self.foot:.10g} m"'}
        return height | limits_of(self.figures, self.bill, own)

    def search(self, name, chosen, starts, limits, **more):
        found = self.bench.optimise(name, self.bench.text(chosen, starts, limits, **more))
        return found

    def require(self, holds, goal):
        if not holds:
            self.missed.append(goal)

    def compare(self):
        """The table of all searches; returns those of the benchmark, from every start."""
        every = self.plain + self.twines
        plain, all_starts = [v.start for v in self.plain], [v.start for v in every]
        print(HEAD)
        for own, words in ((True, "each as at the start"), (False, "none beyond the most loaded")):
            print(row(f"{words}, without twines, start", self.search(f"plain{own}", self.plain, plain, self.limits(own)), self.drag), flush=True)
            if own:
                print(row(f"{words}, all, start", self.search("own", every, all_starts, self.limits(own)), self.drag), flush=True)
        print(row("none beyond the most loaded, the footrope may lift, all, start", self.search("lifts", every, all_starts, self.limits(lifts=True)),
                  self.drag), flush=True)
        found = []
        for seed in range(self.words.starts):
            found.append(self.search(f"from{seed}", every, drawn(every, seed) if seed else all_starts, self.limits()))
            print(row(f"none beyond the most loaded, all, {f'drawn {seed}' if seed else 'start'}", found[-1], self.drag), flush=True)
        self.require(found[0]["status"] == "optimal" and found[0]["remainder"] <= 1e-4 and found[0]["points"] <= 60, "an optimum in 60 solves")
        self.require(found[0]["objective"]["after"] <= 0.85 * self.drag, "15 % less drag")
        return found

    def sew(self, found):
        """Cuts the optimum in half meshes, of twines in tenths of a millimetre and with whole floats, and seeks the rest again; prints the plan."""
        cut = sewn_settings(round(after_of(found)[4] / 0.05) * 0.05)
        twines = [Variable(v.name, v.key, v.start, math.ceil(10 * v.low) / 10, math.floor(10 * v.high) / 10, v.unit) for v in self.twines]
        starts = after_of(found)[:4] + [max(v.low, d) for v, d in zip(twines, after_of(found)[5:])]
        made = self.bench.optimise("cut", self.bench.text(self.plain[:4] + twines, starts, self.limits(), more=cut))
        diameters = [math.ceil(10 * d - 1e-6) / 10 for d in after_of(made)[4:]]
        cut += [f"panels.{p}.twine.diameter={d} mm" for p, d in zip(PANELS, diameters)]
        nearest = round(after_of(made)[0] / LIFT * FLOATS)
        for floats in (nearest, nearest + 1, nearest - 1, nearest + 2):
            whole = [*cut, f"elements.floats.float.buoyancy={floats * LIFT / FLOATS:.10g} kgf"]
            made = self.bench.optimise("sewn", self.bench.text(self.plain[1:4], after_of(made)[-3:] if len(made["variables"]) == 3 else
                                                               after_of(made)[1:4], self.limits(), more=whole))
            if made["status"] == "optimal":
                break
        self.say(made, floats, whole)
        return made

    def say(self, made, floats, whole):
        checked = self.bench.call("check", self.bench.folder / "sewn.optimum" / "scene.toml")
        said = re.findall(r"\d+ errors, \d+ warnings", checked.stdout)
        print(f"\nsewn, {floats} floats instead of {FLOATS}: {made['status']}, {made['points']} solves, {made['objective']['after']:.4f} kN, "
              f"{100 * (1 - made['objective']['after'] / self.drag):.2f} %; check: {', '.join(said) or checked.stderr}")
        print(", ".join([*(f"{r['name']} {r['after']:.5g} {r['unit']}" for r in made["variables"]), *(word.replace("panels.", "") for word in whole)]))
        self.require(made["status"] == "optimal" and checked.returncode == 0, "a plan that check passes")

    def compare_divided_anew(self, made):
        """Drag, height and spread of both gears on meshes of their own, as `netloft run` divides them."""
        print("\n| nodes | drag at the start, sewn [kN] | less | headline at the start, sewn [m] | wing ends at the start, sewn [m] |\n"
              "|---|---|---|---|---|")
        for nodes in (self.words.nodes * k for k in (1, 2, 4)):
            pair = [self.bench.run([*words, f"gear.nodes={nodes}"])["gear"]["figures"] for words in (self.start, made["set"])]
            drag, height, wings = ([f[key] for f in pair] for key in ("drag/all/x", "mouth/headline_height", "mouth/upper_wing_spread"))
            print(f"| {nodes} | {drag[0] / 1000:.3f}, {drag[1] / 1000:.3f} | {100 * (1 - drag[1] / drag[0]):.2f} % | {height[0]:.3f}, {height[1]:.3f} | "
                  f"{wings[0]:.3f}, {wings[1]:.3f} |")

    def write(self, found, made):
        place = self.bench.library / "optima"
        place.mkdir(exist_ok=True)
        every = self.plain + self.twines
        head = "# SPDX-License-Identifier: BSD-3-Clause\n# {} Written by tests/bench/optimum.py; tests/bench/optimum.md has the answers.\n"
        text = self.bench.text(every, [v.start for v in every], self.limits(), scene=SCENE)
        (place / "83-112-least-drag.toml").write_text(head.format("The 83-112 in the flume tank at 3 knots with the least drag.") + text)
        plan = (self.bench.folder / "sewn.optimum" / "scene.toml").read_text().splitlines()
        kept = [line for line in plan if not line.startswith(("#", "include", "gear.nodes", "analysis.", "\n"))]
        (place / "83-112-least-drag-plan.toml").write_text(
            head.format("The optimum of 83-112-least-drag.toml as a plan that can be sewn.") + f'include = ["{SCENE}"]\n' + "\n".join(kept) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft", type=lambda p: str(Path(p).resolve()))
    parser.add_argument("library", type=lambda p: Path(p).resolve())
    parser.add_argument("--nodes", type=int, default=600)
    parser.add_argument("--starts", type=int, default=5)
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        study = Study(Bench(words.netloft, words.library, words.nodes, Path(folder)), words)
        print(f"at the start: drag {study.drag:.3f} kN, headline {study.figures['mouth/headline_height']:.3f} m, "
              f"wing ends {study.figures['mouth/upper_wing_spread']:.3f} m\n")
        found = study.compare()
        if found[0]["status"] == "optimal":
            print_changes(found[0], found)
            made = study.sew(found[0])
            study.compare_divided_anew(made)
            if words.draws:
                print_band(study.bench, study.start, made["set"], words.draws)
            if words.write:
                study.write(found[0], made)
        if words.check and study.missed:
            raise SystemExit("missed: " + ", ".join(study.missed))


if __name__ == "__main__":
    main()
