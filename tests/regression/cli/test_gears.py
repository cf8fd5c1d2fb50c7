# SPDX-License-Identifier: BSD-3-Clause
"""Net plans, checked and drawn."""
import tomllib
import unittest
import xml.etree.ElementTree as xml

from program import SOURCE, InFreshFolder

GEARS = sorted((SOURCE / "gear-library/gears").glob("*.toml"))
EASTERN = (SOURCE / "gear-library/gears/83-112-eastern.toml").read_text()
SLIP = EASTERN.replace('cut = "3B1M out"', 'cut = "381M out"')


class Gears(InFreshFolder):
    def test_gears_of_the_library_can_be_sewn_and_drawn(self):
        self.assertTrue(GEARS)
        for gear in GEARS:
            self.assertEqual(self.netloft("check", str(gear)).code, 0, gear)
            self.assertEqual(self.netloft("draw", str(gear), "-o", "plan.svg").code, 0, gear)
            texts = [e.text for e in xml.parse(self.folder / "plan.svg").iter() if e.tag.endswith("text")]
            for panel in tomllib.loads(gear.read_text())["panels"]:
                self.assertIn(panel, texts)

    def test_the_plan_on_the_page_can_be_sewn(self):
        page = (SOURCE / "io/gear/GEAR.md").read_text()
        self.write("gear.toml", page.split("```toml\n")[1].split("```")[0])
        run = self.netloft("check", "gear.toml")
        self.assertEqual((run.code, run.err), (0, ""))

    def test_the_slip_of_the_printed_plan_is_found_and_named(self):
        self.write("slip.toml", SLIP)
        run = self.netloft("check", "slip.toml")
        self.assertEqual(run.code, 2)
        self.assertIn('slip.toml:20:39: error: top-wing.breast-cut: cutting "381M" is no rate; 3B1M, 43 M over 25.8 M, fits',
                      run.err)
        self.assertIn("warning: top-wing.aft: the cuttings give 129.7 meshes, the plan says 127.5, +1.7 %", run.err)

    def test_findings_for_a_program(self):
        self.write("slip.toml", SLIP)
        findings = self.netloft("check", "slip.toml", "--json").json()["findings"]
        self.assertEqual([f["severity"] for f in findings], ["warning", "error", "warning"])
        self.assertEqual(findings[1]["at"], "slip.toml:20:39")

    def test_outlines_for_a_program(self):
        panels = self.netloft("check", str(GEARS[0]), "--json").json()["panels"]
        wing = next(p for p in panels if p["name"] == "top-wing")
        self.assertEqual({e["name"] for e in wing["edges"]}, {"fore", "breast-cut", "side", "aft", "inner"})

    def test_a_value_can_be_set(self):
        run = self.netloft("check", str(GEARS[0]), "--set", "panels.top-wing.aft=129.7")
        self.assertEqual(run.code, 0)
        self.assertNotIn("top-wing.aft", run.err)

    def test_a_changed_gear_is_three_lines(self):
        self.write("eastern.toml", EASTERN)
        self.write("fewer.toml", 'include = ["eastern.toml"]\n[floats.headline]\nspread = "42 along headrope"\n')
        self.assertEqual(self.netloft("draw", "fewer.toml").code, 0)
        self.assertIn("42 83-112-headline along headrope", self.files()["fewer.svg"].decode())

    def test_a_wrong_plan_is_not_drawn(self):
        self.write("slip.toml", SLIP)
        self.assertEqual(self.netloft("draw", "slip.toml").code, 2)
        self.assertNotIn("slip.svg", self.files())

    def test_the_picture_never_replaces_the_plan(self):
        self.write("gear.toml", EASTERN)
        self.assertEqual(self.netloft("draw", "gear.toml", "-o", "gear.toml").code, 2)
        self.assertEqual(self.files()["gear.toml"].decode(), EASTERN)

    def test_a_folder_is_not_replaced(self):
        self.assertEqual(self.netloft("draw", str(GEARS[0]), "-o", ".").code, 2)

    def test_a_plan_that_is_not_there(self):
        self.assertEqual(self.netloft("check", "none.toml").code, 2)

    def test_a_scene_is_no_plan(self):
        self.write("scene.toml", "[parts.net]\ntype = \"priour/triangle\"\n")
        run = self.netloft("check", "scene.toml")
        self.assertEqual(run.code, 2)
        self.assertIn("panels", run.err)


if __name__ == "__main__":
    unittest.main()
