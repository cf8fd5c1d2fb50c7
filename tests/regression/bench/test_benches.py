# SPDX-License-Identifier: BSD-3-Clause
"""Runs every script of tests/bench on its smallest input, because scripts that nobody runs stop working unnoticed.

The measurements are not tested. Each script must end with 0 and print a row with numbers.
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = Path(os.environ["NETLOFT_PROGRAM"]), Path(os.environ["NETLOFT_SOURCE_DIR"])
BENCH, LIBRARY = SOURCE / "tests/bench", SOURCE / "gear-library"
FLUME = LIBRARY / "scenes/83-112-flume-3.0kn.toml"
COMMANDS = {  # what it is called with
    "arrival.py": (PROGRAM, PROGRAM.parent / "bench_arrival", SOURCE, "--largest", "1000", "--newton", "100", "--nodes", "100", "--knots", "3.0",
                   "--times", "1"),
    "build_cost.py": (PROGRAM.parent.parent,),
    "start_up.py": (PROGRAM, "--times", "1"),
    "frames.py": (PROGRAM, SOURCE, "1"),
    "memory.py": (PROGRAM, FLUME, "--nodes", "200"),
    "calibration_coverage.py": (PROGRAM, LIBRARY, "--draws", "1"),
    "error_bars.py": (PROGRAM, LIBRARY, "--nodes", "60", "--times", "2", "--only", "1"),
    "sensitivity.py": (PROGRAM, SOURCE / "tests/stability", "--seed", "3", "--case", "flat-sketch", "--of", "auto"),
    "design.py": (PROGRAM, LIBRARY, "--nodes", "100", "--steps", "2"),
    "shapes.py": (PROGRAM.parent / "hard_cases", "--count", "1"),
    "unpredictable.py": (PROGRAM,),
    "surrogates.py": (PROGRAM.parent.parent / "python", "--designs", "1", "--most", "12", "--nodes", "150"),
    "in_python.py": (PROGRAM.parent.parent / "python", "--times", "1", "--solves", "3", "--moments", "1"),
    "optimum.py": (PROGRAM, LIBRARY, "--nodes", "100", "--starts", "1", "--draws", "1"),
    "motions.py": (PROGRAM, SOURCE, "--scenes", "pendulum", "--schemes", "newmark", "--accuracies", "1e-1"),
    "large_study.py": (PROGRAM, LIBRARY / "studies/83-112-speed-depth.toml", "--samples", "1", "--nodes", "100", "--engines", "pool", "--jobs", "1"),
    "lifts.py": (PROGRAM, LIBRARY, "--nodes", "100", "--points", "5"),
    "library_gears.py": (PROGRAM, LIBRARY, "--nodes", "100", "--only", "flume-3.0kn"),
    "knots.py": (PROGRAM, "codend.toml", "--nodes", "100"),
    "slowed_water.py": (PROGRAM, LIBRARY, "--times", "1", "--nodes", "100", "--only", "two-panel"),
    "hard_flows.py": (PROGRAM.parent / "hard_cases", SOURCE / "tests/stability", "--sizes", "small", "--check"),
    "steering.py": (SOURCE,),
    "stage_counts.py": (PROGRAM, SOURCE, "--only", "cod-end"),
    "attempts.py": (PROGRAM, SOURCE, "--nodes", "100", "--only", "flume-3.0kn"),
    # If reading one thing needed a search through all others, ten thousand would take at least thirty times
    # as long as one thousand.
    "reading.py": (PROGRAM, "--most", "10000", "--seconds", "20", "--check", "20"),
}
# Benches that take minutes even at their smallest, mostly by compiling, and one that needs an integrator that
# is not built everywhere.
NOT_HERE = {"cold_start.py", "time_schemes.py", "real_time.py", "trawl_in_motion.py", "stability_limit.py"}
NUMBERS = re.compile(r"\d.*\s\|?\s*\d")


class Benches(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = Path(keeper.name)
        (cls.folder / "codend.toml").write_text(f'include = ["{LIBRARY}/scenes/codend-from-plan.toml"]\n')

    def test_all_are_called(self):
        self.assertEqual({file.name for file in BENCH.glob("*.py")}, COMMANDS.keys() | NOT_HERE)


for name, words in COMMANDS.items():
    def test(self, name=name, words=words):
        ended = subprocess.run([sys.executable, "-B", BENCH / name, *words], cwd=self.folder, capture_output=True, text=True, timeout=300)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertRegex(ended.stdout, NUMBERS)
    setattr(Benches, "test_" + name.removesuffix(".py"), test)

if __name__ == "__main__":
    unittest.main(verbosity=2)
