#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures how much the parameters of a strategy matter: each is halved and doubled on hard cases with a new seed.

    sensitivity.py NETLOFT SUITE --seed 2041 [--strategy auto] [--of auto] [--of tension/stages] [--of newton] [--size small] [--case TEXT] [--jobs 1]

Prints a Markdown table: right / claimed wrong / work with half the default, the default, and twice the default. A parameter
whose row says "changes nothing" can be removed. The seed must not be one with which the parameter was chosen.
"""
import argparse
import json
import math
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

LITTLE = 0.05  # relative change of the work that counts as none: machines and seeds differ by more
DONE, NOT_ALL_RIGHT = 0, 3


class Outcome:
    """The result of one run of the suite."""

    def __init__(self, matrix):
        self.cells = [(c["name"], c["size"], c["where"], c["iterations"], c["factorisations"]) for c in matrix["cases"]]
        self.right = sum(c["right"] for c in matrix["cases"])
        self.claimed_wrong = sum(c["claimed_wrong"] for c in matrix["cases"])
        self.work = sum(c.get("work") or c["factorisations"] for c in matrix["cases"])

    def __str__(self):
        return f"{self.right} / {self.claimed_wrong} / {self.work:.0f}"

    def verdict(self):
        return self.right, self.claimed_wrong


class Parameter:
    """A number among the options of a component, with its range."""

    def __init__(self, component, described):
        self.component, self.name = component, described["name"]
        self.is_whole = described["kind"] == "integer"
        self.default = float(described["default"])
        lo, hi = re.match(r"[\[(]\s*(.+?),\s*(.+?)\s*[\])]", described["allowed"]).groups()
        self.lo, self.hi = float(lo.replace("∞", "inf")), float(hi.replace("∞", "inf"))

    def scaled(self, factor):
        """Returns the default times a factor, as text for the program, or None if that is the default again."""
        value = min(max(self.default * factor, self.lo), self.hi)
        if self.is_whole:
            value = math.floor(value) if factor < 1 else math.ceil(value)
        return None if value == self.default else format(value, "d" if self.is_whole else ".17g")

    def setting(self, value):
        plugin, _, own = self.component.partition("/")
        table = plugin if own in ("", plugin) else f"{plugin}.{own}"
        return f"analysis.{table}.{self.name}={value}"


def is_number(described):
    """Whether an option is a number with a range and a default."""
    has_range = re.match(r"[\[(].+,.+[\])]", described["allowed"])
    return described["kind"] in ("real", "integer") and has_range and re.fullmatch(r"[-+0-9.e]+", described["default"])


class Bench:
    def __init__(self, words):
        self.words = words

    @staticmethod
    def answer(program, *arguments):
        ended = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
        if ended.returncode not in (DONE, NOT_ALL_RIGHT):
            raise SystemExit(f"{program} {' '.join(arguments)}: exit {ended.returncode}\n{ended.stderr}")
        return json.loads(ended.stdout)

    def parameters(self):
        """Returns the numbers among the options of all named components, and the options that are not numbers."""
        numbers, others = [], []
        for component in self.words.of:
            for described in self.answer(self.words.netloft, "describe", component, "--json")["parameters"]:
                described["default"] = str(described.get("default", ""))
                if is_number(described):
                    numbers.append(Parameter(component, described))
                else:
                    others.append(f"{component}: {described['name']}")
        return numbers, others

    def run(self, setting=None):
        w = self.words
        arguments = [w.suite, "--strategy", w.strategy, "--seed", str(w.seed), "--size", w.size, "--json"]
        if w.case:
            arguments += ["--case", w.case]
        if w.work:
            arguments += ["--work", str(w.work)]
        if w.seconds_per_case:
            arguments += ["--seconds-per-case", str(w.seconds_per_case)]
        if setting:
            arguments += ["--set", setting]
        return Outcome(self.answer(w.hard_cases, *arguments))

    def row(self, parameter, base):
        half, double = (self.run(parameter.setting(v)) if v else None for v in map(parameter.scaled, (0.5, 2)))
        cells = [str(outcome) if outcome else "–" for outcome in (half, base, double)]
        return [f"{parameter.component}: {parameter.name}", f"{parameter.default:g}", *cells, note(base, half, double)]


def note(base, *others):
    """Returns in a few words what changes of a number do to the results."""
    tried = [o for o in others if o]
    if not tried:
        return "not scaled, because its double and its half are the default"
    if all(o.cells == base.cells for o in tried):
        return "**changes nothing**"
    if all(o.verdict() == base.verdict() and abs(o.work - base.work) <= LITTLE * base.work for o in tried):
        return "changes little"
    return ""


def parse(arguments):
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("netloft", help="the program; hard_cases must be in the same folder")
    p.add_argument("suite", help="folder of the suite: tests/stability")
    p.add_argument("--seed", type=int, required=True, help="a seed with which no parameter was chosen")
    p.add_argument("--of", action="append", help="component whose numbers are changed: the strategy, a strategy that it calls, or its solver; may be repeated")
    p.add_argument("--strategy", default="auto", help="strategy that is run")
    p.add_argument("--size", default="small")
    p.add_argument("--case", help="only cases whose name contains this")
    p.add_argument("--work", type=float, help="for one case, in factorisations")
    p.add_argument("--seconds-per-case", type=float)
    p.add_argument("--jobs", type=int, default=1, help="number of runs at a time; use one with budgets in seconds")
    words = p.parse_args(arguments)
    words.of = words.of or [words.strategy]
    words.hard_cases = Path(shutil.which(words.netloft) or words.netloft).with_name("hard_cases")
    return words


def main(arguments):
    bench = Bench(parse(arguments))
    numbers, others = bench.parameters()
    base = bench.run()
    print(f"Seed {bench.words.seed}, {len(base.cells)} cases: right / claimed wrong / work\n")
    print("| parameter | default | half | as it is | double | |\n|---|---|---|---|---|---|", flush=True)
    with ThreadPoolExecutor(bench.words.jobs) as pool:
        for row in pool.map(lambda p: bench.row(p, base), numbers):
            print("| " + " | ".join(row) + " |", flush=True)
    if others:
        print("\nNo numbers: " + ", ".join(others))


if __name__ == "__main__":
    main(sys.argv[1:])
