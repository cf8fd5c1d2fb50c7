# SPDX-License-Identifier: BSD-3-Clause
"""`netloft draw` on polars of a catalogue: their numbers, and the curves with which boards are computed."""
import re
import unittest

from program import SOURCE, InFreshFolder, changed

POLARS = SOURCE / "gear-library/catalogue/polars.toml"
OVER_SLIP = """\
source = "estimate: an example"
uncertainty = "all of it"
[polar.both-ways]
attack = { unit = "deg", values = [10, 30, 10, 30] }
sideslip = { unit = "deg", values = [-10, -10, 10, 10] }
lift = [0.8, 1.2, 0.9, 1.3]
drag = [0.3, 0.6, 0.3, 0.6]
side = [0.1, 0.1, -0.1, -0.1]
[polar.with-centre]
attack = { unit = "deg", values = [0, 10, 30] }
lift = [0.0, 0.8, 1.3]
drag = [0.1, 0.3, 0.6]
chord = [0.25, 0.3, 0.4]
span = [0, 0.01, 0.02]
"""


class Polars(InFreshFolder):
    def draw(self, text, *words):
        self.write("my.toml", text)
        return self.netloft("draw", "my.toml", *words)

    def test_the_shipped_polars_are_plotted_over_the_angle_of_attack(self):
        ended = self.netloft("draw", str(POLARS), "-o", "polars.svg")
        self.assertEqual(ended.code, 0, ended.err)
        svg = (self.folder / "polars.svg").read_text()
        for words in ("cambered-low-aspect: lift", "high-lift-h2: drag", "angle of attack"):
            self.assertIn(words, svg)
        curves = [d.count("L") + d.count(" ") for d in re.findall(r"<poly?line points=\"([^\"]*)\"|<path d=\"([^\"]*)\"", svg) for d in d if d]
        self.assertGreaterEqual(sum(n > 100 for n in curves), 4, "a smooth curve each of lift and drag")

    def test_polars_over_two_angles_have_a_line_for_every_sideslip(self):
        self.assertEqual(self.draw(OVER_SLIP).code, 0)
        svg = (self.folder / "my.svg").read_text()
        for words in ("both-ways: lift, sideslip -10°", "both-ways: side, sideslip 10°", "with-centre: centre of pressure, from the nose over the chord"):
            self.assertIn(words, svg)

    def test_a_page_has_a_plot_of_each(self):
        self.assertEqual(self.draw(OVER_SLIP, "-o", "my.html").code, 0)
        self.assertEqual((self.folder / "my.html").read_text().count("<svg"), 2)

    def test_what_is_wrong_with_them_has_its_place(self):
        for change, where, says in (((("drag = [0.1, 0.3, 0.6]", "drag = [0.1, 0.3]"),), "my.toml:12:8", "3 are expected"),
                                    ((("values = [0, 10, 30]", "values = [0, 30, 10]"),), "my.toml:10:", "does not ascend"),
                                    ((("values = [-10, -10, 10, 10]", "values = [-10, -10, 10, 20]"),), "my.toml:", "there is no row for attack"),
                                    ((("chord = [0.25", "chrod = [0.25"),), "my.toml:13:1", "chrod"),
                                    ((('unit = "deg", values = [0,', 'unit = "kg", values = [0,'),), "my.toml:10:", "")):
            with self.subTest(says):
                ended = self.draw(changed(OVER_SLIP, *change))
                self.assertEqual(ended.code, 2, ended.err)
                self.assertIn(where, ended.err)
                self.assertIn(says, ended.err)
                self.assertFalse((self.folder / "my.svg").exists())

    def test_options_of_other_pictures_are_refused(self):
        for option in (("--view", "front"), ("--width", "500")):
            ended = self.draw(OVER_SLIP, *option)
            self.assertEqual(ended.code, 2)
            self.assertIn("holds polars", ended.err)


if __name__ == "__main__":
    unittest.main()
