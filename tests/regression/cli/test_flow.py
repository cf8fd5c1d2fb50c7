# SPDX-License-Identifier: BSD-3-Clause
"""Water that a net slows: closed forms of a screen, a gear with its report, halves and wholes, and wrong tables."""
import unittest

from program import SOURCE, InFreshFolder

SPEED, DENSITY = 1.5, 1000.0
# A square of netting, 4 m by 4 m, across the current. All of its nodes are held, so that only the water is unknown.
SCREEN = """
[water]
density = 1000
current = [{speed}, 0, 0]

[flow]
type = "flow/momentum"
rim = ["net.fore", "net.right", "net.aft", "net.left"]
behind = ["net"]

[parts.net]
type = "priour/triangle"
panel = {{ across = 80, along = 80, bar = "35.36 mm" }}
cells = [8, 8]
sketch = [[0, -2, -8], [0, 2, -8], [0, 2, -12], [0, -2, -12]]
twine = {{ diameter = {diameter}, EA = 1000, density = 1140 }}
drag = {drag}

[[hold]]
on = "net"
name = "frame"

[results]
drag = {{ of = "net", take = "sum reaction x" }}
induction = {{ of = "flow", take = "max induction" }}
area = {{ of = "flow", take = "sum mouth_area" }}
"""
FLOW = '[flow]\ntype = "flow/momentum"\n'
TRAWL = SOURCE / "gear-library/scenes/two-panel.toml"
COD_LINE = '[[join]]                                       # the cod line: the starboard half sewn to that to port\nedges = ["bag.aft", "bag.aft"]\n'


