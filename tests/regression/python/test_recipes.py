# SPDX-License-Identifier: BSD-3-Clause
"""Every block of RECIPES.md runs where its packages are installed, and the surrogates agree with solves."""
import importlib.util
import sys
import unittest

import numpy

from blocks import FOLDER, blocks

PAGE = FOLDER / "RECIPES.md"
WANTED = ("sklearn", "openturns")


class TheRecipes(unittest.TestCase):
    def test_run(self):
        names, missing = {}, [name for name in WANTED if importlib.util.find_spec(name) is None]
        code = blocks(PAGE)
        self.assertGreater(len(code), 4)
        for block in code:
            needs = [name for name in missing if name in block or ("kriging" in block and name == "sklearn")]
            if not needs:
                exec(compile(block, str(PAGE), "exec"), names)
        self.assertTrue(numpy.isfinite(names["heights"]).all())
        self.assertLess(names["low"], names["median"])
        self.assertLess(names["error"], 0.03)
        if "sklearn" not in missing:
            self.assertLess(abs(names["height"][0] / names["median"] - 1), 0.3)
        if not missing:
            total = sum(first for first, _ in names["indices"].values())
            self.assertAlmostEqual(total, 1, delta=0.15)
            self.assertGreater(names["indices"]["tow.speed"][1], 0.2)
        print("left out:", missing or "nothing", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
