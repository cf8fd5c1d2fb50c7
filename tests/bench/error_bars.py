#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the error bars of `netloft run --error` on twenty gears, which are solved again with ten times the nodes.

    error_bars.py NETLOFT LIBRARY [--nodes 300] [--times 10] [--jobs 1] [--only N,M] [--that-chose] [--by-one-step]

Prints, for every gear and for all, how many results (figures) have an error within their bar, the median of bar over error,
and the figures that do not converge by the report. Figures that do not vary with the mesh are left out. None of the twenty
gears was used to choose the rule for the bars; tests/bench/error_bars.md lists them. --that-chose: tests the eleven gears with
which its factor of safety was chosen. --by-one-step: tests another bar instead, the change by one Newton step on the finer mesh from
the shape on the own one, which is to first order what residuals on the finer mesh say if they are weighted with adjoint variables.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

SAME = 1e-9  # relative; a figure that varies less does not depend on the mesh


def gears(library, that_chose=False):
    flume = str(library / "scenes/83-112-flume-{}kn.toml")
    four = str(library / "scenes/four-panel.toml")
    bag = str(library / "scenes/codend-from-plan.toml")

    def trawl(speed, *words):
        return flume.format(speed), list(words)

    def point(across, height):
        return f'points.towing-point.at=["-51.1 m", "{across} m", "{height} m"]'

    def panel(speed, *words):
        return four, [f'water.current=["{speed} m/s", 0, 0]', *words]

    def codend(*words):  # the current determines which of two mirrored shapes the cod-end takes
        return bag, ['water.current=["0.2 m/s", 0, 0]', *words]

    if that_chose:
        return [
            trawl("3.0"), trawl("4.0"), trawl("3.0", "floats.headline.spread=60 along headrope"), trawl("3.0", point(29, -18.9)),
            trawl("3.0", "elements.netting.drag={law=\"hydro/loland\"}"), panel(1.0), panel(1.5), panel(2.0),
            panel(1.5, 'points.door.at=["0 m", "4.5 m", "-30 m"]'),
            codend("parts.catch.catch.meshes=20"), codend("parts.catch.catch.meshes=60"),
        ]
    return [
        trawl("2.5"), trawl("3.5"), trawl("3.0", "tow.speed=3.3 kn"), trawl("4.0", point(28, -19)),
        trawl("3.0", point(27.5, -18.3)), trawl("3.0", "floats.headline.spread=40 along headrope"),
        trawl("3.5", "elements.netting.twine.diameter=1.8 mm"), trawl("3.0", "ropes.footrope.rope=6x19-fc-19mm"),
        trawl("3.0", "elements.netting.drag={law=\"hydro/morison-reynolds\"}"),
        trawl("4.0", "parts.bed.seabed.friction=0.5"),
        panel(1.2), panel(1.8), panel(1.5, "ropes.footrope.rope=short-link-13mm"),
        panel(1.5, 'points.door.at=["0 m", "4 m", "-30 m"]'), panel(1.3, "elements.netting.twine.diameter=3 mm"),
        panel(1.6, "floats.headline-floats.spread=8 along headline"),
        codend(), codend("parts.catch.catch.meshes=40"), codend("parts.catch.catch.pressure=800 Pa"),
        codend("elements.netting.twine.EA=3 kN"),
    ]


def run(program, gear, nodes, *flags, output=None):
    scene, words = gear
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", scene, "--json", "-o", output or folder + "/result.hdf", *flags]
        for word in words + [f"gear.nodes={nodes}", "gear.size=0"]:
            command += ["--set", word]
        done = subprocess.run(command, capture_output=True, text=True)
    try:
        return json.loads(done.stdout)
    except ValueError:
        sys.exit(f"{' '.join(command)} gave no result:\n{done.stderr}")


