# SPDX-License-Identifier: BSD-3-Clause
"""Results and journals with flipped bits: every command must report it, name the dataset, and show no wrong number."""
import random
import re
import unittest

import h5py
import numpy

from program import GOOD, SOURCE, InFreshFolder

MOTION = [str(SOURCE / "gear-library/scenes/dynamics/released-rope.toml"), "--set", "analysis.output_interval=0.002"]
SEED = 7


def commands_on(name, whole):
    return (["report", name], ["report", name, "--json"], ["view", name, "-o", "a.html"], ["draw", name, "-o", "a.svg"],
            ["export", name, "a.csv"], ["diff", whole, name], ["diff", name, whole])


def ranges_of(whole):
    """(path, offset, length) of every dataset, by the table of checksums at the end of a result."""
    table = whole[whole.rindex(b"netloft checksums 1\n"):].decode().splitlines()[1:-2]
    return [(path, int(place), int(length)) for _, place, length, path in (line.split(" ", 3) for line in table)]


class Damaged(InFreshFolder):
    def flip(self, name, whole, bit):
        damaged = bytearray(whole)
        damaged[bit // 8] ^= 1 << bit % 8
        self.write(name, bytes(damaged))

    def expect_refused(self, words, what):
        ended = self.netloft(*words)
        self.assertEqual(ended.code, 2, (words, ended.err))
        self.assertRegex(ended.err, r"(?m)^netloft: cannot read damaged\.\S+: it is damaged: .*" + re.escape(what))

    def test_result_is_refused_by_every_command(self):
        self.write("a.toml", GOOD)
        self.assertEqual(self.netloft("run", "a.toml").code, 0)
        whole, draw = (self.folder / "a.hdf").read_bytes(), random.Random(SEED)
        end = whole.rindex(b"netloft checksums 1\n")
        every = commands_on("damaged.hdf", "a.hdf")
        for i in range(21):
            bit = draw.randrange(8 * end)
            with self.subTest(bit=bit):
                self.flip("damaged.hdf", whole, bit)
                self.expect_refused(every[i % len(every)], "checksum")
        self.assertFalse((self.folder / "a.csv").exists())

    def test_dataset_is_named(self):
        self.write("a.toml", GOOD)
        self.assertEqual(self.netloft("run", "a.toml").code, 0)
        whole, draw = (self.folder / "a.hdf").read_bytes(), random.Random(SEED)
        ranges = ranges_of(whole)
        with h5py.File(self.folder / "a.hdf") as f:
            for path, place, length in ranges:
                stored = numpy.frombuffer(whole[place:place + length], f[path].dtype) if f[path].dtype.kind in "fiu" else None
                if stored is not None:
                    numpy.testing.assert_array_equal(stored, f[path][()].ravel(), path)
        self.assertGreater(len(ranges), 80)
        for path, place, length in draw.sample(ranges, 15):
            with self.subTest(path=path):
                self.flip("damaged.hdf", whole, 8 * place + draw.randrange(8 * length))
                self.expect_refused(["report", "damaged.hdf"], f"{path} does not match its checksum")

    def test_table_of_checksums_is_refused_or_left_alone(self):
        self.write("a.toml", GOOD)
        self.assertEqual(self.netloft("run", "a.toml").code, 0)
        whole, draw = (self.folder / "a.hdf").read_bytes(), random.Random(SEED)
        end = whole.rindex(b"netloft checksums 1\n")
        said = self.netloft("report", "a.hdf", "--csv").out
        for bit in (*(draw.randrange(8 * end, 8 * len(whole)) for _ in range(6)), *range(8 * len(whole) - 8 * 33, 8 * len(whole), 29)):
            with self.subTest(bit=bit):
                self.flip("damaged.hdf", whole, bit)
                ended = self.netloft("report", "damaged.hdf", "--csv")
                if ended.code == 2:
                    self.assertRegex(ended.err, r"damaged\.hdf: it is damaged")
                else:
                    self.assertEqual((ended.code, ended.out), (0, said))

    def journal_of_a_killed_run(self):
        part = self.cut_journal(200_000, "damaged.hdf", *MOTION)
        return part, part.read_bytes()

    def test_journal_is_refused_by_every_command(self):
        part, whole = self.journal_of_a_killed_run()
        draw = random.Random(SEED)
        # Bytes after the last whole record are no record, and do not count.
        self.assertEqual(self.netloft("report", part.name).code, 3)
        self.write("other.hdf.part", whole)
        every = (*commands_on(part.name, "other.hdf.part"), ["run", *MOTION, "-o", "damaged.hdf"])
        for i in range(16):
            bit = draw.randrange(8 * 16, 8 * 190_000)
            with self.subTest(bit=bit):
                self.flip(part.name, whole, bit)
                self.expect_refused(every[i % len(every)], "checksum")

    def test_journal_without_a_whole_beginning_is_left_alone(self):
        part, whole = self.journal_of_a_killed_run()
        for bit in (3, 8 * 13, 8 * 40):  # of the head of the file, of that of the first record, of its content
            with self.subTest(bit=bit):
                self.flip(part.name, whole, bit)
                before = part.read_bytes()
                resumed = self.netloft("run", *MOTION, "-o", "damaged.hdf", "--resume")
                self.assertIn(resumed.code, (1, 2))
                self.assertRegex(resumed.err, "match (its|their) checksum|is not the journal of a motion")
                self.assertEqual(part.read_bytes(), before)

    def test_journal_is_gone_on_with_from_before_the_damage(self):
        self.assertEqual(self.netloft("run", *MOTION, "-o", "whole.hdf").code, 0)
        part, whole = self.journal_of_a_killed_run()
        self.flip(part.name, whole, 8 * 150_000)
        damaged = part.read_bytes()
        resumed = self.netloft("run", *MOTION, "-o", "damaged.hdf", "--resume")
        self.assertEqual(resumed.code, 0, resumed.err)
        self.assertRegex(resumed.err, r"damaged\.hdf\.part: it is damaged: the record at byte \d+ does not match its checksum; "
                                      r"the run goes on from the \d+ outputs before the damage, and the damaged file is kept as damaged\.hdf\.part~")
        self.assertEqual((self.folder / "damaged.hdf.part~").read_bytes(), damaged)
        with h5py.File(self.folder / "damaged.hdf") as after, h5py.File(self.folder / "whole.hdf") as wanted:
            for name in ("VTKHDF/Points", "VTKHDF/PointData/velocity", "VTKHDF/Steps/Values"):
                numpy.testing.assert_array_equal(after[name][()], wanted[name][()], name)

    def test_gets_a_sentence_and_no_crash_where_hdf5_meets_it(self):
        """Without its table of checksums, as in an older version, errors of HDF5 must become a message."""
        self.write("a.toml", GOOD)
        self.assertEqual(self.netloft("run", "a.toml").code, 0)
        whole, draw = (self.folder / "a.hdf").read_bytes(), random.Random(SEED)
        whole = whole[:whole.rindex(b"netloft checksums 1\n")]
        refused = 0
        for _ in range(20):
            damaged = bytearray(whole)
            at = draw.randrange(len(damaged) - 64)
            damaged[at:at + 64] = draw.randbytes(64)
            for _ in range(16):
                damaged[draw.randrange(len(damaged))] = draw.randrange(256)
            self.write("damaged.hdf", bytes(damaged))
            for words in (["report", "damaged.hdf"], ["draw", "damaged.hdf", "-o", "a.png", "--width", "300"], ["diff", "a.hdf", "damaged.hdf"]):
                ended = self.netloft(*words)
                self.assertIn(ended.code, (0, 2, 3), (words, ended.err))
                if ended.code == 2:
                    refused += 1
                    self.assertRegex(ended.err, r"(?m)^netloft: .*damaged\.hdf")
        self.assertGreater(refused, 10)


if __name__ == "__main__":
    unittest.main()
