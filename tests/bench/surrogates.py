#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the solves that a surrogate of headline height over eight numbers needs, from values alone and with gradients.

    surrogates.py PACKAGE [--designs N] [--most N] [--nodes N]

PACKAGE is the folder that contains netloft, build/release/python. Both surrogates are those of io/python/RECIPES.md. The error is the root mean square over 60 places that no surrogate saw, relative to the height.
"""
import argparse
import ast
import re
import sys
import warnings
from pathlib import Path

import numpy
from scipy.optimize import minimize
from scipy.stats import qmc

HEIGHT = "mouth/headline_height"
RECIPES = Path(__file__).resolve().parents[2] / "io/python/RECIPES.md"
RANGES = {"tow.speed": ("2.5 kn", "3.5 kn"), "points.towing-point.at[1]": ("27.7 m", "29.7 m"), "points.towing-point.at[2]": ("-19.6 m", "-18.5 m"),
          "elements.headline.float.buoyancy": ("20 N", "30 N"), "elements.footrope.rope.density": (3000, 5000),
          "elements.headrope.rope.density": (3000, 5000), "elements.netting.drag.measured_at": (1000, 4000), "parts.bed.seabed.friction": (0.2, 0.6)}
WANTED = 0.01  # largest error


def recipe():
    """The functions of the recipe for surrogates from gradients."""
    block = next(b for b in re.findall(r"^```python\n(.*?)^```", RECIPES.read_text(), re.M | re.S) if "def surrogate" in b)
    functions = ast.Module([node for node in ast.parse(block).body if isinstance(node, ast.FunctionDef)], [])
    names = {"numpy": numpy, "minimize": minimize}
    exec(compile(functions, str(RECIPES), "exec"), names)
    return names["surrogate"]


def width(low, high):
    return float(str(high).split()[0]) - float(str(low).split()[0])


def answers(netloft, gear, draws):
    widths = numpy.array([width(*r) for r in RANGES.values()])
    solved = [gear.with_(point).solve() for point in netloft.points(RANGES, draws)]
    slopes = [list(r.gradient(HEIGHT, list(RANGES)).values()) for r in solved]
    return numpy.array([float(r.report[HEIGHT]) for r in solved]), numpy.array(slopes) * widths


def needed(sizes, error):
    """The least number of solves whose error, and that of the next larger number, is within what is wanted; None: there is none."""
    before = None
    for size in sizes:
        within = error(size) <= WANTED
        if within and before:
            return before
        before = size if within else None
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", type=Path)
    parser.add_argument("--designs", type=int, default=3)
    parser.add_argument("--most", type=int, default=60)
    parser.add_argument("--nodes", type=int, default=300)
    options = parser.parse_args()
    sys.path.insert(0, str(options.package.resolve()))
    import netloft

    with_slopes = recipe()
    gear = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": options.nodes})
    places = qmc.LatinHypercube(len(RANGES), seed=100).random(60)
    heights = answers(netloft, gear, places)[0]
    print(f"heights from {heights.min():.2f} to {heights.max():.2f} m\n\n| design | solves with gradients | solves without | ratio |\n|---|---|---|---|")
    for design in range(1, options.designs + 1):
        def error(size, with_gradients):
            draws = qmc.LatinHypercube(len(RANGES), seed=design).random(size)
            values, slopes = answers(netloft, gear, draws)
            estimate = with_slopes(draws, values, slopes) if with_gradients else plain(draws, values)
            return numpy.sqrt(numpy.mean((estimate(places) / heights - 1) ** 2))

        few = needed(range(2, options.most + 1, 2), lambda size: error(size, True))
        many = needed(range(10, options.most + 1, 5), lambda size: error(size, False))
        print(f"| {design} | {few} | {many or f'> {options.most}'} | {many / few if many and few else float('nan'):.1f} |", flush=True)


def plain(points, values):
    """The same process from values alone, by scikit-learn."""
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

    warnings.filterwarnings("ignore", module="sklearn")  # lengths that end at their bounds, because a number hardly matters
    kernel = ConstantKernel(1.0) * RBF(numpy.ones(points.shape[1]), (0.05, 100)) + WhiteKernel(1e-6, (1e-10, 1e-2))
    process = GaussianProcessRegressor(kernel, normalize_y=True, n_restarts_optimizer=3, random_state=1).fit(points, values)
    return process.predict


if __name__ == "__main__":
    main()
