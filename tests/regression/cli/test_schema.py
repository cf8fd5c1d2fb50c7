# SPDX-License-Identifier: BSD-3-Clause
"""The schema that editors complete scenes with: shipped scenes are valid, misspelt keys are not, and SCENE.md describes every key."""
import re
import unittest

import tomllib

from json_schema import faults
from program import GOOD, SOURCE, InFreshFolder, changed

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCENES = sorted((SOURCE / "gear-library" / "scenes").rglob("*.toml"))
PAGE = SOURCE / "io" / "scenes" / "SCENE.md"


def is_whole(scene):
    """Files that other files include may lack required keys."""
    return "analysis" in scene or "water" in scene and "parts" in scene and "hold" in scene


def keys_of(schema):
    """Names of all keys, at any depth; for keys of plugins only their table, because `netloft describe` shows the others."""
    here = schema.get("properties", {})
    of_plugins = "const" in here.get("type", {}) or "solver" in here
    for name, member in here.items():
        yield name
        if not of_plugins or name == "panel":
            yield from keys_of(member)
    for inner in [schema.get("items"), schema.get("additionalProperties"), *schema.get("anyOf", []), *schema.get("$defs", {}).values()]:
        if isinstance(inner, dict):
            yield from keys_of(inner)


class Schema(InFreshFolder):
    def setUp(self):
        super().setUp()
        ended = self.netloft("schema")
        self.assertEqual((ended.code, ended.err), (0, ""))
        self.schema = ended.json()

    def faults_of(self, text):
        return faults(tomllib.loads(text), self.schema)

    def test_shipped_scenes_fit(self):
        self.assertGreaterEqual(len(SCENES), 3)
        for file in SCENES:
            text = file.read_text()
            with self.subTest(file.name):
                if is_whole(tomllib.loads(text)):
                    self.assertEqual(self.faults_of(text), [])

    def test_currents_fit(self):
        for current in ("[1.5, 0, 0]", '["1.5 m/s", 0, 0]', '{ z = ["0 m", -50], x = [1.5, "1.2 m/s"] }', '{ z = [0], up = [0.1] }'):
            with self.subTest(current):
                self.assertEqual(self.faults_of(changed(GOOD, ("[water]", f"[water]\ncurrent = {current}"))), [])
        for current in ("1.5", "[1.5, 0]", "{ x = [1.5] }", "{ z = [0], w = [1] }"):
            with self.subTest(current):
                self.assertNotEqual(self.faults_of(changed(GOOD, ("[water]", f"[water]\ncurrent = {current}"))), [])

    def test_parts_need_no_type_where_another_file_may_say_it(self):
        finer = "[parts.net]\ncells = [64, 64]\n"
        self.assertNotEqual(self.faults_of(finer), [])
        self.assertEqual(self.faults_of('include = ["panel.toml"]\n' + finer), [])

    def test_parts_on_other_parts_fit(self):
        rope = '[parts.more]\ntype = "rope/bar"\non = "rope"\nrope = { diameter = 0.01, EA = 1e3, density = 1e3 }\n'
        self.assertEqual(self.faults_of(rope), [])
        self.assertEqual(self.faults_of(rope.replace('"rope"\nr', '["rope"]\nr')), [])
        self.assertNotEqual(self.faults_of(rope + "cells = 3\n"), [])

    def test_parts_of_the_catalogue_fit(self):
        twine = '{ diameter = "10 mm", EA = "10 kN", density = 2000 }'
        for said in ('"pe-braided-4mm"', '{ part = "pe-braided-4mm", diameter = "4.2 mm" }'):
            self.assertEqual(self.faults_of('catalogue = ["mine"]\n' + changed(GOOD, (twine, said))), [])
        for said in ("3", '{ part = 3 }', '{ part = "pe-braided-4mm", colour = 3 }', '{ diameter = "4 mm" }'):
            self.assertNotEqual(self.faults_of(changed(GOOD, (twine, said))), [], said)

    def test_a_wrong_key_is_named(self):
        self.assertIn("scene.parts.net.twine.diametre is not allowed", self.faults_of(changed(GOOD, ("diameter", "diametre"))))

    def test_slips_do_not_fit(self):
        self.assertEqual(self.faults_of(GOOD), [])
        for old, new in (("tolerance", "tolerence"), ("[water]", "[watre]"), ("diameter", "diametre"), ('"10 kN"', "-5"),
                         ('on = "net.fore"', 'om = "net.fore"'), ('take = "min z"', "take = 3"), ("cells = [4, 4]", "cells = [4]"),
                         ('type = "rope/bar"', 'type = "rope/bra"'), ('length = "3 m"\n', ""), ('on = "net.fore"', 'on = "net.fore"\naxes = "w"'),
                         ("tolerance", 'newton = { method = "clasic" }\ntolerance'), ("gravity = 9.81", "gravity = true")):
            with self.subTest(new):
                self.assertNotEqual(self.faults_of(changed(GOOD, (old, new))), [])

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not here")
    def test_somebody_elses_validator_agrees(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)
        validator = jsonschema.Draft202012Validator(self.schema)
        self.assertEqual([e.message for e in validator.iter_errors(tomllib.loads(GOOD))], [])
        self.assertNotEqual(list(validator.iter_errors(tomllib.loads(changed(GOOD, ("tolerance", "tolerence"))))), [])

    def test_every_key_is_described(self):
        def undescribed(schema, path):
            for name, member in schema.get("properties", {}).items():
                is_table = "properties" in member or "items" in member and "properties" in member["items"]
                if not is_table and "description" not in member:
                    yield f"{path}.{name}"
                yield from undescribed(member, f"{path}.{name}")
                yield from undescribed(member.get("items", {}), f"{path}.{name}")
            for part in schema.get("$defs", {}).values():
                yield from undescribed(part, part["title"])
        self.assertEqual(list(undescribed(self.schema, "scene")), [])

    def test_every_key_stands_on_the_page_about_scenes(self):
        prose = re.sub(r"```.*?```", "", PAGE.read_text(), flags=re.S)
        words = set(re.findall(r"[\w-]+", " ".join(re.findall(r"`([^`]+)`", prose))))
        missing = sorted({key for key in keys_of(self.schema)} - words)
        self.assertEqual(missing, [], "io/scenes/SCENE.md does not speak of them")