def figures(result):
    """Returns for each name: value, error bar or None, and whether the report says that it does not converge."""
    said = result["mesh_note"] or ""
    errors = dict(result["errors"], **result["gear"]["errors"])
    values = dict(result["results"], **result["gear"]["figures"])
    all_of = {}
    for name, value in values.items():
        error = errors.get(name, {})
        bar = error.get("mesh")
        all_of[name] = (value, None if bar is None else bar + (error.get("solver") or 0),
                        name + " does not converge" in said)
    return all_of


class Count:
    def __init__(self):
        self.within, self.beyond, self.said, self.ratios, self.worst = 0, 0, 0, [], (0, "")

    def note(self, name, value, bar, diverges, truth):
        if not all(isinstance(x, float) and math.isfinite(x) for x in (value, truth)):
            return
        error = abs(value - truth)
        if diverges:
            self.said += 1
        elif bar is not None and (error > SAME * abs(truth) or bar > SAME * abs(truth)):
            self.within += error <= bar
            self.beyond += error > bar
            if error > 0:
                self.ratios.append(bar / error)
            self.worst = max(self.worst, (error / bar if bar else math.inf, name))

    def add(self, other):
        self.within += other.within
        self.beyond += other.beyond
        self.said += other.said
        self.ratios += other.ratios
        self.worst = max(self.worst, other.worst)

    def line(self, title):
        all_of = self.within + self.beyond
        ratio = statistics.median(self.ratios) if self.ratios else math.nan
        return (f"| {title} | {all_of} | {100 * self.within / max(all_of, 1):.1f} | {ratio:.1f} | {self.said} | "
                f"{self.worst[0]:.1f}, {self.worst[1]} |")


def solve(program, gear, nodes, times, by_one_step):
    """The result on the own mesh, and its figures with their bars."""
    if not by_one_step:
        own = run(program, gear, nodes, "--error")
        return own, figures(own)
    with tempfile.TemporaryDirectory() as folder:
        shape = folder + "/own.hdf"
        own = run(program, gear, nodes, output=shape)
        step = figures(run(program, gear, nodes * times, "--start-from", shape, "--strategy", "direct", "--solver", "newton:method=classic",
                           "--set", "analysis.max_iterations=1"))
    return own, {name: (value, abs(step[name][0] - value), False) for name, (value, _, _) in figures(own).items()
                 if name in step and all(isinstance(x, float) for x in (value, step[name][0]))}


def judge(program, gear, nodes, times, by_one_step):
    own, bars = solve(program, gear, nodes, times, by_one_step)
    fine = run(program, gear, nodes * times)
    count = Count()
    fine_values = figures(fine)
    for name, (value, bar, diverges) in bars.items():
        if name in fine_values:
            count.note(name, value, bar, diverges, fine_values[name][0])
    return count, own, fine


def title_of(gear):
    return pathlib.Path(gear[0]).stem + "".join(" " + word for word in gear[1]).replace("|", "")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("library", type=pathlib.Path)
    arguments.add_argument("--nodes", type=int, default=300)
    arguments.add_argument("--times", type=int, default=10)
    arguments.add_argument("--jobs", type=int, default=1)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--that-chose", action="store_true")
    arguments.add_argument("--by-one-step", action="store_true")
    options = arguments.parse_args()
    chosen = gears(options.library, options.that_chose)
    if options.only:
        chosen = [chosen[int(n)] for n in options.only.split(",")]
    print("| gear | figures | within their bar [%] | median of bar over error | do not converge | worst error over bar |")
    print("|---|---|---|---|---|---|")
    total = Count()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        work = [pool.submit(judge, options.program, gear, options.nodes, options.times, options.by_one_step) for gear in chosen]
        for gear, done in zip(chosen, work):
            count, own, fine = done.result()
            total.add(count)
            note = "".join(f" ({what}: {r['status']})" for what, r in (("own", own), ("fine", fine))
                           if r["status"] != "converged")
            print(count.line(title_of(gear) + note), flush=True)
    print(total.line("all"))


if __name__ == "__main__":
    main()
