# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input of `netloft optimise` and `netloft sensitivity` is answered with its place and a cure; nothing is solved or written."""
import unittest

from program import SOURCE, InFreshFolder, changed

SCENES = SOURCE / "gear-library" / "scenes"

GOOD = f"""scene = "{SCENES}/dead-weight-panel.toml"
set = ["parts.net.cells=[8,8]"]
solves = 5
[variables.d]
key = "parts.net.twine.density"
range = [1100, 3000]
[objective]
minimise = "results/lowest_z"
unit = "m"
"""
RANGE, OBJECTIVE = "range = [1100, 3000]\n", "[objective]\n"
LIMIT = '[[constraints]]\nfigure = "results/lowest_z"\n'

# Name, the text that is replaced, its replacement, place, message, hint.
OPTIMA = (
    ("a figure of another scene", "results/lowest_z", "gear/drag/all/x", "8:12", 'does not report a figure "gear/drag/all/x"', "such as results/NAME"),
    ("a figure without its group", "results/lowest_z", "lowest_z", "8:12", 'does not report a figure "lowest_z"', 'did you mean "results/lowest_z"?'),
    ("an objective without a unit", 'unit = "m"\n', "", "7:1", 'missing key "unit" in objective', ""),
    ("an objective in another dimension", 'unit = "m"', 'unit = "kN"', "9:8", 'is a length in m, which "kN" cannot express', 'unit = "m"'),
    ("an objective in no unit", 'unit = "m"', 'unit = "zorg"', "9:8", 'which "zorg" cannot express', 'unit = "m"'),
    ("no objective", '[objective]\nminimise = "results/lowest_z"\nunit = "m"\n', "", "1:1", 'missing key "objective"', ""),
    ("two objectives", "minimise", 'maximise = "results/lowest_z"\nminimise', "7:1", "both minimise and maximise", "limit the other figure by [[constraints]]"),
    ("a misspelt objective", "minimise", "minimize", "8:1", 'unknown key "minimize"', 'did you mean "minimise"?'),
    ("bounds that cross", "[1100, 3000]", "[3000, 1100]", "6:9", "3000 is not less than 1100", ""),
    ("a range of nothing", "[1100, 3000]", "[1100, 1100]", "6:9", "1100 is not less than 1100", ""),
    ("one bound", "[1100, 3000]", "[1100]", "6:9", "is not an array of two", 'such as ["2 kn", "4 kn"]'),
    ("a range in another dimension", "[1100, 3000]", '["1 m", "2 m"]', "5:7", "is 2000 in the scene, but the range of the variable has the unit m",
     "write the range without a unit"),
    ("a range that the scene refuses", "[1100, 3000]", "[-5, 3000]", "5:7", "parts.net.twine.density = -5 kg/m3 is outside [0, 1e6] kg/m3", ""),
    ("no variable", f'[variables.d]\nkey = "parts.net.twine.density"\n{RANGE}', "", "1:1", 'missing key "variables"', ""),
    ("a misspelt number", "twine.density", "twine.densty", "5:7", 'no number "parts.net.twine.densty"; did you mean "parts.net.twine.density"?', ""),
    ("a number that is not continuous", f'parts.net.twine.density"\n{RANGE}', 'parts.net.cells[0]"\nrange = [4, 12]\n', "4:1", "d is not continuous", "netloft study"),
    ("a text", "twine.density", "type", "5:7", 'the scene states no number "parts.net.type"', ""),
    ("a number of two variables", OBJECTIVE, f'[variables.e]\nkey = "parts.net.twine.density"\n{RANGE}{OBJECTIVE}', "7:1", "is varied by d already", ""),
    ("a start outside the range", RANGE, f"{RANGE}start = 4000\n", "7:9", "lies outside the range", ""),
    ("a step beyond the range", RANGE, f"{RANGE}step = 5000\n", "7:8", "must contain a whole multiple of it", ""),
    ("a step backwards", RANGE, f"{RANGE}step = -1\n", "7:8", "must be above zero", ""),
    ("a constraint that limits nothing", OBJECTIVE, LIMIT + OBJECTIVE, "7:1", "neither at_least nor at_most", 'such as at_least = "2 m"'),
    ("a constraint that contradicts itself", OBJECTIVE, f'{LIMIT}at_least = "-1 m"\nat_most = "-3 m"\n{OBJECTIVE}', "9:12", "at_least -1 m is more than at_most -3 m", ""),
    ("a constraint in another dimension", OBJECTIVE, f'{LIMIT}at_least = "1 N"\n{OBJECTIVE}', "9:12", '"1 N" is a force (N); a length (m) is expected', ""),
    ("no solves", "solves = 5", "solves = 0", "3:10", "solves = 0 is outside [1, 10000]", ""),
    ("solves in words", "solves = 5", 'solves = "many"', "3:10", 'solves is the text "many"; an integer is expected', ""),
    ("no such scene", "dead-weight-panel", "dead-weight-panl", "1:9", "cannot be opened", ""),
    ("a motion", "dead-weight-panel", "dynamics/hanging-panel", "1:9", "the scene is a motion, but an optimum is an equilibrium", 'set = ["analysis.kind=static"]'),
)

PANEL = str(SCENES / "dead-weight-panel.toml")
# Words of the command line, message.
SENSITIVITIES = {
    "a figure without its group": (["--of", "lowest"], 'there is no figure "lowest"'),
    "a misspelt number": (["--to", "parts.net.twine.densty"], 'did you mean "parts.net.twine.density"?'),
    "a deviation in another dimension": (["--to", "water.density=3 m"], 'cannot have the standard deviation "3 m"'),
    "a deviation of nothing": (["--to", "water.density=0"], 'cannot have the standard deviation "0"'),
    "an unknown kind of file": (["-o", "bars.jpg"], "bars.jpg"),
    "a file in no folder": (["-o", "nowhere/bars.svg"], "there is no folder nowhere"),
}


class WrongQuestions(InFreshFolder):
    pass


def add_optimum(name, old, new, where, says, hint):
    def check(self):
        self.write("o.toml", changed(GOOD, (old, new)))
        before = self.files()
        ended = self.netloft("optimise", "o.toml")
        self.assertEqual((ended.code, ended.out), (2, ""), ended.err)
        self.assertEqual(self.files(), before, "something was written")
        self.assertRegex(ended.err, rf"(?m)^o\.toml:{where}: error: ")
        self.assertIn(says, ended.err)
        self.assertIn(hint, ended.err)
    setattr(WrongQuestions, f"test_optimum_with_{name.replace(' ', '_')}", check)


def add_sensitivity(name, words, says):
    def check(self):
        ended = self.netloft("sensitivity", PANEL, "--set", "parts.net.cells=[8,8]", *words)
        self.assertEqual((ended.code, ended.out), (2, ""), ended.err)
        self.assertEqual(self.files(), {}, "something was written")
        self.assertIn(says, ended.err)
    setattr(WrongQuestions, f"test_sensitivity_to_{name.replace(' ', '_')}", check)


for each in OPTIMA:
    add_optimum(*each)
for title, (arguments, message) in SENSITIVITIES.items():
    add_sensitivity(title, arguments, message)


class Infeasible(InFreshFolder):
    def test_what_no_point_satisfies_is_said(self):
        self.write("o.toml", changed(GOOD, (OBJECTIVE, f'{LIMIT}at_least = "100 m"\n{OBJECTIVE}')))
        ended = self.netloft("optimise", "o.toml")
        self.assertEqual(ended.code, 3)
        self.assertTrue(ended.out.startswith("o: infeasible\n"), ended.out)


if __name__ == "__main__":
    unittest.main()
