# SPDX-License-Identifier: BSD-3-Clause
"""Every block of RECIPES.md runs where its packages are installed, and the surrogates agree with solves."""
import importlib.util
import unittest

import numpy

from blocks import FOLDER, blocks

PAGE = FOLDER / "RECIPES.md"
MISSING = [name for name in ("sklearn", "openturns") if importlib.util.find_spec(name) is None]


class TheRecipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.names = {}
        for block in blocks(PAGE):
            if not any(name in block or ("kriging" in block and name == "sklearn") for name in MISSING):
                exec(compile(block, str(PAGE), "exec"), cls.names)

    def test_find_quantiles(self):
        self.assertGreater(len(blocks(PAGE)), 4)
        self.assertTrue(numpy.isfinite(self.names["heights"]).all())
        self.assertLess(self.names["low"], self.names["median"])

    def test_estimate_from_gradients(self):
        self.assertLess(self.names["error"], 0.03)

    @unittest.skipIf("sklearn" in MISSING, "scikit-learn is not installed, and its recipe did not run")
    def test_estimate_by_kriging(self):
        self.assertLess(abs(self.names["height"][0] / self.names["median"] - 1), 0.3)

    @unittest.skipIf(MISSING, "OpenTURNS or scikit-learn is not installed, and the recipe of Sobol's indices did not run")
    def test_find_the_number_that_matters(self):
        self.assertAlmostEqual(sum(first for first, _ in self.names["indices"].values()), 1, delta=0.15)
        self.assertGreater(self.names["indices"]["tow.speed"][1], 0.2)


if __name__ == "__main__":
    unittest.main()
