# SPDX-License-Identifier: BSD-3-Clause
"""Random values at any key of the library's scenes and gears: the message must have a place, without a crash.

    test_any_key.py [DRAWS [SEED]]        60 draws of seed 1 as a test; thousands by hand
"""
import random
import re
import sys
import tomllib
import unittest

from program import SOURCE, InFreshFolder

SCENES = SOURCE / "gear-library" / "scenes"
NAMES = ("83-112-at-sea-66m", "gov-like-67m", "pelagic-with-doors", "pair-trawl", "four-panel", "codend-from-plan", "83-112-flume-3.0kn",
         "dynamics/trawl-speeds-up", "hanging-rope", "dynamics/panel-in-current")
VALUES = ('"x"', "-1", "0", "[]", "{}", "1e300", "nan", '""', "true", "[[1,2,3]]", "{ a = 1 }", '"1 kg"', '"../../x"', "[1,2,3]", "99999999999",
          '"headline.end"', '"door"', '["door","door"]', '"rope/bar"')
# Keys that scenes may have, but not all scenes have.
MORE = ("bodies.other.board.lift", "bodies.other.type", "parts.other.type", "elements.other.type", "ship.warp.length_port", "ship.warp.to",
        "bodies.door.turned.heel", "bodies.door.turns", "bodies.door.stands", "bed.relief", "bed.slope_x", "results.other.of", "points.other.at",
        "floats.other", "panels.other", "ropes.other", "gear.extent", "tow.leeway", "hold", "join", "hang", "parts", "bodies", "analysis",
        "water.current", "gear", "ropes", "analysis.start", "mesh", "catalogue", "include")


def merge(whole, part):
    for key, value in part.items():
        if isinstance(value, dict) and isinstance(whole.get(key), dict):
            merge(whole[key], value)
        else:
            whole[key] = value


def read(file):
    """A scene with the files that it includes."""
    own, whole = tomllib.loads(file.read_text()), {}
    for name in own.pop("include", []):
        merge(whole, read(file.parent / name))
    merge(whole, own)
    return whole


def keys_of(value, path=""):
    if isinstance(value, dict):
        for key, inner in value.items():
            at = f"{path}.{key}" if path else key
            yield at
            yield from keys_of(inner, at)
    elif isinstance(value, list):
        for i, inner in enumerate(value[:3]):
            yield f"{path}[{i}]"
            yield from keys_of(inner, f"{path}[{i}]")


class AnyKey(InFreshFolder):
    draws, seed = 60, 1

    def test_is_answered(self):
        draw = random.Random(self.seed)
        scenes = [(SCENES / f"{name}.toml", read(SCENES / f"{name}.toml")) for name in NAMES]
        for _ in range(self.draws):
            file, content = draw.choice(scenes)
            setting = f"{draw.choice([*keys_of(content), *MORE])}={draw.choice(VALUES)}"
            words = ["plan", str(file), "--set", setting, *(["--set", "gear.nodes=60"] if "gear" in content else [])]
            with self.subTest(scene=file.stem, set=setting):
                ended = self.netloft(*words)
                self.assertIn(ended.code, (0, 2, 4), ended.err)
                if ended.code:
                    self.assertRegex(ended.err, re.compile(r"^\S.*: error: |^netloft: ", re.MULTILINE))
        self.assertEqual(self.files(), {}, "something was written")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        AnyKey.draws, AnyKey.seed = int(sys.argv[1]), int((sys.argv + ["1"])[2])
    unittest.main(argv=sys.argv[:1])