class Flow(InFreshFolder):
    def solve(self, text, *words):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml", "--json", *words)
        self.assertEqual(ended.code, 0, ended.err + ended.out[:300])
        return ended.json()

    def screen(self, drag='"hydro/loland"', diameter=0.003, speed=SPEED, flow="flow/momentum"):
        text = SCREEN.format(drag=drag, diameter=diameter, speed=speed).replace('"flow/momentum"', f'"{flow}"')
        if flow == "none":
            text = text.replace("induction = ", "#").replace("area = ", "#").replace('rim = ["net.fore", "net.right", "net.aft", "net.left"]', "")
            text = text.replace('behind = ["net"]', "").replace('[flow]\ntype = "none"\n', "")
        return self.solve(text)["results"]

    def test_a_screen_across_the_flow_slows_the_water_by_the_closed_form(self):
        # The balance is 4 a (1 - a) = C (1 - a)², where C q A is the drag in undisturbed water.
        for diameter in (0.0015, 0.003, 0.005):
            free = self.screen(diameter=diameter, flow="none")["drag"]
            slowed = self.screen(diameter=diameter)
            C = abs(free) / (0.5 * DENSITY * SPEED**2 * 16)
            self.assertAlmostEqual(slowed["area"], 16, delta=1e-9)
            self.assertAlmostEqual(slowed["induction"], C / (4 + C), delta=1e-9)
            self.assertAlmostEqual(slowed["drag"] / free, (4 / (4 + C))**2, delta=1e-8)

    def test_the_momentum_lost_in_the_far_wake_is_the_drag(self):
        found = self.screen(diameter=0.005)
        a = found["induction"]
        # The thrust is the mass flow through the mouth times the loss of velocity far behind, 2 a V.
        lost = DENSITY * found["area"] * SPEED * (1 - a) * 2 * a * SPEED
        self.assertAlmostEqual(lost / abs(found["drag"]), 1, delta=1e-8)

    def test_the_direction_of_the_rim_does_not_matter(self):
        text = SCREEN.format(drag='"hydro/loland"', diameter=0.003, speed=SPEED)
        turned = text.replace('"net.fore", "net.right", "net.aft", "net.left"', '"net.left", "net.aft", "net.right", "net.fore"')
        self.assertAlmostEqual(self.solve(text)["results"]["induction"], self.solve(turned)["results"]["induction"], delta=1e-12)

    def test_drag_by_the_square_of_the_speed_slows_alike_at_any_speed(self):
        slow, fast = (self.screen(speed=speed)["induction"] for speed in (0.5, 2.5))
        self.assertAlmostEqual(slow, fast, delta=1e-9)

    def test_more_drag_than_a_disc_has_follows_the_empirical_branch(self):
        found = self.screen(drag='{ law = "hydro/morison", normal = 40 }', diameter=0.005)
        a = found["induction"]
        self.assertGreater(a, 0.4)
        thrust = 8 / 9 + a * (-4 / 9 + 14 / 9 * a)
        self.assertAlmostEqual(abs(found["drag"]) / (0.5 * DENSITY * SPEED**2 * 16), thrust, delta=1e-8)
        self.assertIn("empirical", self.netloft("run", "scene.toml").out)

    def test_a_trawl_reports_the_water_in_its_mouth(self):
        figures = self.solve(f'include = ["{TRAWL}"]\n{FLOW}', "--set", "gear.nodes=300")["gear"]["figures"]
        a = figures["mouth/induction"]
        self.assertGreater(a, 0.02)
        self.assertLess(a, 0.3)
        # Water inside the bag has not passed the netting yet.
        for place in ("mouth", "panels/upper", "panels/bag"):
            self.assertGreater(figures[f"{place}/water_speed"], 1.2 * (1 - a), place)
            self.assertLess(figures[f"{place}/water_speed"], 1.2 * 1.02, place)
        self.assertAlmostEqual(figures["mouth/filtered"], figures["mouth/water_speed"] * figures["mouth/area"], delta=1e-6)
        # The thrust of the mouth equals the drag of the gear without its bridles.
        drag = figures["drag/all/x"] - sum(value for name, value in figures.items() if "bridle/x" in name)
        thrust = 4 * a * (1 - a) * 0.5 * 1025 * 1.2**2 * figures["mouth/area"]
        self.assertAlmostEqual(thrust / drag, 1, delta=1e-4)

    def test_water_in_half_a_gear_is_as_fast_as_in_the_whole(self):
        plan, speeds = SOURCE / "gear-library/gears/two-panel.toml", []
        for extent, nodes, doors in (("half", 300, ["door"]), ("whole", 600, ["starboard-door", "port-door"])):
            holds = "".join(f'[[hold]]\non = "{door}"\n' for door in doors)
            self.write("scene.toml", f'include = ["{plan}"]\n{FLOW}[gear]\nextent = "{extent}"\nnodes = {nodes}\n[water]\ncurrent = [1.2, 0, 0]\n'
                       f'[elements.netting]\ntwine = {{ EA_compression = 0 }}\n[points.door]\nat = [0, 5, -30]\n{holds}')
            figures = self.netloft("run", "scene.toml", "--json").json()["gear"]["figures"]
            speeds.append([figures[f"{place}/water_speed"] for place in ("mouth", "panels/upper", "panels/bag")])
        for half, whole in zip(*speeds):
            self.assertAlmostEqual(half, whole, delta=0.01)

    def test_half_a_gear_slows_the_water_as_the_whole_does(self):
        panels = ", ".join(f'"{side}{i}"' for side in ("upper", "lower") for i in range(1, 5))
        found = {}
        for model in ("half", "whole"):
            trawl = SOURCE / f"gear-library/scenes/validation/small-trawl/{model}.toml"
            found[model] = self.solve(f'include = ["{trawl}"]\n{FLOW}rim = ["footrope", "headline"]\nbehind = [{panels}]\n'
                                      'ahead = ["headline", "footrope"]\n[results]\ninduction = { of = "flow", take = "max induction" }\n',
                                      "--set", "analysis.tolerance=1e-10")["results"]["induction"]
        self.assertGreater(found["half"], 0.005)
        self.assertAlmostEqual(found["half"], found["whole"], delta=1e-8)

    def test_the_plan_says_which_drag_sees_the_slowed_water(self):
        self.write("scene.toml", f'include = ["{TRAWL}"]\n{FLOW}')
        said = self.netloft("plan", "scene.toml").out
        self.assertIn("the water is that of flow", said)
        self.assertIn("fraction of the speed that the water loses", said)

    def test_without_a_flow_nothing_changes(self):
        plain = self.solve(f'include = ["{TRAWL}"]\n', "--set", "gear.nodes=300")["gear"]["figures"]
        none = self.solve(f'include = ["{TRAWL}"]\n[flow]\ntype = "none"\n', "--set", "gear.nodes=300")["gear"]["figures"]
        self.assertEqual(plain, none)

    def refused(self, text, *says):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml")
        self.assertNotEqual(ended.code, 0, text)
        for sentence in says:
            self.assertIn(sentence, ended.err)

    def test_wrong_tables_are_answered_with_the_cure(self):
        screen = SCREEN.format(drag='"hydro/loland"', diameter=0.003, speed=SPEED)
        rim = 'rim = ["net.fore", "net.right", "net.aft", "net.left"]'
        with_type = lambda name: screen.replace('"flow/momentum"', name)
        wrong = [
            (with_type('"flow/momentun"'), 'did you mean "flow/momentum"?'),
            (with_type('"floe/momentum"'), "floe"),
            (with_type('"rope/bar"'), "rope/bar does not change the water"),
            (with_type('""'), "is empty"),
            (with_type("3"), "is the integer 3; a text is expected"),
            (screen.replace('type = "flow/momentum"\n', ""), 'missing key "type" in flow'),
            (screen.replace('behind = ["net"]', 'behind = ["net"]\nstart = 2'), "flow.start = 2 is outside [0, 1]"),
            (screen.replace('behind = ["net"]', 'behind = ["net"]\nstrat = 0.1'), 'did you mean "start"?'),
            (screen.replace('behind = ["net"]', 'behind = ["nett"]'), 'did you mean "net"?'),
            (screen.replace('behind = ["net"]', "behind = []"), "flow.behind"),
            (screen.replace('behind = ["net"]', 'behind = ["net"]\nahead = ["net"]'), '"net" is behind the mouth, too'),
            (screen.replace('behind = ["net"]\n', ""), 'missing key "behind" in flow'),
            (screen.replace(rim, "rim = []"), "flow.rim"),
            (screen.replace(rim, 'rim = ["net.front"]'), '"net" has no "front"'),
            (screen.replace(rim, 'rim = ["net.fore"]'), "encloses no area across the current"),
            (screen.replace(rim + "\n", ""), "needs the rim of the mouth"),
            (screen.replace(rim + "\n", "").replace('behind = ["net"]\n', ""), "the scene has no mouth"),
            (screen.replace('type = "priour/triangle"', 'type = "flow/momentum"', 1), "is no part of a gear"),
            (screen.replace("[flow]", "[[flow]]"), "flow is an array"),
            (screen.replace(rim, 'rim = "net.fore"'), "flow.rim"),
            (screen.replace(rim, 'rim = ["net.fore", "net.fore"]'), "encloses no area across the current"),
            (screen.replace(rim, 'rim = ["net"]'), "flow.rim"),
            (screen.replace('behind = ["net"]', "behind = 3"), "flow.behind"),
            (screen.replace('behind = ["net"]', 'behind = ["net", "net"]'), '"net" is named twice'),
            (screen.replace("[1.5, 0, 0]", "[0, 1.5, 0]"), "encloses no area across the current"),
            (f'include = ["{TRAWL}"]\n{FLOW}[ropes.headline]\nrole = "warp"\n',
             "the scene has no mouth through which water could enter a net: no rope in the middle of the net plan has the role headline"),
            (f'include = ["{TRAWL}"]\n{FLOW}[ropes.footrope]\nrole = "headline"\n', "headline is the headline already"),
            (f'include = ["{TRAWL}"]\n{FLOW}[elements.ropes]\ntype = "flow/momentum"\n', "is no part of a gear"),
            (screen + "[analysis]\nkind = \"dynamic\"\nduration = 1\n", "cannot be used in a motion"),
            (screen + "[analysis]\ntangent = \"elastic\"\n", 'needs analysis.tangent = "exact"'),
        ]
        for text, says in wrong:
            with self.subTest(says):
                self.refused(text, says)

    def said_by_run(self, text, sentence, *words):
        self.write("scene.toml", text)
        ended = self.netloft("run", "scene.toml", *words)
        self.assertIn(sentence, ended.out + ended.err)

    def test_what_a_flow_cannot_mean_is_said(self):
        screen = SCREEN.format(drag='"hydro/loland"', diameter=0.003, speed=SPEED)
        bag = SCREEN.format(drag='{ law = "hydro/loland", shielding = 0.9 }', diameter=0.003, speed=SPEED)
        # A second screen far aft is joined to nothing; a mouth of 1 m by 4 m has the drag of 16 m2 of dense netting behind it.
        apart = screen.replace('behind = ["net"]', 'behind = ["net", "aft"]') + "".join(
            "[parts" + part.replace("[0, ", "[9, ") for part in screen.split("[parts")[1:]).split("[[hold]]")[0].replace(".net]", ".aft]") \
            + '[[hold]]\non = "aft"\n'
        heavy = screen.replace('behind = ["net"]', 'behind = ["net"]\nahead = ["aft"]') + apart[apart.index("[parts.aft]"):].replace(
            '"hydro/loland"', '{ law = "hydro/morison", normal = 100 }')
        for text, sentence in ((bag, "has a shielding other than 1, so that the water is slowed twice"),
                               (apart, "water leaves the bag through open edges, aft:"),
                               (heavy, "would flow back through its netting")):
            with self.subTest(sentence):
                self.said_by_run(text, sentence)

    def test_an_open_cod_end_is_said(self):
        plan = (SOURCE / "gear-library/gears/two-panel.toml").read_text()
        self.write("open.toml", plan.replace(COD_LINE, "").replace("[panels.bag]\n", '[panels.bag]\nopen = ["aft"]\n'))
        scene = TRAWL.read_text().replace("../gears/two-panel.toml", "open.toml")
        self.said_by_run(scene + FLOW, "water leaves the bag through open edges, bag.aft:", "--set", "gear.nodes=200")

    def test_still_water_is_said_to_have_no_effect(self):
        self.write("scene.toml", SCREEN.format(drag='"hydro/loland"', diameter=0.003, speed=0))
        ended = self.netloft("run", "scene.toml")
        self.assertIn("[flow] has no effect, and the report has no figures of the water in the net", ended.err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
