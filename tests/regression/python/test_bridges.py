# SPDX-License-Identifier: BSD-3-Clause
"""Derivatives that other libraries get through netloft.torch and netloft.jax equal differences of nearby equilibria. If the libraries are not installed, stubs/ has the few names that are needed.
"""
import sys
import unittest
from pathlib import Path

import numpy

sys.path.append(str(Path(__file__).parent / "stubs"))  # behind the installed ones
import jax
import torch

import netloft
import netloft.jax
import netloft.torch
from netloft.bridge import Figures

HEIGHT, DRAG = "mouth/headline_height", "drag/all/x"
CASES = [  # (scene of the library, changes, numbers, figures)
    ("hanging-rope.toml", {}, ["parts.rope.length", "parts.rope.rope.EA"], ["sag_z", "end_tension"]),
    ("dead-weight-panel.toml", {"parts.net.cells": [4, 4]}, ["parts.net.panel.bar", "water.gravity"], ["lowest_z", "largest_tension"]),
    ("verification/towed-rope.toml", {}, ["parts.rope.length", "water.current[0]"], ["end_z", "top"]),
    ("verification/towed-cable.toml", {}, ["parts.wire.rope.diameter", "water.density"], ["end_x", "top"]),
    ("verification/catenary-on-seabed.toml", {}, ["parts.wire.length"], ["top_tension", "pull_at_anchor"]),
    ("83-112-flume-3.0kn.toml", {"gear.nodes": 150}, ["tow.speed", "ropes.headrope.length"], [HEIGHT, DRAG]),
    ("83-112-flume-3.0kn.toml", {"gear.nodes": 150}, ["panels.top-wing.fore", "elements.top-wing.twine.diameter"], [HEIGHT, DRAG]),
    ("four-panel.toml", {"gear.nodes": 150}, ["panels.top.mesh"], [HEIGHT, "mouth/area"]),
    ("pair-trawl.toml", {"gear.nodes": 150}, ["ship.speed"], [HEIGHT, DRAG]),
    ("pelagic-with-doors.toml", {"gear.nodes": 150}, ["ship.speed"], [HEIGHT, "bodies/board/y"]),
]
STEP = 1e-5  # of each number; figures that are solved to TIGHT then have an error of 1e-6 in differences over it
TIGHT = {"analysis.tolerance": 1e-12}


def scene_of(case):
    return netloft.load(case[0]).with_({**case[1], **TIGHT})


class Bridged(unittest.TestCase):
    """Ten functions, each differentiated by the library and by equilibria at both sides of every number."""

    def agree(self, bridge, jacobian):
        for case in CASES:
            with self.subTest(case[0], numbers=case[2]):
                scene = scene_of(case)
                function = bridge(scene, case[2], case[3])
                x = [float(scene.numbers[path]) for path in case[2]]
                found, numeric = jacobian(function, x, len(case[3])), numpy.empty((len(case[3]), len(x)))
                for i, value in enumerate(x):
                    sides = [self.value(function, [*x[:i], value * (1 + sign * STEP), *x[i + 1 :]]) for sign in (1, -1)]
                    numeric[:, i] = (sides[0] - sides[1]) / (2 * STEP * value)
                # rtol: the mean slope of both sides differs from the derivative by the curvature of the
                # figure over the step
                numpy.testing.assert_allclose(found, numeric, rtol=1e-4, atol=1e-6 * numpy.abs(numeric * x).max() / numpy.min(numpy.abs(x)))


