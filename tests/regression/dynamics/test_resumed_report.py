#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A motion that was interrupted and resumed prints the report of an uninterrupted one, except for computing times.

    test_resumed_report.py NETLOFT SOURCE_FOLDER
"""
import re
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests" / "support"))
from journal import Journal

SCENES = SOURCE / "gear-library" / "scenes" / "dynamics"
# A ball falls from the point where its slack rope is held, until the rope stops it at 0.45 s.
SNAP = """
[water]
density = 0
[parts.rope]
type = "rope/bar"
length = 1
cells = 1
sketch = [[0, 0, 0], [0, 0, -0.01]]
rope = { diameter = "5 mm", EA = 2e4, EA_compression = 0, density = 1e-3 }
[parts.ball]
type = "float/float"
on = "rope.end"
float = { mass = 5, volume = 0 }
[[hold]]
on = "rope.start"
[analysis]
kind = "dynamic"
duration = 1.2
output_interval = 0.02
adaptive = false
step = 0.02
"""


class ResumedReport(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_in(self, name, words, bytes_allowed=None):
        """The output of a run under this limit on the size of files."""
        def limit():
            if bytes_allowed:
                resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_allowed, bytes_allowed))
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        return subprocess.run([NETLOFT, "run", *words, "--threads", "1", "-o", "r.hdf"], cwd=folder, capture_output=True, text=True,
                              check=False, preexec_fn=limit)

    def check(self, *words):
        whole = self.run_in("whole", words)
        self.assertIn(whole.returncode, (0, 3), whole.stderr)
        # A run whose result cannot be written leaves its complete journal.
        (self.folder / "stuck").mkdir()
        (self.folder / "stuck/r.hdf.new").mkdir()
        self.run_in("stuck", words)
        part = self.folder / "stuck/r.hdf.part"
        outputs = len(Journal(part).outputs)
        cut = self.run_in("cut", words, part.stat().st_size * 3 // 4)
        self.assertEqual(cut.returncode, 1, cut.stderr)
        self.assertIn("File too large", cut.stderr)
        left = len(Journal(self.folder / "cut/r.hdf.part").outputs)
        self.assertTrue(1 < left < outputs, f"{left} of {outputs}")
        resumed = self.run_in("cut", [*words, "--resume"])
        self.assertEqual(resumed.returncode, whole.returncode, resumed.stderr)
        without_times = lambda text: re.sub(r"(real-time factor|factorisations,) \S+", r"\1 …", text)
        self.assertEqual(without_times(resumed.stdout), without_times(whole.stdout))
        return whole.stdout

    def test_of_a_checked_motion_from_a_sketch(self):
        said = self.check(SCENES / "released-rope.toml", "--set", "analysis.duration=0.5", "--set", "analysis.output_interval=0.01",
                          "--set", "analysis.check=true")
        self.assertRegex(said, r"steps of 0\.\d+ to ")
        self.assertIn("began at rest, from the sketch: forces out of balance by at most", said)
        self.assertIn("compared with a run in other steps", said)

    def test_of_outputs_between_steps(self):
        self.check(SCENES / "released-rope.toml", "--set", "analysis.duration=0.5", "--set", "analysis.output_interval=0.002",
                   "--set", "analysis.dense=true")

    def test_of_a_loss_before_the_interruption(self):
        (self.folder / "snap.toml").write_text(SNAP)
        said = self.check(self.folder / "snap.toml")
        self.assertRegex(said, r"warning: the time scheme removed \S+ J of the \S+ J that were supplied, most of it \(\S+ J\) between t = 0.4")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
