# SPDX-License-Identifier: BSD-3-Clause
"""The gallery of the gear library: its script makes the pictures that are committed."""
import re
import subprocess
import unittest

import numpy
from program import PROGRAM, SOURCE, InFreshFolder
from test_results import pixels

GALLERY = SOURCE / "gear-library/pictures"
BLOCK = 12  # pixels: lines may lie a pixel aside where another compiler rounds otherwise


def blocks(png):
    """Mean brightness of blocks of pixels, 0 to 255."""
    light = pixels(png).mean(axis=2)
    rows, columns = (size // BLOCK for size in light.shape)
    return light[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK).mean(axis=(1, 3))


class Gallery(InFreshFolder):
    def test_the_script_makes_the_pictures_that_are_committed(self):
        ended = subprocess.run(["bash", GALLERY / "draw.sh", PROGRAM, self.folder], capture_output=True, env=self.environment())
        self.assertEqual(ended.returncode, 0, ended.stderr.decode())
        names = sorted(path.name for path in GALLERY.glob("*.png"))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), names)
        for name in names:
            with self.subTest(name):
                now, then = (blocks((folder / name).read_bytes()) for folder in (self.folder, GALLERY))
                self.assertEqual(now.shape, then.shape)
                off = numpy.abs(now - then)
                self.assertLess(off.max(), 40)
                self.assertLess(off.mean(), 1.5)

    def test_every_picture_is_on_the_page(self):
        shown = re.findall(r"\]\((\S+\.png)\)", (GALLERY / "README.md").read_text())
        self.assertEqual(sorted(shown), sorted(path.name for path in GALLERY.glob("*.png")))


if __name__ == "__main__":
    unittest.main()
