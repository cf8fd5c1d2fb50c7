#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The 83-112 Eastern trawl in the flume tank: compares computed with measured figures, as in the tables of tests/validation/README.md.

    flume.py NETLOFT LIBRARY [--nodes 1000] [--check]

Five speeds, a rig change at 3.0 knots, the same gear in water that it does not slow, and at full scale in the same water, where only Reynolds
numbers differ (floats keep one drag coefficient there: smooth spheres have their drag crisis at these speeds). --check: exit 1 if a
figure is beyond ALLOWED, with its name.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib

# Knots: headline height [m], wing-end height [m], lower spread [m], tension of the bridles [t]; means where there are two set-ups.
MEASURED = {"2.0": (2.64, 1.35, 20.1, 1.293), "2.5": (2.36, 1.40, 20.3, 1.784), "3.0": (1.96, 1.15, 20.0, 2.390),
            "3.5": (1.68, 1.10, 20.2, 3.034), "4.0": (1.48, 1.00, 20.1, 3.765)}
ANGLE = (21.0, 22.4)  # [deg], all speeds
UPPER_SPREAD, BELT, TONNE = 17.5, -20.0, 9806.65
SCALED = ("2.0", "3.0", "4.0")
RAISED = 0.8  # [m], the rig change, by which height went from 2.00 to 2.16 m and wing ends from 1.2 to 1.5 m
# Differences that --check allows: relative, for the angle in degrees. Wing ends at 2.0 knots and the lower spread
# are as far off as now, so that these differences do not grow: that says nothing about their worth.
ALLOWED = {"height": 0.06, "height at 2.0": 0.12, "wing end": 0.10, "wing end at 2.0": 0.3, "lower spread": 0.06, "tension": 0.04,
           "angle": 1.5, "exponent": (1.51, 1.59)}


def solve(program, library, knots, nodes, *settings):
    scene = library / f"scenes/83-112-flume-{knots}kn.toml"
    with tempfile.TemporaryDirectory() as folder:
        words = [word for each in (f"gear.nodes={nodes}", *settings) for word in ("--set", each)]
        done = subprocess.run([program, "run", scene, "--json", "-o", folder + "/flume.hdf", *words], capture_output=True, text=True)
    result = json.loads(done.stdout)
    if result["status"] not in ("converged", "unstable"):
        sys.exit(f"{knots} kn: {result['reason']}\n{done.stderr}")
    figures = result["gear"]["figures"]
    pull = next(held["force"] for held in result["hold_forces"] if held["name"] == "towing-point")
    return {"status": result["status"], "height": figures["mouth/headline_height"], "wing end": result["results"]["wing_end_height"] - BELT,
            "upper spread": figures["mouth/upper_wing_spread"], "lower spread": figures["mouth/lower_wing_spread"],
            "area": figures["mouth/area"], "tension": figures["rigging/bridle/tension_start"] / TONNE,
            "angle": math.degrees(math.atan2(abs(pull[1]), abs(pull[0])))}


def exponent(tensions):
    """p of T ~ V^p through all speeds, by least squares of the logarithms."""
    x, y = [math.log(float(knots)) for knots in tensions], [math.log(t) for t in tensions.values()]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def beside(found, measured, digits):
    return f"{found:.{digits}f} ({measured:.{digits}f}) | {100 * (found / measured - 1):+.0f} %"


def speed_row(knots, f):
    height, wing_end, spread, tension = MEASURED[knots]
    product = f["height"] * (f["upper spread"] + f["lower spread"]) / 2
    return (f"| {knots} | {beside(f['height'], height, 2)} | {beside(f['wing end'], wing_end, 2)} | "
            f"{beside(f['lower spread'], spread, 1)} | {f['angle']:.1f} | {beside(f['tension'], tension, 3)} | "
            f"{beside(product, height * (UPPER_SPREAD + spread) / 2, 1)} | {f['area']:.1f} |")


