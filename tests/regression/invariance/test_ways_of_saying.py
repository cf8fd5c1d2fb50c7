#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Different ways of writing the same current, depth, hold, length or number give the same answer.

    test_ways_of_saying.py NETLOFT

`WAYS` is the table: a subject, and the ways of writing it, each as replacements in the same scene. All figures of a subject agree to 1e-9; they differ
from those of the scene without the subject (`other`), so that a way that is ignored is found.
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py

NETLOFT = sys.argv[1]

SCENE = {
    "water": "current = [0.8, 0, 0]",
    "tow": "",
    "bed": "[bed]\ndepth = 20",
    "ground": 'type = "seabed/bed"',
    "length": "46",
    "rope": "diameter = 0.05, EA = 5e6, density = 4000",
    "sketch": "[[0, 0, -3], [9, 0.5, -20], [40, 0, -20]]",
    "holds": '[[hold]]\non = "line.start"\n[[hold]]\non = "line.end"',
    "joins": "",
    "kind": "",
}


def text_of(changes):
    s = SCENE | changes
    return f"""
[water]
{s["water"]}
{s["tow"]}
{s["bed"]}
[parts.line]
type = "rope/bar"
length = {s["length"]}
cells = 46
sketch = {s["sketch"]}
rope = {{ {s["rope"]} }}
[parts.ground]
{s["ground"]}
on = "line"
seabed = {{ stiffness = 1e5 }}
{s["joins"]}
{s["holds"]}
[analysis]
tolerance = 1e-12
{s["kind"]}
[results]
low = {{ of = "line", take = "min z" }}
mean = {{ of = "line", take = "mean z" }}
aside = {{ of = "line", take = "max y" }}
a = {{ of = "line.start", take = "reaction" }}
b = {{ of = "line.end", take = "reaction" }}
pull = {{ of = "line", take = "max tension" }}
"""


