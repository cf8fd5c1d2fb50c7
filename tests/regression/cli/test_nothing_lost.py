# SPDX-License-Identifier: BSD-3-Clause
"""What was found once is not lost: by a full disk, by a kill, by running again, by a worse result."""
import os
import signal
import subprocess
import time
import unittest
from pathlib import Path

import h5py

from program import PROGRAM, SOURCE, InFreshFolder

SCENES = SOURCE / "gear-library" / "scenes"
ROPE = SCENES / "dynamics" / "released-rope.toml"
OFTEN = ["--set", "analysis.output_interval=0.02"]
PANEL = [str(SCENES / "dead-weight-panel.toml"), "--set", "parts.net.cells=[8,8]"]
GEAR = SOURCE / "gear-library" / "gears" / "83-112-eastern.toml"
FULL_DISK = os.environ.get("NETLOFT_FULL_DISK", "")


def states_in(file):
    with h5py.File(file) as f:
        return int(f["VTKHDF/Steps"].attrs["NSteps"])


def read_all(file):
    """Every dataset. A kill in the middle of a flush may leave a chunk that cannot be read: that is the kill's
    loss, and these tests ask what comes after it."""
    with h5py.File(file) as f:
        f.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)


def outcome_in(file):
    with h5py.File(file) as f:
        return f["netloft/status"].attrs["outcome"]


class InterruptedMotion(InFreshFolder):
    def setUp(self):
        super().setUp()
        self.part = self.folder / "r.hdf.part"
        for seconds in (0.6, 1.2, 2.4, 4.8, 9.6):
            if self.kill_after(seconds):
                break
        else:
            self.fail("no kill left outputs")

    def motion(self, *words, **how):
        return self.netloft("run", str(ROPE), *OFTEN, "-o", "r.hdf", *words, **how)

    def kill_after(self, seconds):
        run = subprocess.Popen(self.command("run", str(ROPE), *OFTEN, "-o", "r.hdf", "--overwrite"), cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(seconds)
        run.send_signal(signal.SIGKILL)
        run.wait()
        try:
            read_all(self.part)
            return states_in(self.part) > 1
        except (OSError, KeyError):
            return False

    def test_is_not_overwritten_unasked(self):
        before = self.files()
        again = self.motion()
        self.assertEqual(again.code, 2)
        for words in ("r.hdf.part holds", "outputs of a run that did not end", "--resume", "--overwrite"):
            self.assertIn(words, again.err)
        self.assertEqual(self.files(), before)
        self.assertEqual(self.netloft("run", *PANEL, "-o", "r.hdf").code, 2, "an equilibrium of that name, neither")
        self.assertEqual(self.files(), before)

    def test_is_overwritten_on_request(self):
        ended = self.motion("--overwrite")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.xdmf"])

    def test_says_in_its_file_that_it_has_not_ended(self):
        self.assertEqual(outcome_in(self.part), "running")

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_survives_a_disk_that_is_still_full(self):
        before = self.files()
        states, size = states_in(self.part), len(before["r.hdf.part"])
        for room in (0, size // 2, size + size // 2, 3 * size):
            with self.subTest(room=room):
                # A flush that the full disk cut may have left a chunk that cannot be read: each try begins afresh.
                self.part.write_bytes(before["r.hdf.part"])
                full = self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES=str(room))
                again = self.motion("--resume", environment=full)
                self.assertEqual(again.code, 1, again.err)
                # HDF5 may meet the full disk first as a chunk of its own that it cannot read back.
                self.assertRegex(again.err, "No space left on device|cannot write .* in r.hdf.*part")
                self.assertGreaterEqual(states_in(self.part), states)
        self.part.write_bytes(before["r.hdf.part"])
        ended = self.motion("--resume")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(states_in(self.folder / "r.hdf"), 251)
        self.assertEqual(sorted(self.files()), ["r.hdf", "r.xdmf"])


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
                    ["compare", *PANEL, "--solver", "newton", "--tolerance", "1e-3:1e-2", "--repeats", "1", "--csv", "out.csv"],
                    ["compare", *PANEL, "--solver", "newton", "--tolerance", "1e-3:1e-2", "--repeats", "1", "--plot", "out.svg"],
                    ["reference", "."])
        for name in ("out.svg", "out.csv", "index.md", "index.html"):
            self.write(name, "old")
        before = self.files()
        for words in commands:
            with self.subTest(command=words[0]):
                ended = self.netloft(*words, environment=self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES="100"))
                self.assertEqual(ended.code, 1, ended.err)
                self.assertIn("cannot be written: No space left on device", ended.err)
                self.assertEqual(self.files(), before)


class WorseResults(InFreshFolder):
    def test_do_not_replace_better_ones(self):
        self.assertEqual(self.netloft("run", *PANEL, "-o", "p.hdf").code, 0)
        good = self.files()["p.hdf"]
        for _ in range(2):
            ended = self.netloft("run", *PANEL, "-o", "p.hdf", "--set", "analysis.max_iterations=3")
            self.assertEqual(ended.code, 3)
            self.assertIn("p.hdf holds a better result and stays", ended.err)
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
        cut = self.netloft("run", str(ROPE), "-o", "r.hdf", "--set", "analysis.max_seconds=0.05")
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
