#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the memory that `netloft plan` predicts with the memory that `netloft run` takes.

    memory.py NETLOFT SCENE.toml [--nodes 3400,34000,340000 | --nodes as-it-is] [--set KEY=VALUE] [--threads 1]

Prints, for every mesh, the unknowns, the predicted memory, the largest resident memory of the run, and their ratio.
"""
import argparse
import json
import os
import subprocess
import tempfile


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft")
    parser.add_argument("scene")
    parser.add_argument("--nodes", default="3400,34000,340000")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--threads", default="1")
    options = parser.parse_args()
    print(f"{'nodes':>8} {'unknowns':>9} {'foreseen [MiB]':>15} {'taken [MiB]':>12} {'ratio':>6}   status")
    for nodes in options.nodes.split(","):
        sizes = [] if nodes == "as-it-is" else [f"gear.nodes={nodes}"]
        words = [word for one in [*sizes, *options.set] for word in ("--set", one)] + ["--threads", options.threads, "--json"]
        plan = json.loads(subprocess.run([options.netloft, "plan", options.scene, *words], capture_output=True, text=True, check=True).stdout)
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + "/out", "w") as out:
                run = subprocess.Popen([options.netloft, "run", options.scene, "-o", folder + "/r.hdf", *words], stdout=out, stderr=subprocess.DEVNULL)
                _, _, used = os.wait4(run.pid, 0)
            status = json.loads(open(folder + "/out").read())["status"]
        foreseen, taken = plan["memory"]["foreseen"] / 2**20, used.ru_maxrss / 2**10
        print(f"{nodes:>8} {plan['unknowns']:>9} {foreseen:>15.0f} {taken:>12.0f} {foreseen / taken:>6.2f}   {status}", flush=True)


if __name__ == "__main__":
    main()
