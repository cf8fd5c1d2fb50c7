# SPDX-License-Identifier: BSD-3-Clause
"""The package and the command line of one build write the same numbers, bit for bit."""
import multiprocessing
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import h5py
import joblib
import numpy

import netloft

PROGRAM = os.environ["NETLOFT_PROGRAM"]
SCENES = [  # (scene of the library, changes): ropes, netting, bed and boards, bodies, catch, motions
    ("hanging-rope.toml", {}),
    ("dead-weight-panel.toml", {}),
    ("83-112-flume-3.0kn.toml", {"gear.nodes": 300}),
    ("83-112-at-sea-66m.toml", {"gear.nodes": 300}),
    ("pelagic-with-doors.toml", {"gear.nodes": 300}),
    ("codend-from-plan.toml", {}),
    ("two-panel.toml", {"gear.nodes": 300}),
    ("gov-like-31m.toml", {"gear.nodes": 300}),
    ("dynamics/released-rope.toml", {}),
    ("dynamics/pendulum-of-bars.toml", {}),
]
OF_PROCESSES = [("hanging-rope.toml", {}), ("dead-weight-panel.toml", {"parts.net.cells": [8, 8]}), ("codend-from-plan.toml", {}),
                ("83-112-flume-3.0kn.toml", {"gear.nodes": 150}), ("two-panel.toml", {"gear.nodes": 150})]
NOT_COMPARED = ("/netloft/provenance", "/netloft/cost", "/netloft/statistics")  # the machine and the clock


def datasets(path):
    """Names and bytes of all data in a result except times and paths of plugins."""
    found = {}

    def keep(name, item):
        if isinstance(item, h5py.Dataset) and not ("/" + name).startswith(NOT_COMPARED) and "seconds" not in name:
            found[name] = numpy.asarray(item[()]).tobytes() if item.dtype.kind != "O" else repr(item[()])
        if name == "netloft/plan":
            found[name] = re.sub(r"/\S*/lib/netloft/", "", found[name])

    with h5py.File(path, "r") as file:
        file.visititems(keep)
    return found


def digits(scene):
    """Every digit of the figures of a scene."""
    return [f"{name} {float(q).hex()}" for name, q in scene.solve().report.items()]


class OfOneBuild(unittest.TestCase):
    def test_have_the_same_bits(self):
        for name, changes in SCENES:
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                scene = netloft.load(name).with_(changes)
                run, own = Path(folder) / "run.hdf", Path(folder) / "own.hdf"
                words = [w for change in scene.changes for w in ("--set", change)]
                subprocess.run([PROGRAM, "run", str(scene.file), *words, "--threads", "1", "-o", str(run)], check=True, capture_output=True)
                if name.startswith("dynamics"):
                    scene.simulate(output=own)
                else:
                    scene.solve().save(own)
                expected, got = datasets(run), datasets(own)
                self.assertEqual(sorted(expected), sorted(got))
                differing = [key for key in expected if expected[key] != got[key]]
                self.assertEqual(differing, [])
                self.assertGreater(len(expected), 20)

    def test_are_those_of_four_processes(self):
        gears = [netloft.load(name).with_(changes) for name, changes in OF_PROCESSES]
        scenes = [gear.with_({"water.density": 1015.0 + i}) for i in range(10) for gear in gears]
        alone = list(map(digits, scenes))
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(4) as pool:
                self.assertEqual(pool.map(digits, scenes, chunksize=1), alone, method)
        self.assertEqual(len({tuple(row) for row in alone}), 50)

    def test_are_those_of_joblib(self):
        """Which sends scenes to processes of its own making."""
        scenes = [netloft.load("hanging-rope.toml").with_({"parts.rope.length": f"{10 + i / 10} m"}) for i in range(4)]
        self.assertEqual(joblib.Parallel(2)(joblib.delayed(digits)(scene) for scene in scenes), list(map(digits, scenes)))

    def test_are_those_of_a_study_with_workers(self):
        gear = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 150})
        speeds = {"tow.speed": [f"{2 + 0.2 * i:.1f} kn" for i in range(6)]}
        one, four = netloft.study(gear, speeds), netloft.study(gear, speeds, workers=4)
        self.assertEqual(one.failed, [])
        for a, b in zip(one.rows, four.rows):
            self.assertEqual({n: float(q).hex() for n, q in a[3].items()}, {n: float(q).hex() for n, q in b[3].items()})

    def test_are_those_beside_other_libraries_with_threads(self):
        """OpenMP of scikit-learn and threads of OpenBLAS, before and after, in one process."""
        from sklearn.cluster import KMeans

        scene = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 300})
        before = digits(scene)
        KMeans(4, n_init=1, random_state=1).fit(numpy.random.default_rng(1).normal(size=(20000, 8)))
        matrix = numpy.random.default_rng(2).normal(size=(800, 800))
        product = matrix @ matrix
        self.assertEqual(digits(scene), before)
        numpy.testing.assert_array_equal(matrix @ matrix, product)
        module = next(Path(netloft.__file__).parent.glob("_netloft*.so"))
        needed = subprocess.run(["ldd", module, *module.parent.glob("lib/netloft/*/*.so")], check=True, capture_output=True, text=True).stdout
        self.assertNotRegex(needed, "libgomp|libomp|libiomp")  # nothing of it brings a runtime of OpenMP that could meet another


if __name__ == "__main__":
    unittest.main()
