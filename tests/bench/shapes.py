#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests whether the default strategy finds the shape of least energy if loads are borne by bending or by the opening of meshes.

  shapes.py HARD_CASES [--before HARD_CASES] [--seed 1] [--count 24]

Draws scenes of netting and ropes that resist bending, and disturbed starts, and solves each by the default strategy and by every one of its
attempts alone. Energies are compared with the least of a scene. --before is the program of another version, for its default strategy.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

ATTEMPTS = ("direct", "stiffness-steps", "pseudo-time", "coarse-to-fine", "tension/stages")
WORK = 3000  # for one strategy, in Newton iterations of the scene
KINDS = ("hanging", "stretched", "tube", "rope")


class Draw:
    """A random scene and a start of it."""

    def __init__(self, seed, number):
        self.random = random.Random(1000 * seed + number)
        self.kind = KINDS[number % len(KINDS)]
        self.text, self.mesh = self.rope() if self.kind == "rope" else self.netting()
        self.start_name, self.start = self.spoilt()

    def log(self, low, high):
        return low * (high / low) ** self.random.random()

    def netting(self):
        bar, netting = self.random.choice([0.02, 0.04, 0.06]), self.random.choice(["diamond", "t90", "square"])
        across, along = self.random.randrange(20, 80), self.random.randrange(20, 80)
        cell = bar if netting == "square" else 2 * bar
        width, height = across * cell * self.random.uniform(0.3, 0.75), along * cell * self.random.uniform(0.6, 1.0)
        moment = self.log(1e-4, 1)  # [N m/rad], of one knot
        stiffness = self.random.choice([f'EI = "{moment * bar / 12:.3g} N.m2"', f'opening_stiffness = "{moment:.3g} N.m/rad"'])
        place = (f'tube = {{ from = [0, 0, 0], to = [0, 0, {-height}], radius = {width / math.pi} }}\ncells = [12, 8]' if self.kind == "tube" else
                 f'sketch = [[{-width / 2}, 0, 0], [{width / 2}, 0, 0], [{width / 2}, 0, {-height}], [{-width / 2}, 0, {-height}]]\ncells = [8, 8]')
        sewn = '[[join]]\npoints = ["net.left", "net.right"]\n' if self.kind == "tube" else ""
        return f'''[parts.net]
type = "priour/triangle"
panel = {{ across = {across}, along = {along}, bar = "{bar} m", netting = "{netting}" }}
{place}
twine = {{ diameter = "{self.log(1e-3, 6e-3):.3g} m", EA = "{self.log(200, 2e4):.4g} N", density = 1140, {stiffness}, opening_angle = "{self.random.choice([0, 20, 45])} deg" }}
{sewn}{self.held("net.fore", *(["net.aft"] if self.kind == "stretched" else []))}''', 2 * bar

    def rope(self):
        length, span = self.log(2, 50), self.random.uniform(0.3, 0.98)
        return f'''[parts.rope]
type = "rope/bar"
length = {length}
cells = 40
sketch = [[0, 0, 0], [{span * length}, 0, {self.random.choice([0, -0.15 * length])}]]
rope = {{ diameter = "{self.log(6e-3, 4e-2):.3g} m", EA = "{self.log(1e4, 1e6):.4g} N", density = 1140, EI = "{self.log(1e-4, 10) * length:.3g} N.m2" }}
{self.held("rope.start", "rope.end")}''', length / 40

    @staticmethod
    def held(*points):
        return "".join(f'[[hold]]\non = "{point}"\n' for point in points)

    def spoilt(self):
        noise = f'{{ noise = "{self.log(0.1, 3) * self.mesh:.3g} m", seed = 1 }}'
        return self.random.choice([("drawing", ""), ("noise", noise), ("low", f"{{ scale = [1, 1, 0.4] }}, {noise}"), ("narrow", f"{{ scale = [0.2, 1, 1] }}, {noise}")])

    def write(self, folder, name):
        (folder / f"scene-{name}.txt").write_text("[water]\ndensity = 1025\ngravity = 9.81\n" + self.text)
        cells = "parts.rope.cells=40" if self.kind == "rope" else "parts.net.panel.bar=" + self.text.split('bar = "')[1].split('"')[0]
        (folder / f"{name}.toml").write_text(f'scene = "scene-{name}.txt"\n[sizes]\nsmall = ["{cells}"]\n[[case]]\nname = "{self.start_name}"\nabout = "drawn"\n'
                                             f'expected = "stable"\nstart = [{self.start}]\n')


def solve(program, folder, strategies):
    words = [word for one in strategies for word in ("--strategy", one)]
    ended = subprocess.run([program, folder, *words, "--size", "small", "--seconds-per-case", "600", "--work", str(WORK), "--json"],
                           capture_output=True, text=True)
    if not ended.stdout.startswith("{"):
        sys.exit(ended.stderr + ended.stdout)
    return {(case["name"], case["solver"]): case for case in json.loads(ended.stdout)["cases"]}


def field(case, least):
    if case["status"] != "converged":
        return f"{case['status']} | {case['factorisations']}"
    above = (case["energy"] - least) / max(abs(least), sys.float_info.min)
    return f"{100 * max(above, 0):.2g} % | {case['factorisations']}" if above > 1e-8 else f"least | {case['factorisations']}"


def summary(title, cases, least):
    above = [(case["energy"] - least[name]) / max(abs(least[name]), sys.float_info.min) if case["status"] == "converged" else math.inf
             for name, case in cases.items()]
    print(f"| {title} | {sum(a <= 1e-3 for a in above)} | {sum(1e-3 < a <= 1e-2 for a in above)} | {sum(1e-2 < a < math.inf for a in above)} | "
          f"{sum(a == math.inf for a in above)} | {sum(case['factorisations'] for case in cases.values())} |")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--before")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=24)
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "solvers.toml").write_text('[[solver]]\nstrategy = "auto"\n')
        for number in range(asked.count):
            draw = Draw(asked.seed, number)
            draw.write(folder, f"{draw.kind}-{number}")
        found = solve(asked.program, folder, ["auto", *ATTEMPTS])
        if asked.before:
            found |= {(case, "before"): one for (case, _), one in solve(asked.before, folder, ["auto"]).items()}
    columns = (["before"] if asked.before else []) + ["auto", *ATTEMPTS]
    names = list(dict.fromkeys(case for case, _ in found))
    least = {case: min((found[case, column]["energy"] for column in columns if found[case, column]["status"] == "converged"), default=math.nan)
             for case in names}
    known = [case for case in names if not math.isnan(least[case])]
    print("| strategy | within 0.1 % of the least energy | within 1 % | above | no equilibrium | factorisations |\n|---|---|---|---|---|---|")
    for column in columns:
        summary(column, {case: found[case, column] for case in known}, least)
    shown = [column for column in columns if column in ("before", "auto")]
    print("\n| scene | least energy [J] |" + "".join(f" {column}: above | factorisations |" for column in shown) + " attempt of least energy |\n|---|---|" +
          "---|---|" * len(shown) + "---|")
    for case in known:
        best = min((a for a in ATTEMPTS if found[case, a]["status"] == "converged"), key=lambda a: found[case, a]["energy"], default="none")
        print(f"| {case} | {least[case]:.5g} | " + " | ".join(field(found[case, column], least[case]) for column in shown) + f" | {best} |")


if __name__ == "__main__":
    main()
