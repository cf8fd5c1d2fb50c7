# SPDX-License-Identifier: BSD-3-Clause
"""A model in a tank, computed at full scale, gives the same as the model computed at its own scale, scaled to the gear."""
import json
import math
import unittest

from program import InFreshFolder

LENGTHS, TWINES = 20, 4  # λ and λ'
SCENE = """
[water]
density = 1000
viscosity = 1e-6
current = [{speed!r}, 0, 0]
{model}
[parts.net]
type = "priour/triangle"
panel = {{ across = {across}, along = {along}, bar = {bar!r} }}
cells = [8, 8]
sketch = [[0, {left!r}, 0], [0, {right!r}, 0], [{aft!r}, {right!r}, 0], [{aft!r}, {left!r}, 0]]
twine = {{ diameter = {twine!r}, EA = {twine_EA!r}, EA_compression = 0, density = 1140 }}
drag = {{ law = "hydro/netting-twine" }}

[parts.rope]
type = "rope/bar"
length = {length!r}
cells = 8
sketch = [[{aft!r}, {left!r}, 0], [{aft!r}, {right!r}, 0]]
rope = {{ diameter = {rope!r}, EA = {rope_EA!r}, EA_compression = 0, density = {rope_density!r} }}
drag = {{ law = "hydro/morison-reynolds" }}

[parts.float]
type = "float/float"
on = "net.node-40"
float = {{ buoyancy = {buoyancy!r}, diameter = {float!r}, drag_law = "sphere" }}

[parts.other]
type = "float/float"
on = "net.node-76"
float = {{ buoyancy = {buoyancy!r}, area = {area!r}, drag_coefficient = 0.6 }}

[[join]]
points = ["net.aft", "rope"]

[[hold]]
on = "net.fore"
name = "frame"

[analysis]
tolerance = 1e-11

[results]
pull = {{ of = "net.fore", take = "sum reaction x" }}
lift = {{ of = "net.fore", take = "sum reaction z" }}
aft = {{ of = "net", take = "max x" }}
"""
GEAR = dict(speed=1.2, model="", across=160, along=200, bar=0.05, left=-4.0, right=4.0, aft=15.0, twine=0.002, twine_EA=4e3, length=6.0,
            rope=0.02, rope_EA=2e6, rope_density=4000.0, buoyancy=60.0, float=0.25, area=0.06)


def model(gear):
    """The model that hangs in the tank, with the same strains as the gear."""
    force, speed = LENGTHS**2 * TWINES, math.sqrt(TWINES)
    small = {key: gear[key] / LENGTHS for key in ("left", "right", "aft", "length")}
    rope = math.sqrt(LENGTHS * TWINES)
    # The model has λ/λ' times fewer bars across, so that each of them bears a λ/λ' times larger share of the
    # force.
    small |= dict(speed=gear["speed"] / speed, across=gear["across"] * TWINES // LENGTHS, along=gear["along"] * TWINES // LENGTHS,
                  bar=gear["bar"] / TWINES, twine=gear["twine"] / TWINES, twine_EA=gear["twine_EA"] / (LENGTHS * TWINES**2),
                  rope=gear["rope"] / rope, rope_EA=gear["rope_EA"] / force, buoyancy=gear["buoyancy"] / force,
                  float=gear["float"] / (LENGTHS**2 * TWINES) ** (1 / 3), area=gear["area"] / (LENGTHS**2 * TWINES) ** (2 / 3))
    return gear | small


class TankModels(InFreshFolder):
    def solve(self, scene):
        (self.folder / "scene.toml").write_text(SCENE.format(**scene))
        ended = self.netloft("run", "scene.toml", "--json")
        self.assertEqual(ended.code, 0, ended.err)
        return json.loads(ended.out)["results"]

    def test_by_the_rule_of_tauti_what_is_told_of_the_gear_is_the_model_at_its_scale(self):
        for gear in (GEAR, GEAR | {"rope_density": 950.0, "buoyancy": 90.0}):  # of rope that sinks, and that floats
            self.check_model(gear)

    def check_model(self, gear):
        tank = f"model_scale = {LENGTHS}\nmodel_twine_scale = {TWINES}"
        itself, told, sea = (self.solve(scene) for scene in (model(gear), gear | {"model": tank}, gear))
        force = LENGTHS**2 * TWINES
        for name, scale in (("pull", force), ("lift", force), ("aft", LENGTHS)):
            self.assertAlmostEqual(scale * itself[name] / told[name], 1, delta=1e-7, msg=name)
        self.assertGreater(abs(told["pull"] / sea["pull"] - 1), 0.01, "the model is not the gear")

    def test_what_it_cannot_tell_is_refused(self):
        for line, words in (("model_twine_scale = 4", "outside [1, 1]"), ("model_scale = 3\nmodel_twine_scale = 4", "outside [1, 3]"),
                            ("model_scale = 3\nmodel_twine_scale = 0.5", "model_twine_scale = 1 or more")):
            (self.folder / "scene.toml").write_text(SCENE.format(**(GEAR | {"model": line})))
            ended = self.netloft("plan", "scene.toml")
            self.assertEqual(ended.code, 2)
            self.assertIn(words, ended.err)
        dry = SCENE.format(**(GEAR | {"model": "model_scale = 20\nmodel_twine_scale = 4"})).replace("rope = { ", "rope = { surface = 1, ")
        (self.folder / "scene.toml").write_text(dry)
        ended = self.netloft("plan", "scene.toml")
        self.assertEqual(ended.code, 2)
        self.assertIn('under water, and "rope" may be above it', ended.err)
        moving = SCENE.format(**(GEAR | {"model": "model_scale = 20\nmodel_twine_scale = 4"}))
        moving = moving.replace("[analysis]", '[analysis]\nkind = "dynamic"\nduration = 1')
        (self.folder / "scene.toml").write_text(moving)
        ended = self.netloft("run", "scene.toml")
        self.assertEqual(ended.code, 2)
        self.assertIn("Tauti's rule knows no masses", ended.err)


if __name__ == "__main__":
    unittest.main()
