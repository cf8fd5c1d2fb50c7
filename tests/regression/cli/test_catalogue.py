# SPDX-License-Identifier: BSD-3-Clause
"""Parts of a catalogue, in scenes and listed."""
import os
import unittest

from program import GOOD, InFreshFolder, changed

TWINE = 'twine = { diameter = "10 mm", EA = "10 kN", density = 2000 }'
ROPE = 'rope = { diameter = "20 mm", EA = "100 kN", EA_compression = 0, density = 1150 }'
MINE = """\
[twine.mine]
diameter = "10 mm"
EA = "10 kN"
density = 2000
source = "a test"
uncertainty = "none"
"""


def with_twine(twine):
    return changed(GOOD, (TWINE, f"twine = {twine}"))


class Catalogue(InFreshFolder):
    def lowest(self, scene, **more):
        self.write("scene.toml", scene)
        run = self.netloft("run", "scene.toml", "--json", **more)
        self.assertEqual(run.code, 0, run.err)
        return run.json()["results"]["lowest_z"]

    def answer(self, scene):
        self.write("scene.toml", scene)
        run = self.netloft("run", "scene.toml")
        self.assertEqual(run.code, 2, run.err)
        return run.err

    def test_a_folder_of_the_environment_that_is_not_there_is_an_error(self):
        self.write("scene.toml", with_twine('"pe-braided-4mm"'))
        for words in (("catalogue", "twine"), ("plan", "scene.toml")):
            ended = self.netloft(*words, environment=self.environment(NETLOFT_CATALOGUE="/nowhere"))
            self.assertEqual(ended.code, 2)
            self.assertIn("error: NETLOFT_CATALOGUE: there is no folder /nowhere", ended.err)

    def test_a_name_stands_for_its_numbers(self):
        (self.folder / "parts").mkdir()
        self.write("parts/twines.toml", MINE)
        named = 'catalogue = ["parts"]\n' + with_twine('"mine"')
        self.assertEqual(self.lowest(named), self.lowest(GOOD))

    def test_one_value_is_overridden_in_place(self):
        (self.folder / "parts").mkdir()
        self.write("parts/twines.toml", MINE.replace("2000", "3000"))
        named = 'catalogue = ["parts"]\n' + with_twine('{ part = "mine", density = 2000 }')
        self.assertEqual(self.lowest(named), self.lowest(GOOD))

    def test_the_gear_library_is_found(self):
        rope = 'rope = { part = "short-link-10mm", EA_compression = 0 }'
        scene = changed(with_twine('{ part = "pa-twisted-2mm", EA_compression = 0.1 }'), (ROPE, rope))
        self.assertLess(self.lowest(scene), -3)  # the panel hangs under the chain

    def test_a_name_that_is_not_there(self):
        err = self.answer(with_twine('"pe-braided-4m"'))
        self.assertIn('scene.toml:10:9: error: parts.net.twine: there is no twine "pe-braided-4m" in the catalogue', err)
        self.assertIn('did you mean "pe-braided-4mm"?', err)
        self.assertEqual(err.count("error:"), 1, err)

    def test_a_part_of_another_kind(self):
        err = self.answer(with_twine('"pp-3-strand-16mm"'))
        self.assertIn('"pp-3-strand-16mm" is a rope', err)

    def test_an_override_that_nobody_knows(self):
        err = self.answer(with_twine('{ part = "pe-braided-4mm", colour = 3 }'))
        self.assertIn('unknown key "colour" in parts.net.twine', err)

    def test_an_override_outside_its_range(self):
        err = self.answer(with_twine('{ part = "pe-braided-4mm", diameter = "-4 mm" }'))
        self.assertIn("parts.net.twine.diameter", err)

    def test_an_error_in_a_catalogue_has_its_place_there(self):
        (self.folder / "parts").mkdir()
        self.write("parts/twines.toml", MINE.replace('"10 mm"', '"10 kg"'))
        err = self.answer('catalogue = ["parts"]\n' + with_twine('"mine"'))
        self.assertIn("parts/twines.toml:2:12", err)

    def test_the_listing_names_parts_with_their_source(self):
        everything = self.netloft("catalogue", "--json").json()["parts"]
        self.assertGreaterEqual(len(everything), 40)
        one = self.netloft("catalogue", everything[0]["name"])
        self.assertIn(everything[0]["source"], one.out)

    def test_a_kind_lists_its_parts(self):
        kinds = {part["kind"] for part in self.netloft("catalogue", "wire", "--json").json()["parts"]}
        self.assertEqual(kinds, {"wire"})

    def test_a_part_that_is_not_listed(self):
        answer = self.netloft("catalogue", "pe-braided-44mm")
        self.assertEqual(answer.code, 2)
        self.assertIn("did you mean", answer.err)


if __name__ == "__main__":
    os.environ.pop("NETLOFT_CATALOGUE", None)
    unittest.main()