WAYS = {
    "current": dict(
        other=dict(water="current = [0.4, 0, 0]"),
        constant=dict(water="current = [0.8, 0, 0]"),
        with_units=dict(water='current = ["80 cm/s", "0 kn", "0 m/s"]'),
        in_knots=dict(water=f'current = ["{0.8 * 3600 / 1852!r} kn", 0, 0]'),
        profile=dict(water="current = { z = [0, -30], x = [0.8, 0.8] }"),
        profile_of_texts=dict(water='current = { z = ["0 m", "-30 m"], x = ["0.8 m/s", "0.8 m/s"] }'),
        column_with_one_unit=dict(water='current = { z = [0, -30], x = { unit = "cm/s", values = [80, 80] } }'),
        profile_in_another_order=dict(water="current = { y = [0, 0], x = [0.8, 0.8], up = [0, 0], z = [0, -30] }"),
        with_one_unit=dict(water='current = { unit = "cm/s", values = [80, 0, 0] }'),
        in_time=dict(water="current = { t = [0, 10], x = [0.8, 0.8] }"),
        between_two_times=dict(water="current = { t = [-10, 30], x = [0.7, 1.1] }"),
        profile_with_a_factor=dict(water="current = { z = [0, -30], x = [1.6, 1.6], t = [0, 10], factor = [0.5, 0.5] }"),
        towed=dict(water="", tow="[tow]\nspeed = 0.8"),
        towed_in_knots=dict(water="", tow=f'[tow]\nspeed = "{0.8 * 3600 / 1852!r} kn"'),
        towed_along_a_current=dict(water="current = [0.3, 0, 0]", tow="[tow]\nspeed = 0.5"),
        towed_against_a_current=dict(water="current = [-0.2, 0, 0]", tow="[tow]\nspeed = 1.0"),
    ),
    # The values differ, so that a wrong interpolation shows; the line begins at -3 m and ends at -20 m.
    "current over the depth": dict(
        other=dict(water="current = [0.8, 0, 0]"),
        profile=dict(water="current = { z = [0, -30], x = [0.8, 0.2] }"),
        upwards=dict(water="current = { z = [-30, 0], x = [0.2, 0.8] }"),
        profile_of_texts=dict(water='current = { z = ["0 m", "-3000 cm"], x = ["80 cm/s", "0.2 m/s"] }'),
        columns_with_one_unit=dict(water='current = { z = { unit = "cm", values = [0, -3000] }, x = { unit = "cm/s", values = [80, 20] } }'),
        with_heights_between=dict(water="current = { z = [0, -5, -15, -30], x = [0.8, 0.7, 0.5, 0.2] }"),
        with_a_factor=dict(water="current = { z = [0, -30], x = [1.6, 0.4], t = [0, 10], factor = [0.5, 0] }"),
        with_a_factor_between_two_times=dict(water="current = { z = [0, -30], x = [1.6, 0.4], t = [-10, 30], factor = [0.4, 0.8] }"),
        on_top_of_a_tow=dict(water="current = { z = [0, -30], x = [0.5, -0.1] }", tow="[tow]\nspeed = 0.3"),
        constant_beyond_its_heights=dict(water="current = { z = [0, -30, -40], x = [0.8, 0.2, 0.2] }"),
    ),
    "current across": dict(
        other=dict(),
        constant=dict(water="current = [0, 0.6, 0]"),
        profile=dict(water="current = { z = [0, -30], y = [0.6, 0.6] }"),
        towed_with_leeway=dict(water="", tow='[tow]\nspeed = 0.6\nleeway = "90 deg"'),
        towed_with_leeway_in_radians=dict(water="", tow="[tow]\nspeed = 0.6\nleeway = 1.5707963267948966"),
    ),
    "depth": dict(
        other=dict(bed="[bed]\ndepth = 19.5"),
        number=dict(bed="[bed]\ndepth = 20"),
        text=dict(bed='[bed]\ndepth = "20 m"'),
        in_feet=dict(bed=f'[bed]\ndepth = "{20 / 0.3048!r} ft"'),
        in_fathoms=dict(bed=f'[bed]\ndepth = "{20 / 1.8288!r} fathom"'),
        level_by_slopes=dict(bed="[bed]\ndepth = 20\nslope_x = 0\nslope_y = 0"),
        level_by_relief=dict(bed="[bed]\ndepth = 21\nrelief = { x = [-90, -90, 90, 90], y = [-90, 90, -90, 90], height = [1, 1, 1, 1] }"),
        bottom_of_one=dict(bed="[bed]\ndepth = 20\nbottom = { x = [-90, -90, 90, 90], y = [-90, 90, -90, 90], stiffness = [1, 1, 1, 1], friction = [1, 1, 1, 1], ploughing = [1, 1, 1, 1] }"),
    ),
    "hold": dict(
        other=dict(sketch="[[0, 0, -3], [9, 0.5, -20], [41, 0, -20]]"),
        by_the_sketch=dict(),
        at_the_same_place=dict(holds='[[hold]]\non = "line.start"\nat = [0, 0, -3]\n[[hold]]\non = "line.end"\nat = [40, 0, -20]'),
        at_with_one_unit=dict(holds='[[hold]]\non = "line.start"\nat = { unit = "cm", values = [0, 0, -300] }\n[[hold]]\non = "line.end"'),
        sketched_with_one_unit=dict(sketch='{ unit = "cm", values = [[0, 0, -300], [900, 50, -2000], [4000, 0, -2000]] }'),
        at_texts=dict(holds='[[hold]]\non = "line.start"\nat = ["0 m", "0 m", "-300 cm"]\n[[hold]]\non = "line.end"\nat = ["40 m", 0, "-20 m"]'),
        two_in_one=dict(holds='[[hold]]\non = ["line.start", "line.end"]'),
        by_number_of_node=dict(holds='[[hold]]\non = "line.node-0"\n[[hold]]\non = "line.node-46"'),
        by_axes=dict(holds='[[hold]]\non = "line.start"\naxes = "xyz"\n[[hold]]\non = "line.end"\naxes = "zyx"'),
        axis_by_axis=dict(holds='[[hold]]\non = "line.start"\naxes = "x"\n[[hold]]\non = "line.start"\naxes = "yz"\nname = "more"\n[[hold]]\non = "line.end"'),
        twice=dict(holds='[[hold]]\non = ["line.start", "line.end"]\n[[hold]]\non = "line.end"\nname = "again"'),
        in_another_order=dict(holds='[[hold]]\non = "line.end"\n[[hold]]\non = "line.start"'),
    ),
    "length": dict(
        other=dict(length="45"),
        number=dict(length="46"),
        real=dict(length="46.0"),
        text=dict(length='"46 m"'),
        in_millimetres=dict(length='"46000 mm"'),
        in_feet=dict(length=f'"{46 / 0.3048!r} ft"'),
        with_an_exponent=dict(length='"4.6e1 m"'),
    ),
    "number with its unit": dict(
        other=dict(rope="diameter = 0.05, EA = 5e6, density = 3900"),
        numbers=dict(rope="diameter = 0.05, EA = 5e6, density = 4000"),
        texts=dict(rope='diameter = "50 mm", EA = "5 MN", density = "4000 kg/m3"'),
        other_units=dict(rope='diameter = "5 cm", EA = "5000 kN", density = "4 g/cm3"'),
        derived_units=dict(rope='diameter = "0.05 m", EA = "5e6 kg m/s2", density = "4 t/m3"'),
        integers=dict(rope="diameter = 0.05, EA = 5000000, density = 4000"),
        in_another_order=dict(rope="density = 4000, EA = 5e6, diameter = 0.05"),
    ),
}


class WaysOfSaying(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def figures(self, changes):
        file, result = Path(self.folder.name) / "scene.toml", Path(self.folder.name) / "result.hdf"
        file.write_text(text_of(changes))
        ended = subprocess.run([NETLOFT, "run", file, "-o", result, "--overwrite"], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stderr + ended.stdout)
        with h5py.File(result) as f:
            return {name: f[f"netloft/scalars/{name}"][()] for name in f["netloft/scalars"]}

    def test_each_pair_gives_one_answer(self):
        for subject, ways in WAYS.items():
            first = next(way for way in ways if way != "other")
            said = self.figures(ways[first])
            for way, changes in ways.items():
                with self.subTest(subject=subject, way=way):
                    figures = self.figures(changes)
                    if way == "other":
                        self.assertTrue(any(abs(figures[k] - v) > 1e-3 * abs(v) for k, v in said.items()), (figures, said))
                        continue
                    for name, value in said.items():
                        self.assertAlmostEqual(figures[name], value, delta=1e-9 * max(1, abs(value)), msg=f"{first}, {way}: {name}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
