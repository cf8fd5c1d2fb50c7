# SPDX-License-Identifier: BSD-3-Clause
"""The hard cases of an installation: found from any folder, with the scenes of the gear library that they change."""
import json
import unittest

from installed import WithInstallation


class HardCases(WithInstallation):
    def matrix(self, words):
        return json.loads(self.sh(f"netloft stability --solver newton --size small --json {words}").out)

    def test_the_suite_is_found_from_any_folder(self):
        matrix = self.matrix("--case hanging-panel/slack")
        self.assertEqual(matrix["suite"], str(self.installed.prefix / "share/netloft/suites/stability"))
        self.assertEqual([(c["name"], c["where"]) for c in matrix["cases"]], [("hanging-panel/slack", "reference")])

    def test_every_kind_finds_its_scenes(self):
        kinds = {file.stem for file in (self.installed.prefix / "share/netloft/suites/stability").glob("*.toml")} - {"solvers"}
        self.assertGreaterEqual(len(kinds), 16)
        matrix = json.loads(self.sh("netloft stability --solver newton --size small --json", expect=None).out)
        self.assertEqual({k["kind"] for k in matrix["kinds"]}, kinds)
        loose = [c["name"] for c in matrix["cases"] if c["where"] == "not run" and c["expected"] != "none"]
        self.assertEqual(loose, [])

    def test_a_suite_in_the_working_folder_comes_first(self):
        here = self.folder / "tests" / "stability"
        here.mkdir(parents=True)
        (here / "solvers.toml").write_text('[[solver]]\nuse = "newton"\n')
        self.sh(f"cp {self.installed.prefix}/share/netloft/gear-library/scenes/hanging-rope.toml .")
        (here / "mine.toml").write_text('scene = "../../hanging-rope.toml"\n[sizes]\nsmall = []\n'
                                        '[[case]]\nname = "plain"\nexpected = "stable"\n')
        self.assertEqual([c["name"] for c in self.matrix("")["cases"]], ["mine/plain"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