def print_speeds(found):
    print("| knots | headline height [m] | error | wing-end height [m] | error | lower spread [m] | error | bridle angle [°] | "
          "tension of the bridles [t] | error | height × mean spread [m²] | error | area of the mouth [m²] |")
    print("|" + "---|" * 13)
    for knots, f in found.items():
        print(speed_row(knots, f))
    measured = {knots: row[3] for knots, row in MEASURED.items()}
    print(f"\nTension grows with the speed to the power {exponent(tensions_of(found)):.2f} (measured: {exponent(measured):.2f}).")


def tensions_of(found):
    return {knots: f["tension"] for knots, f in found.items()}


def print_rig(program, library, nodes, before):
    after = solve(program, library, "3.0", nodes, f"points.towing-point.at[2]={height_of_point(library) + RAISED:.2f} m")
    higher = 100 * (after["height"] / before["height"] - 1)
    print(f"\nTowing point {RAISED} m higher, at 3.0 knots: height {higher:+.0f} % (measured: +8 %), wing-end "
          f"height {after['wing end'] - before['wing end']:+.2f} m (measured: +0.3 m).")


def height_of_point(library):
    """Height of the towing point at 3.0 knots [m], from the scene."""
    scene = tomllib.loads((library / "scenes/83-112-flume-3.0kn.toml").read_text())
    return float(scene["points"]["towing-point"]["at"][2].removesuffix(" m"))


def print_scales(program, library, nodes, found):
    print("\n| knots | height [m], tank | at full scale | lower spread [m], tank | at full scale | tension [t], tank | at full scale |")
    print("|" + "---|" * 7)
    for knots in SCALED:
        tank, sea = found[knots], solve(program, library, knots, nodes, "water.model_scale=1", "elements.floats.float.drag_law=constant")
        mark = "" if sea["status"] == "converged" else " †"
        print(f"| {knots}{mark} | {tank['height']:.2f} | {sea['height']:.2f} | {tank['lower spread']:.1f} | {sea['lower spread']:.1f} | "
              f"{tank['tension']:.3f} | {sea['tension']:.3f} |")


def print_undisturbed(program, library, nodes):
    """The same net, held at the same points, in water that it does not slow."""
    found = {knots: solve(program, library, knots, nodes, "flow.type=none") for knots in MEASURED}
    heights, tensions = ([100 * (f[name] / MEASURED[knots][i] - 1) for knots, f in found.items()] for name, i in (("height", 0), ("tension", 3)))
    print(f"\nIn undisturbed water: headline height {heights[0]:+.0f} to {heights[-1]:+.0f} %, tension {tensions[0]:+.0f} to {tensions[-1]:+.0f} %, "
          f"the power {exponent(tensions_of(found)):.2f}.")


def misses(found, limits):
    """A sentence for each figure beyond its limit."""
    for knots, f in found.items():
        if f["status"] != "converged":
            yield f"{knots} kn: {f['status']}"
        measured = dict(zip(("height", "wing end", "lower spread", "tension"), MEASURED[knots]))
        for name, value in measured.items():
            allowed = limits.get(f"{name} at {knots}", limits[name])
            if abs(f[name] / value - 1) > allowed:
                yield f"{knots} kn: {name} is {f[name]:.3f}, measured {value}, allowed {100 * allowed:.0f} %"
        if not ANGLE[0] - limits["angle"] <= f["angle"] <= ANGLE[1] + limits["angle"]:
            yield f"{knots} kn: bridles stand at {f['angle']:.2f} degrees, measured {ANGLE}"
    low, high = limits["exponent"]
    if not low <= exponent(tensions_of(found)) <= high:
        yield f"tension grows with the speed to the power {exponent(tensions_of(found)):.3f}, not {low} to {high}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("library", type=pathlib.Path)
    arguments.add_argument("--nodes", type=int, default=1000)
    arguments.add_argument("--check", action="store_true")
    options = arguments.parse_args()
    found = {knots: solve(options.program, options.library, knots, options.nodes) for knots in MEASURED}
    print_speeds(found)
    if options.check:
        missed = list(misses(found, ALLOWED))
        sys.exit("\n".join(missed) if missed else 0)
    print_undisturbed(options.program, options.library, options.nodes)
    print_rig(options.program, options.library, options.nodes, found["3.0"])
    print_scales(options.program, options.library, options.nodes, found)


if __name__ == "__main__":
    main()