class Page(InFreshFolder):
    def test_its_examples_run(self):
        """Every TOML block is a whole scene of that name; pieces of scenes are in blocks without a language."""
        text = PAGE.read_text()
        scenes = re.findall(r"^```toml (\S+)\n(.*?)^```", text, re.S | re.M)
        self.assertEqual(len(scenes), len(re.findall("^```toml", text, re.M)), "every scene has a name")
        self.assertGreaterEqual(len(scenes), 3)
        for name, scene in scenes:
            self.write(name, scene)
            ended = self.netloft("run", name)
            self.assertEqual(ended.code, 0, ended.out + ended.err)

    def test_it_shows_a_changing_current_and_a_hold_that_moves(self):
        scenes = re.findall(r"^```toml \S+\n(.*?)^```", PAGE.read_text(), re.S | re.M)
        moving = [s for s in map(tomllib.loads, scenes) if "factor" in s.get("water", {}).get("current", {})]
        self.assertTrue(any("displacement" in hold for s in moving for hold in s["hold"]))

    def test_every_edge_and_corner_is_named(self):
        text = PAGE.read_text()
        for wrong, kind in (("net.nowhere", "net"), ("rope.nowhere", "rope")):
            self.write("scene.toml", changed(GOOD, ('on = "net.fore"', f'on = "{wrong}"')))
            error = self.netloft("run", "scene.toml", "--json").json()["errors"][0]
            names = error["hint"].removeprefix("there is: ").split(", ")
            self.assertGreaterEqual(len(names), 3)
            for name in names[:-1]:
                self.assertIn(f"`{name}`", text, kind)


if __name__ == "__main__":
    unittest.main()
