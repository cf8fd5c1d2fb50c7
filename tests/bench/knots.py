#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the error of netting by triangles: a gear in which every knot is a node against the same gear in triangles.

    knots.py NETLOFT SCENE.toml [--nodes 2000,30000] [--set KEY=VALUE] [--results FOLDER]

Prints nodes, unknowns, time and peak memory of each, and every figure of the report by knots, with the figure by triangles in per cent of
that by knots. Results that are in the folder already are not computed again.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time


def run(options, nodes, folder):
    """Runs the gear once; stores the program's answer with wall time, processor time and memory."""
    kept = folder / f"{nodes}.json"
    if kept.exists():
        return json.loads(kept.read_text())
    words = [word for one in [f"gear.nodes={nodes}", *options.set] for word in ("--set", one)]
    command = [options.netloft, "run", str(options.scene), "--json", "--threads", str(options.threads), "-o", str(folder / f"{nodes}.hdf"), "--overwrite", *words]
    before = time.monotonic()
    with open(folder / f"{nodes}.out", "w") as out:
        process = subprocess.Popen(command, stdout=out, stdin=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
    said = json.loads((folder / f"{nodes}.out").read_text())
    if said["status"] == "wrong input":
        sys.exit(said["reason"])
    if said["status"] != "converged":
        print(f"{nodes}: {said['status']} (exit {os.waitstatus_to_exitcode(status)}): {said.get('reason', '')}", file=sys.stderr)
    said["cost"] = {"wall": time.monotonic() - before, "cpu": used.ru_utime + used.ru_stime, "mebibytes": used.ru_maxrss / 1024}
    kept.write_text(json.dumps(said))
    return said


def figures_of(said):
    """Returns numbers of the report by name: results of the scene, and those of the gear that are not tables of parts."""
    figures = dict(said["results"])

    def add(name, value):
        if isinstance(value, dict):
            for key, one in value.items():
                add(f"{name}/{key}", one)
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            figures[name] = value

    for key, value in said.get("gear", {}).get("figures", {}).items():
        add(key, value)
    return {name: value for name, value in figures.items() if "by_part" not in name}


def print_table(found):
    for nodes, said in found.items():
        cost = said["cost"]
        print(f"{nodes:>8} {said['unknowns']:>9} unknowns {cost['wall']:>9.1f} s wall {cost['cpu']:>9.1f} s CPU {cost['mebibytes']:>8.0f} MiB "
              f"{said['factorisations']:>5} factorisations")
    names = list(found)
    exact = figures_of(found[names[-1]])
    print(f"{'figure':<44} {names[-1]:>14}" + "".join(f"{nodes:>12} %" for nodes in names[:-1]))
    for figure, value in exact.items():
        others = [figures_of(found[nodes]).get(figure) for nodes in names[:-1]]
        told = "".join(f"{100 * (other / value - 1):>14.3f}" if other is not None and value else f"{'-':>14}" for other in others)
        print(f"{figure:<44} {value:>14.6g}{told}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--nodes", default="2000,30000")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--results", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = options.results or pathlib.Path(name)
        folder.mkdir(exist_ok=True)
        print_table({nodes: run(options, nodes, folder) for nodes in [*options.nodes.split(","), "knots"]})


if __name__ == "__main__":
    main()
