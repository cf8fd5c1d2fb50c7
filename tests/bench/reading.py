#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures whether the time to read a scene is proportional to its size.

    reading.py PROGRAM [--kinds ropes,floats,…] [--most 100000] [--seconds 1000] [--check 20]

For each kind of object, `netloft plan` reads scenes with 10, 100, … of them. The table has the processor time of the whole program, the time for each object without the start of the program, and its ratio to that in a scene with a tenth of the objects. With --check
the exit code is 1 if the last of these ratios is larger than that.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

LINES_OF_A_FILE = 40000  # a file may have 16 MiB
ROPE = 'rope = { diameter = "20 mm", EA = "1 MN", density = 1200 }'
FLOAT = 'float = { buoyancy = "10 N", mass = "1 kg", diameter = "20 cm" }'
TWINE = 'twine = { diameter = "2 mm", EA = "10 kN", density = 950 }'
SOLID = "body = { mass = 900, volume = 0.1, inertia_x = 60, inertia_y = 200, inertia_z = 200, drag_x = 0.5, drag_y = 1, drag_z = 1 }"
NET = ['[panels.net]\nmesh = "50 mm"\ntwine = "pe-braided-2mm"\nfore = 90\ndepth = 36\nsides = "AN"\nopen = ["aft", "sides"]',
       f'[ropes.headline]\nlength = "3 m"\n{ROPE}\nstands = "middle"',
       '[[hang]]\nedge = "net.fore"\non = "headline"\nlength = "2.9 m"', "[gear]\nnodes = 100"]


def rope(name, cells, x):
    return f'[parts.{name}]\ntype = "rope/bar"\nlength = "10 m"\ncells = {cells}\nsketch = [[{x}, 0, 0], [{x + 10}, 0, 0]]\n{ROPE}'


def hold(on):
    return f"[[hold]]\non = {on}"


def listed(names):
    return "[" + ", ".join(f'"{name}"' for name in names) + "]"


def ropes(n):
    """A chain of ropes, joined end to end and held at one."""
    yield from (rope(f"r{i}", 1, 10 * i) for i in range(n))
    yield from (f'[[join]]\npoints = ["r{i}.end", "r{i + 1}.start"]' for i in range(n - 1))
    yield hold('"r0.start"')


def floats(n):
    """Floats, each on a node of one rope."""
    yield rope("r", n, 0)
    yield from (f'[parts.f{i}]\ntype = "float/float"\non = "r.node-{i}"\n{FLOAT}' for i in range(n))
    yield hold('["r.start", "r.end"]')


def points(n):
    """Floats, each held by a separate hold."""
    for i in range(n):
        yield f'[parts.f{i}]\ntype = "float/float"\nat = [{i}, 0, 0]\n{FLOAT}'
        yield hold(f'"f{i}"')


def bundle(n):
    """Ropes whose ends are joined in one point."""
    yield from (rope(f"r{i}", 1, 0) for i in range(n))
    yield f"[[join]]\npoints = {listed(f'r{i}.start' for i in range(n))}"
    yield hold('"r0.start"')


def nodes(n):
    """The nodes of one rope, held by one hold and loaded by one part that name them all."""
    yield rope("r", n, 0)
    yield hold(listed(f"r.node-{i}" for i in range(n)))
    yield f'[parts.f]\ntype = "float/float"\n{FLOAT}\non = {listed(f"r.node-{i}" for i in range(n))}'


def bodies(n):
    """Rigid bodies, each with a point and held at its origin."""
    yield rope("r", 1, 0)
    yield hold('["r.start", "r.end"]')
    for i in range(n):
        yield f'[bodies.b{i}]\ntype = "body/solid"\nat = [{i}, 0, 0]\npoints = {{ fore = [-0.6, 0, 0.3] }}\n{SOLID}'
        yield hold(f'"b{i}.origin"')


def beds(n):
    """Nodes of one rope, each on a separate bed; all beds are different planes."""
    yield rope("r", n, 0)
    yield from (f'[parts.b{i}]\ntype = "seabed/plane"\non = "r.node-{i}"\nseabed = {{ depth = {50 + i / n}, stiffness = 1e5 }}' for i in range(n))
    yield hold('["r.start", "r.end"]')


def laws(n):
    """Ropes in a current, each with a different law."""
    yield "[water]\ncurrent = [1, 0, 0]"
    for i in range(n):
        yield rope(f"r{i}", 1, 10 * i) + f'\ndrag = {{ law = "hydro/morison", normal = {1 + i / n} }}'
        yield hold(f'["r{i}.start", "r{i}.end"]')


