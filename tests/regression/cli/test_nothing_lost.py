# SPDX-License-Identifier: BSD-3-Clause
"""Results are not lost: by a full disk, a kill, another run, or a worse result."""
import os
import re
import shutil
import signal
import unittest
from pathlib import Path

import h5py

from program import PROGRAM, SOURCE, InFreshFolder

SCENES = SOURCE / "gear-library" / "scenes"
ROPE = SCENES / "dynamics" / "released-rope.toml"
OFTEN = ["--set", "analysis.output_interval=0.002"]
OUTPUTS = 2501
PANEL = [str(SCENES / "dead-weight-panel.toml"), "--set", "parts.net.cells=[8,8]"]
GEAR = SOURCE / "gear-library" / "gears" / "83-112-eastern.toml"
FULL_DISK = os.environ.get("NETLOFT_FULL_DISK", "")


def states_in(file):
    with h5py.File(file) as f:
        return int(f["VTKHDF/Steps"].attrs["NSteps"])


def outcome_in(file):
    with h5py.File(file) as f:
        return f["netloft/status"].attrs["outcome"]


class InterruptedMotion(InFreshFolder):
    def setUp(self):
        super().setUp()
        self.part = self.folder / "r.hdf.part"
        self.kill_at(500_000)

    def motion(self, *words, **how):
        return self.netloft("run", str(ROPE), *OFTEN, "-o", "r.hdf", *words, **how)

    def kill_at(self, size):
        """Begins a motion, and kills it when its files have this many bytes."""
        if FULL_DISK:
            environment = self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES=str(size), NETLOFT_FULL_KILLS="1")
            self.assertEqual(self.motion(environment=environment).code, -signal.SIGKILL)
        else:
            self.cut_journal(size, "r.hdf", str(ROPE), *OFTEN)
        self.assertTrue(self.part.exists())

    def report(self):
        said = self.netloft("report", "r.hdf.part", "--json")
        self.assertEqual(said.code, 3, said.err)
        return said.json()

    def outputs(self):
        said = self.netloft("report", "r.hdf.part")
        self.assertIn(said.code, (0, 3), said.err)  # 0: it has ended, and only its result could not be made
        return int(re.search(r"(\d+) states", said.out).group(1))

    def test_is_not_overwritten_unasked(self):
        before = self.files()
        again = self.motion()
        self.assertEqual(again.code, 2)
        for words in (f"r.hdf.part holds {self.outputs()} outputs of a run that did not end", "--resume", "--overwrite"):
            self.assertIn(words, again.err)
        self.assertEqual(self.files(), before)
        self.assertEqual(self.netloft("run", *PANEL, "-o", "r.hdf").code, 2, "an equilibrium of that name, neither")
        self.assertEqual(self.files(), before)

    def test_is_overwritten_on_request(self):
        ended = self.motion("--overwrite")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.xdmf"])

    def test_is_read_as_far_as_it_came(self):
        self.assertEqual(self.report()["status"], "running")
        before = self.files()
        for words in (["view", "r.hdf.part", "-o", "v.html"], ["draw", "r.hdf.part", "-o", "v.svg"],
                      ["export", "r.hdf.part", "v.glb"], ["diff", "r.hdf.part", "r.hdf.part"]):
            with self.subTest(command=words[0]):
                ended = self.netloft(*words)
                self.assertEqual(ended.code, 3 if words[0] == "diff" else 0, ended.err)
        self.assertEqual({**self.files(), **before}, self.files())
        self.assertEqual(set(self.files()) - set(before), {"v.html", "v.svg", "v.glb"})

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_survives_a_disk_that_is_still_full(self):
        states, size = self.outputs(), self.part.stat().st_size
        # The disk is full for the journal, then for the result, then for the index for older viewers.
        for room in (0, 0.5, 3, 15, 5, 12, 20):
            with self.subTest(room=room):
                full = self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES=str(int(room * size)))
                again = self.motion("--resume", environment=full)
                self.assertEqual(again.code, 1, again.err)
                self.assertIn("No space left on device", again.err)
                self.assertIn(sorted(self.files()), (["r.hdf.part"], ["r.hdf", "r.hdf.part"]))
                self.assertGreaterEqual(self.outputs(), states)
                states = self.outputs()
        ended = self.motion("--resume")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(states_in(self.folder / "r.hdf"), OUTPUTS)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.hdf~", "r.xdmf"])


class Writers(InFreshFolder):
    def test_do_not_follow_a_link_that_lies_in_the_way(self):
        self.write("precious", "mine")
        (self.folder / "p.hdf.part").symlink_to("precious")
        ended = self.netloft("run", *PANEL, "-o", "p.hdf")
        self.assertNotEqual(ended.code, 0)
        forced = self.netloft("run", *PANEL, "-o", "p.hdf", "--overwrite")
        self.assertNotEqual(forced.code, 0)
        self.assertIn("p.hdf.part: it is a symbolic link", forced.err)
        self.assertEqual((self.folder / "precious").read_text(), "mine")

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_leave_what_was_there_when_the_disk_is_full(self):
        commands = (["draw", str(GEAR), "-o", "out.svg"],
                    ["compare", *PANEL, "--solver", "newton", "--tolerance", "1e-3:1e-2", "--repeats", "1", "-o", "out.csv"],
                    ["compare", *PANEL, "--solver", "newton", "--tolerance", "1e-3:1e-2", "--repeats", "1", "-o", "out.svg"])
        for name in ("out.svg", "out.csv"):
            self.write(name, "old")
        before = self.files()
        for words in commands:
            with self.subTest(command=words[0]):
                ended = self.netloft(*words, environment=self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES="100"))
                self.assertEqual(ended.code, 1, ended.err)
                self.assertIn("cannot be written: No space left on device", ended.err)
                self.assertEqual(self.files(), before)


@unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
class OnAFullDisk(InFreshFolder):
    """In these tests, each write in turn is the first that fails."""

    def count_writes(self, *words):
        self.assertEqual(self.netloft(*words, environment=self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_FAIL_WRITE="0",
                                                                           NETLOFT_COUNT_FILE=str(self.folder / "count"))).code, 0)
        count = int((self.folder / "count").read_text().split()[0])
        (self.folder / "count").unlink()
        return count

    def fail(self, number, *words):
        return self.netloft(*words, environment=self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_FAIL_WRITE=str(number)))

    def test_the_page_of_the_suite_stays_as_it_was(self):
        words = ["hard_cases", str(SOURCE / "tests" / "stability"), "--size", "small", "--case", "hanging-panel/flat-sketch", "--solver", "newton",
                 "-o", "matrix.html"]
        self.assertGreater(self.count_writes(*words), 0)
        self.write("matrix.html", "old")
        ended = self.fail(1, *words)
        self.assertEqual(ended.code, 1, ended.err)
        self.assertIn("matrix.html cannot be written: No space left on device", ended.err)
        self.assertEqual(self.files(), {"matrix.html": b"old"})

    def test_a_component_that_cannot_be_begun_can_be_begun_later(self):
        words = ["new", "element", "otter"]
        writes = self.count_writes(*words)
        whole = self.files()
        self.assertGreaterEqual(writes, len(whole))
        for number in range(1, writes + 1):
            with self.subTest(write=number):
                shutil.rmtree(self.folder / "otter")
                ended = self.fail(number, *words)
                self.assertEqual(ended.code, 1, ended.err)
                self.assertRegex(ended.err, r"otter/\S+ cannot be written: No space left on device")
                self.assertFalse((self.folder / "otter").exists(), "half a component is in the way of a whole one")
                again = self.netloft(*words)
                self.assertEqual(again.code, 0, again.err)
                self.assertEqual(self.files(), whole)

    def test_a_motion_whose_index_cannot_be_written_is_finished_later(self):
        words = ["run", str(ROPE), "-o", "r.hdf"]
        writes = self.count_writes(*words)
        whole = self.files()
        self.assertEqual(sorted(whole), ["r.hdf", "r.xdmf"])
        for name in whole:
            (self.folder / name).unlink()
        ended = self.fail(writes, *words)  # the index is written last
        self.assertEqual(ended.code, 1, ended.err)
        self.assertIn("r.xdmf cannot be written: No space left on device", ended.err)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.hdf.part"])
        self.assertEqual(states_in(self.folder / "r.hdf"), 51)
        again = self.netloft(*words, "--resume")
        self.assertEqual(again.code, 0, again.err)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.hdf~", "r.xdmf"])
        self.assertEqual(self.files()["r.xdmf"], whole["r.xdmf"])


class WorseResults(InFreshFolder):
    def test_do_not_replace_better_ones(self):
        self.assertEqual(self.netloft("run", *PANEL, "-o", "p.hdf").code, 0)
        good = self.files()["p.hdf"]
        for _ in range(2):
            ended = self.netloft("run", *PANEL, "-o", "p.hdf", "--set", "analysis.max_iterations=3")
            self.assertEqual(ended.code, 3)
            self.assertIn("p.hdf holds a better result and is kept", ended.err)
            self.assertIn("written to p.not-converged.hdf", ended.out)
            self.assertEqual(self.files()["p.hdf"], good)
        self.assertEqual(outcome_in(self.folder / "p.not-converged.hdf"), "not converged")
        self.assertEqual(sorted(self.files()), ["p.hdf", "p.not-converged.hdf", "p.not-converged.hdf~"])

    def test_take_the_name_where_there_is_nothing_better(self):
        for _ in range(2):
            self.netloft("run", *PANEL, "-o", "p.hdf", "--set", "analysis.max_iterations=3")
        self.assertEqual(sorted(self.files()), ["p.hdf", "p.hdf~"])

    def test_of_motions_neither(self):
        whole = self.netloft("run", str(ROPE), "-o", "r.hdf")
        self.assertEqual(whole.code, 0, whole.err)
        cut = self.netloft("run", str(ROPE), *OFTEN, "-o", "r.hdf", "--set", "analysis.max_seconds=1e-6")
        self.assertEqual(cut.code, 3, cut.err)
        self.assertEqual(outcome_in(self.folder / "r.hdf"), "finished")
        self.assertEqual(outcome_in(self.folder / "r.not-finished.hdf"), "not finished")

    def test_are_none_where_a_solver_does_not_fit(self):
        scene = str(SCENES / "verification" / "towed-line.toml")
        self.assertEqual(self.netloft("run", scene, "-o", "p.hdf").code, 0)
        before = self.files()
        unfit = self.netloft("run", scene, "-o", "p.hdf", "--solver", "lbfgs")
        self.assertEqual(unfit.code, 2)
        self.assertIn("lbfgs", unfit.err)
        self.assertEqual(self.files(), before)

    def test_are_none_where_a_strategy_fails(self):
        ended = self.netloft("run", *PANEL, "-o", "p.hdf", "--plugins", os.environ["NETLOFT_TEST_PLUGINS"],
                             "--strategy", "escaping_strategies/escaping")
        self.assertNotIn(ended.code, (0, 3), ended.out)
        self.assertEqual(self.files(), {}, "an empty .part stayed")


if __name__ == "__main__":
    unittest.main()
