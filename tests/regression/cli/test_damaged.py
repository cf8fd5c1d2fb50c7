# SPDX-License-Identifier: BSD-3-Clause
"""Results with flipped bytes: what HDF5 makes of them is a sentence in the end. Not for sanitizers, which stop at what the library does."""
import random
import unittest

from program import GOOD, InFreshFolder


class Damaged(InFreshFolder):
    def test_gets_a_sentence_and_no_crash(self):
        self.write("a.toml", GOOD)
        self.assertEqual(self.netloft("run", "a.toml").code, 0)
        result = "a.hdf"
        whole, draw = (self.folder / result).read_bytes(), random.Random(7)
        refused = 0
        for _ in range(25):
            damaged = bytearray(whole)
            at = draw.randrange(len(damaged) - 64)
            damaged[at:at + 64] = draw.randbytes(64)
            for _ in range(16):
                damaged[draw.randrange(len(damaged))] = draw.randrange(256)
            self.write("damaged.hdf", bytes(damaged))
            for words in (["report", "damaged.hdf"], ["draw", "damaged.hdf", "-o", "a.png", "--width", "300"], ["diff", result, "damaged.hdf"]):
                ended = self.netloft(*words)
                self.assertIn(ended.code, (0, 2, 3), (words, ended.err))
                if ended.code == 2:
                    refused += 1
                    self.assertRegex(ended.err, r"(?m)^netloft: .*damaged\.hdf")
        self.assertGreater(refused, 10)


if __name__ == "__main__":
    unittest.main()