class OfTorch(Bridged):
    def value(self, function, x):
        return numpy.array(function(torch.tensor(x, dtype=torch.float64)).tolist())

    def test_agree_with_equilibria_beside(self):
        def jacobian(function, x, size):
            x = torch.tensor(x, dtype=torch.float64, requires_grad=True)
            y = function(x)
            return [torch.autograd.grad(y, [x], torch.tensor(row, dtype=torch.float64), **again)[0].tolist() for row in numpy.eye(size).tolist()]

        again = {"retain_graph": True} if hasattr(torch, "__version__") else {}
        self.agree(netloft.torch.figures, jacobian)

    @unittest.skipUnless(hasattr(torch, "__version__"), "PyTorch is not installed")
    def test_pass_gradcheck_in_both_modes(self):
        for case in CASES:
            with self.subTest(case[0], numbers=case[2]):
                scene = scene_of(case)
                function = netloft.torch.figures(scene, case[2], case[3])
                x = torch.tensor([float(scene.numbers[path]) for path in case[2]], dtype=torch.float64)
                y = function(x)
                at = torch.ones(len(x), dtype=torch.float64, requires_grad=True)
                self.assertTrue(torch.autograd.gradcheck(lambda s: function(x * s) / y, [at], eps=STEP, atol=1e-5, rtol=1e-4,
                                                         check_forward_ad=True))

    def test_take_a_dict_of_some_numbers(self):
        scene = scene_of(CASES[0])
        function = netloft.torch.figures(scene, CASES[0][2], CASES[0][3])
        x = [float(scene.numbers[path]) for path in CASES[0][2]]
        longer = torch.tensor(1.01 * x[0], dtype=torch.float64)
        self.assertEqual(function({CASES[0][2][0]: longer}).tolist(), function(torch.tensor([1.01 * x[0], x[1]], dtype=torch.float64)).tolist())
        with self.assertRaisesRegex(KeyError, "did you mean 'parts.rope.length'"):
            function({"parts.rope.lenght": longer})


class OfJax(Bridged):
    def value(self, function, x):
        return numpy.asarray(function(numpy.array(x)))

    def test_agree_with_equilibria_beside(self):
        def jacobian(function, x, size):
            _, pull = jax.vjp(function, numpy.array(x))
            return [pull(row)[0] for row in numpy.eye(size)]

        jax.config.update("jax_enable_x64", True)
        self.agree(netloft.jax.figures, jacobian)

    def test_have_the_type_of_their_numbers(self):
        function = netloft.jax.figures(scene_of(CASES[0]), CASES[0][2], CASES[0][3])
        self.assertEqual(function(numpy.array([6.0, 1e5], numpy.float32)).dtype, numpy.float32)


class AFunctionOfNumbers(unittest.TestCase):
    def test_has_adjoint_modes(self):
        for case in CASES:
            with self.subTest(case[0], numbers=case[2]):
                of = Figures(scene_of(case), case[2], case[3])
                x = of.vector({})
                weights, changes = [1.0, -0.5], [0.1 * value for value in x]
                forward, reverse = numpy.dot(weights, of.jvp(x, changes)), numpy.dot(changes, of.vjp(x, weights))
                self.assertAlmostEqual(forward / reverse, 1, places=9)

    def test_does_not_depend_on_the_numbers_before(self):
        case = CASES[6]
        of, other = Figures(scene_of(case), case[2], case[3]), Figures(scene_of(case), case[2], case[3])
        x = of.vector({})
        of.values([1.05 * x[0], x[1]])
        near = [1.02 * x[0], 1.01 * x[1]]
        self.assertEqual(of.values(near), other.values(near))

    def test_keeps_the_mesh(self):
        """Without mesh_of, the effect of another mesh is larger than the effect of the counts."""
        case = CASES[6]
        of = Figures(scene_of(case), case[2], case[3])
        x = of.vector({})
        self.assertEqual(of.solve([1.02 * x[0], x[1]]).points.shape, of.reference.points.shape)
        change = of.values([1.02 * x[0], x[1]])[0] - of.values(x)[0]
        slope = of.vjp(x, [1.0, 0.0])[0]
        self.assertAlmostEqual(change / (0.02 * x[0] * slope), 1, delta=0.1)

    def test_answers_wrong_names_and_counts(self):
        scene = scene_of(CASES[0])
        with self.assertRaisesRegex(KeyError, "did you mean 'parts.rope.length'"):
            Figures(scene, ["parts.rope.lenght"], ["sag_z"])
        with self.assertRaisesRegex(KeyError, "did you mean 'sag_z'"):
            Figures(scene, ["parts.rope.length"], ["sag_x"])
        with self.assertRaisesRegex(ValueError, "2 numbers are given, and the function has 1"):
            Figures(scene, ["parts.rope.length"], ["sag_z"]).values([1.0, 2.0])
        with self.assertRaisesRegex(TypeError, "Equilibrium of the same gear"):
            scene.solve(mesh_of="hanging-rope.toml")
        with self.assertRaisesRegex(netloft.WrongInput, "corners along a seam"):
            netloft.load("four-panel.toml").solve(mesh_of=netloft.load(CASES[6][0]).with_({"gear.nodes": 150}).solve())


if __name__ == "__main__":
    unittest.main()