def panels(n):
    """Panels side by side, each held along an edge."""
    for i in range(n):
        yield (f'[parts.p{i}]\ntype = "priour/triangle"\npanel = {{ across = 4, along = 4, bar = "0.1 m" }}\ncells = [2, 2]\n{TWINE}\n'
               f'sketch = [[{i}, 0, 0], [{i + 0.5}, 0, 0], [{i + 0.5}, 0, -0.5], [{i}, 0, -0.5]]')
        yield hold(f'"p{i}.fore"')


def idle(n):
    """Ropes whose damping has no effect."""
    for i in range(n):
        yield rope(f"r{i}", 1, 10 * i).replace("density", "damping = 1, density")
        yield hold(f'["r{i}.start", "r{i}.end"]')


def results(n):
    """Results of one rope."""
    yield rope("r", 2, 0)
    yield hold('["r.start", "r.end"]')
    yield "[results]"
    yield from (f'x{i} = {{ of = "r.end", take = "reaction" }}' for i in range(n))


def plan_floats(n):
    """Floats of a net plan, along its headline."""
    yield from NET
    yield from (f'[floats.f{i}]\n{FLOAT}\nspread = "1 at headline.middle"' for i in range(n))
    yield hold('"headline"')


def plan_panels(n):
    """Panels of a net plan, sewn one behind another."""
    net, *rest = NET
    yield from (net.replace('"aft", ', ""), *rest)
    for i in range(n):
        ends = '["aft", "sides"]' if i + 1 == n else '["sides"]'
        yield f'[panels.p{i}]\nmesh = "50 mm"\ntwine = "pe-braided-2mm"\nfore = 90\ndepth = 2\nsides = "AN"\nopen = {ends}'
        yield f'[[join]]\nedges = ["{f"p{i - 1}" if i else "net"}.aft", "p{i}.fore"]'
    yield hold('"headline"')


def plan_ropes(n):
    """Ropes of a net plan, one after another."""
    yield from NET
    for i in range(n):
        before = f"r{i - 1}.end" if i else "headline.middle"
        yield f'[ropes.r{i}]\nstands = "alone"\nlength = "1 m"\n{ROPE}\nbetween = ["{before}", "p{i}"]\n[points.p{i}]\nstands = "middle"'
    yield hold('"headline"')


KINDS = {kind.__name__: kind for kind in (
    ropes, floats, points, bundle, nodes, bodies, beds, laws, panels, idle, results, plan_floats, plan_panels, plan_ropes)}


def write(folder, lines):
    """A scene that includes files of the allowed size; the last one contains the tables that may appear only once."""
    lines = list(lines)
    names = []
    for begin in range(0, len(lines), LINES_OF_A_FILE):
        names.append(f"part-{begin}.toml")
        text = "\n".join(lines[begin:begin + LINES_OF_A_FILE])
        if begin and "[results]" in lines[:begin]:
            text = "[results]\n" + text
        Path(folder, names[-1]).write_text(text + "\n")
    Path(folder, "scene.toml").write_text(f"include = {listed(names)}\n")


def seconds(program, folder):
    """Processor time of reading and planning a scene [s]."""
    child = subprocess.Popen([program, "plan", "--threads", "1", "scene.toml"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    text = child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"netloft plan ends with {child.returncode}:\n{text.decode()[:2000]}")
    return usage.ru_utime + usage.ru_stime


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--kinds", default=",".join(KINDS))
    options.add_argument("--most", type=int, default=100000)
    options.add_argument("--seconds", type=float, default=1000, help="leave out scenes that would take longer, judged by the scene with a tenth of the objects")
    options.add_argument("--check", type=float, default=0)
    arguments = options.parse_args()
    program, is_linear = os.path.abspath(arguments.program), True
    print(f"{'kind':<12} {'number':>8} {'[s]':>8} {'[us] each':>10} {'ratio':>6}", flush=True)
    for kind in arguments.kinds.split(","):
        number, start, before, took = 10, None, None, 0
        while number <= arguments.most and 10 * took <= arguments.seconds:
            with tempfile.TemporaryDirectory() as folder:
                write(folder, KINDS[kind](number))
                took = seconds(program, folder)
            start = took if start is None else start
            net, ratio = took - start, None
            if before:
                ratio = net / before
            print(f"{kind:<12} {number:>8} {took:>8.2f} {1e6 * net / number:>10.1f} {f'{ratio:.1f}' if ratio else '':>6}", flush=True)
            before, number = net if net > 0.02 else None, 10 * number
        is_linear &= not (arguments.check and ratio and ratio > arguments.check)
    return 0 if is_linear else 1


if __name__ == "__main__":
    sys.exit(main())
