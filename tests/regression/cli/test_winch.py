# SPDX-License-Identifier: BSD-3-Clause
"""Winches of constant tension: the length of warp that is found, compared with a plain wire of this length."""
import unittest

from program import SOURCE, InFreshFolder

TRAWL = f"""\
include = ["{SOURCE}/gear-library/gears/pelagic-with-doors.toml"]

[gear]
extent = "half"
nodes = 300
"""


def figures_of(ended):
    return ended.json()["gear"]["figures"]


class Winch(InFreshFolder):
    def run_text(self, text, *words):
        self.write("a.toml", text)
        return self.netloft("run", "a.toml", "--json", *words)

    def trawl(self, length, *words, extent="half", tension="6 kN"):
        ended = self.run_text(TRAWL.replace('"half"', f'"{extent}"'), "--set", f"ship.warp.length={length} m",
                              *(["--set", f"ship.warp.tension={tension}"] if tension else []), *words)
        self.assertEqual(ended.code, 0, ended.out + ended.err)
        return figures_of(ended)

    def test_the_length_does_not_depend_on_where_the_search_begins(self):
        one, other = self.trawl(120), self.trawl(170)
        name = "warps/warp/length"
        self.assertAlmostEqual(one[name] / other[name], 1, delta=1e-8)
        self.assertGreater(abs(one[name] - 120), 1)
        self.assertGreater(abs(one[name] - 170), 1)

    def test_half_a_gear_has_the_length_of_the_whole(self):
        same = ("--set", "gear.nodes=0", "--set", "gear.size=1.2 m")  # the same triangles
        half, whole = self.trawl(150, *same), self.trawl(150, *same, extent="whole")
        for side in ("port", "starboard"):
            self.assertAlmostEqual(whole[f"warps/{side}-warp/length"] / half["warps/warp/length"], 1, delta=1e-8)

    def test_a_plain_wire_of_that_length_has_the_same_figures(self):
        found = self.trawl(140)
        plain = self.trawl(repr(found["warps/warp/length"]), tension="")
        self.assertEqual(found.keys(), plain.keys())
        for name, value in plain.items():
            self.assertAlmostEqual(found[name], value, delta=1e-7 * max(1, abs(value)), msg=name)

    def test_a_tension_that_no_length_has_is_not_converged_and_said(self):
        ended = self.run_text(TRAWL, "--set", "ship.warp.tension=600 N", "--set", "analysis.max_seconds=60")
        self.assertEqual(ended.code, 3, ended.out + ended.err)
        self.assertRegex(ended.json()["reason"], r"no length of warp was found at which the tension at its end is 600 N; the nearest tension is \d")

    def test_commands_that_give_lengths_of_their_own_refuse_a_winch(self):
        self.write("a.toml", TRAWL + '\n[bed]\ndepth = "100 m"\n')
        for words in (("scope", "a.toml", "--depth", "90:110:2"), ("compare", "a.toml", "--solver", "newton")):
            ended = self.netloft(*words, "--set", "ship.warp.tension=6 kN")
            self.assertEqual(ended.code, 2, ended.err)
            self.assertIn("ship.warp.tension", ended.err)


if __name__ == "__main__":
    unittest.main()
