#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The 83-112 Eastern survey trawl at sea: wing spread and height at two depths, with a single spreading force of the doors.

    sea.py NETLOFT [--nodes 1000]

The force is found from the wing spread at 99 m; all other figures are predicted. Prints the table of tests/validation/README.md.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

SCENE = pathlib.Path(__file__).parent / "doors-as-points.toml"
# Depth [m]: wire out [m], wing spread [m], headline height [m]: means of survey hauls of NOAA, Alaska Fisheries Science Center.
MEASURED = {99: (332, 17.42, 2.11), 66: (240, 16.68, 2.23)}
FITTED_AT, NEAR = 99, 0.01  # [m]


def solve(program, nodes, depth, force):
    wire = MEASURED[depth][0]
    settings = (f"gear.nodes={nodes}", f"parts.bed.seabed.depth={depth} m", f"ropes.warp.length={wire} m", f"parts.spread.force.y={force} N",
                f'points.block.at=["-{wire + 40} m", "3 m", "0 m"]')
    with tempfile.TemporaryDirectory() as folder:
        words = [word for each in settings for word in ("--set", each)]
        done = subprocess.run([program, "run", SCENE, "--json", "-o", folder + "/sea.hdf", *words], capture_output=True, text=True)
    result = json.loads(done.stdout)
    if result["status"] not in ("converged", "unstable"):
        sys.exit(f"{depth} m: {result['reason']}\n{done.stderr}")
    figures = result["gear"]["figures"]
    return figures["mouth/upper_wing_spread"], figures["mouth/headline_height"], result["status"]


def find_force(program, nodes):
    """By the secant method [N]."""
    wanted = MEASURED[FITTED_AT][1]
    forces, spreads = [3000.0, 4000.0], []
    for _ in range(8):
        while len(spreads) < len(forces):
            spreads.append(solve(program, nodes, FITTED_AT, forces[len(spreads)])[0])
        if abs(spreads[-1] - wanted) < NEAR:
            return forces[-1]
        forces.append(forces[-1] + (wanted - spreads[-1]) * (forces[-1] - forces[-2]) / (spreads[-1] - spreads[-2]))
    sys.exit("no force gives that spread")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("--nodes", type=int, default=1000)
    options = arguments.parse_args()
    force = find_force(options.program, options.nodes)
    print(f"| depth [m] | wire out [m] | wing spread [m], with {force / 1000:.2f} kN a door | error | headline height [m] | error |")
    print("|" + "---|" * 6)
    for depth, (wire, spread, height) in MEASURED.items():
        found = solve(options.program, options.nodes, depth, force)
        print(f"| {depth} | {wire} | {found[0]:.2f} ({spread}){' *' if depth == FITTED_AT else ''} | {100 * (found[0] / spread - 1):+.1f} % | "
              f"{found[1]:.2f} ({height}) | {100 * (found[1] / height - 1):+.1f} % |{'' if found[2] == 'converged' else ' ' + found[2]}")


if __name__ == "__main__":
    main()
