# SPDX-License-Identifier: BSD-3-Clause
"""Plugins that were built for earlier interfaces run in the present program."""
import json
import os
import platform
import re
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).parent
PROGRAM = os.environ["NETLOFT_PROGRAM"]
HEADER = Path(os.environ["NETLOFT_SOURCE_DIR"]) / "framework" / "include" / "netloft" / "plugin.h"


def major():
    return re.search(r"^#define NETLOFT_ABI_MAJOR (\d+)", HEADER.read_text(), re.M).group(1)


class Released(unittest.TestCase):
    def netloft(self, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=HERE, capture_output=True, text=True, timeout=120)

    def has_strategy(self, folder):
        """Whether the kept plugin has a strategy, as since interface 1.3."""
        return tuple(map(int, folder.name.removeprefix("abi-").split("."))) >= (1, 3)

    def folders(self):
        found = sorted(HERE.glob("abi-*.*"))
        self.assertTrue([f for f in found if f.name.startswith(f"abi-{major()}.")], "no plugin of this major version is kept")
        return found

    def test_is_small(self):
        for folder in self.folders():
            self.assertLess((folder / "released.so").stat().st_size, 50000)

    def test_conforms_or_is_refused_with_its_sentence(self):
        for folder in self.folders():
            with self.subTest(folder.name):
                ended = self.netloft("test", folder / "released.so")
                if folder.name.startswith(f"abi-{major()}."):
                    self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
                    strategy = ["released/own"] if self.has_strategy(folder) else []
                    for part in ["released/spring", "released/square", "released/newton"] + strategy:
                        self.assertIn(f"{part}: conforms", ended.stdout)
                else:
                    self.assertEqual(ended.returncode, 4)
                    self.assertIn("build the plugin again with this program's headers", ended.stderr)

    def run_scene(self, folder, scene, expected, within, *words):
        ended = self.netloft("run", scene, "--plugins", folder, "--json", "-o", Path(os.environ["NETLOFT_SCRATCH"]) / "released.hdf", *words)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        results = json.loads(ended.stdout)["results"]
        for name, value in expected.items():
            self.assertAlmostEqual(results[name], value, delta=within * abs(value))

    def test_gives_the_answers_it_gave(self):
        for folder in self.folders():
            if folder.name.startswith(f"abi-{major()}."):
                with self.subTest(folder.name):
                    self.run_scene(folder, "scene.toml", {"end_z": -2.5, "tension": 50, "push": -5}, 1e-8)
                    self.run_scene(folder, "falling.toml", {"lowest": -1.2}, 1e-6)
                    if self.has_strategy(folder):
                        self.run_scene(folder, "scene.toml", {"end_z": -2.5, "tension": 50}, 1e-8, "--strategy", "released/own")


if __name__ == "__main__":
    if platform.machine() != "x86_64" or sys.platform != "linux":
        print("skipped: the plugins that are kept are for x86-64")
        sys.exit(77)
    unittest.main(verbosity=2)
