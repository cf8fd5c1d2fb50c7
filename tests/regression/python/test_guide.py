# SPDX-License-Identifier: BSD-3-Clause
"""Every block of PYTHON.md runs, in its order, in an empty folder."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

from blocks import FOLDER, blocks

sys.path.append(str(Path(__file__).parent / "stubs"))  # of libraries that are not installed
PAGE = FOLDER / "PYTHON.md"


class TheGuide(unittest.TestCase):
    def test_runs(self):
        code = blocks(PAGE)
        self.assertGreater(len(code), 6)
        names = {}
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            for block in code:
                with self.subTest(block=block.splitlines()[0]):
                    exec(compile(block, str(PAGE), "exec"), names)
            written = {path.name for path in Path(folder).iterdir()}
            os.chdir("/")
        self.assertEqual(written, {"trawl.png", "trawl.html", "trawl.hdf", "faster.toml", "least-drag.toml", "heights.png"})
        self.assertEqual({row["status"] for row in names["table"].values()}, {"converged"})


if __name__ == "__main__":
    unittest.main()
