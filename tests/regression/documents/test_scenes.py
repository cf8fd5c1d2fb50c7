# SPDX-License-Identifier: BSD-3-Clause
"""Runs every scene of the gear library, so that no failing scene is shipped. Every file is a scene except those named here, which scenes include. Long ones are run on coarser meshes or for a shorter
time, all others as they are.
"""
import json
import os
import subprocess
import tempfile
import tomllib
import unittest
from pathlib import Path

PROGRAM, SOURCE = os.environ["NETLOFT_PROGRAM"], Path(os.environ["NETLOFT_SOURCE_DIR"])
SCENES = SOURCE / "gear-library/scenes"
FLUME = ["gear.nodes=600"]
COARSER = {
    **{f"83-112-flume-{knots}kn.toml": FLUME for knots in ("2.0", "2.5", "3.0", "3.5", "4.0")},
    **{f"83-112-at-sea-{depth}m.toml": FLUME for depth in (66, 99)},
    **{f"gov-like-{depth}m.toml": FLUME for depth in (31, 67, 111)},
    "dynamics/83-112-in-motion.toml": ["gear.nodes=100", "analysis.duration=1"],
    "dynamics/trawl-speeds-up.toml": [f"parts.{part}{i}.cells=[6,6]" for part in ("upper", "lower") for i in (1, 2, 3, 4)]
                                     + [f"parts.{rope}.cells=6" for rope in ("headline", "footrope")] + ["analysis.duration=2"],
    "dynamics/hanging-panel.toml": ["analysis.duration=1"],
    "dynamics/panel-in-current.toml": ["parts.net.cells=[10,10]", "analysis.duration=1"],
    "dynamics/towed-rope-speeds-up.toml": ["analysis.duration=15"],
    "verification/tractrix.toml": ["parts.net.cells=[34,10]", "parts.ring.cells=34"],
}
FOUND = {"static": "converged", "dynamic": "finished"}


PIECES = {"common.toml", "geometry.toml", "geometry-half.toml", "geometry-whole.toml", "mesh.toml", "net.toml", "properties.toml"}


def included_by(file):
    return [(file.parent / name).resolve() for name in tomllib.loads(file.read_text()).get("include", [])]


def scenes():
    return [file for file in sorted(SCENES.rglob("*.toml")) if file.name not in PIECES]


class Scenes(unittest.TestCase):
    def run_scene(self, file, folder):
        coarser = COARSER.get(os.path.relpath(file, SCENES), [])
        settings = [word for value in coarser for word in ("--set", value)]
        return subprocess.run([PROGRAM, "run", str(file), "--json", "--overwrite", "-o", "found.hdf", *settings], cwd=folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=100)

    def check(self, file):
        with tempfile.TemporaryDirectory() as folder:
            ended = self.run_scene(file, folder)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            found = json.loads(ended.stdout)
            self.assertIn(found["status"], FOUND.values())
            self.assertTrue((Path(folder) / "found.hdf").is_file())

    def test_there_are_scenes_of_every_folder(self):
        folders = {file.parent.name for file in scenes()}
        self.assertLessEqual({"scenes", "dynamics", "verification", "small-trawl", "dead-weight-panel"}, folders)

    def test_every_piece_is_of_a_scene(self):
        included = {piece for file in SCENES.rglob("*.toml") for piece in included_by(file)}
        for piece in (file for file in SCENES.rglob("*.toml") if file.name in PIECES):
            self.assertIn(piece.resolve(), included)

    def test_settings_name_scenes_that_are_there(self):
        self.assertLessEqual(set(COARSER), {os.path.relpath(file, SCENES) for file in scenes()})

    def test_a_scene_that_fails_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            adrift = Path(folder) / "adrift.toml"
            adrift.write_text((SCENES / "hanging-rope.toml").read_text().replace('on = "rope.end"', 'on = "rope.ends"'))
            with self.assertRaises(AssertionError):
                self.check(adrift)


for each in scenes():
    name = "test_" + "".join(c if c.isalnum() else "_" for c in str(each.relative_to(SCENES).with_suffix("")))
    setattr(Scenes, name, lambda self, file=each: self.check(file))

if __name__ == "__main__":
    unittest.main(verbosity=2)
