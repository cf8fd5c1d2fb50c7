# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in a notebook: each raises an exception that says the cure, and the interpreter continues."""
import re
import tempfile
import unittest
from pathlib import Path

import numpy

import netloft

GEAR = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 150})
RESULT = GEAR.solve()
ROPE = netloft.load("hanging-rope.toml")

MISTAKES = [  # (what is done, exception, words of its text)
    (lambda: netloft.load("83-112-flume-3.0.toml"), FileNotFoundError, "83-112-flume-3.0kn.toml"),
    (lambda: netloft.load("/nowhere/trawl.toml"), FileNotFoundError, "no scene file"),
    (lambda: netloft.Scene("."), FileNotFoundError, "no such scene file"),
    (lambda: netloft.load(None), TypeError, ""),
    (lambda: GEAR["hedrope"], KeyError, "did you mean 'headrope'"),
    (lambda: GEAR["headrope"].lenght, AttributeError, "did you mean 'length'"),
    (lambda: GEAR.numbers["tow.sped"], KeyError, "did you mean 'tow.speed'"),
    (lambda: GEAR.with_({"tow.sped": 3}).solve(), netloft.WrongInput, 'did you mean "speed"'),
    (lambda: GEAR.with_({"tow.speed": "3 parsec"}).solve(), netloft.WrongInput, "a speed"),
    (lambda: GEAR.with_({"tow.speed": "fast"}).solve(), netloft.WrongInput, "tow.speed"),
    (lambda: GEAR.with_({"tow.speed": None}), TypeError, "no value of a scene"),
    (lambda: GEAR.with_({"tow.speed": float("nan")}).solve(), netloft.WrongInput, "tow.speed"),
    (lambda: GEAR.with_({"": 3}).solve(), netloft.WrongInput, ""),
    (lambda: GEAR.with_({"panels.top-wing.fore": -3}).solve(), netloft.WrongInput, "fore"),
    (lambda: GEAR.with_({"gear.nodes": 1e12}).solve(), netloft.WrongInput, "nodes"),
    (lambda: GEAR.with_("tow.speed=3"), TypeError, ""),
    (lambda: GEAR.solve(solver="newtn"), netloft.Refused, "newton"),
    (lambda: GEAR.solve(solver="newton:methd=classic"), netloft.WrongInput, "method"),
    (lambda: GEAR.solve(solver="newton:"), ValueError, "nothing follows the colon"),
    (lambda: GEAR.solve(strategy="no such strategy"), ValueError, "no such strategy"),
    (lambda: GEAR.solve(start=ROPE.solve()), ValueError, "same mesh"),
    (lambda: GEAR.solve(mesh_of=ROPE.solve()), ValueError, "the same gear"),
    (lambda: GEAR.solve(start=[1, 2, 3]), TypeError, ""),
    (lambda: GEAR.solve(start=numpy.full_like(RESULT.points, numpy.nan)), ValueError, "finite"),
    (lambda: ROPE.with_({"analysis.strategy": "direct", "analysis.max_iterations": 1}).solve(), netloft.NotConverged, "limit of 1 iterations"),
    (lambda: ROPE.simulate(), ValueError, "use solve()"),
    (lambda: netloft.load("dynamics/released-rope.toml").solve(), ValueError, "use simulate()"),
    (lambda: RESULT.report["mouth/headlineheight"], KeyError, "mouth/headline_height"),
    (lambda: RESULT["top-wings"], KeyError, "top-wing"),
    (lambda: RESULT["headrope"].tensions, AttributeError, "tension"),
    (lambda: RESULT.gradient("mouth/height"), KeyError, "mouth/headline_height"),
    (lambda: RESULT.gradient("mouth/headline_height", ["tow.sped"]), ValueError, "tow.sped"),
    (lambda: RESULT.gradient("mouth/headline_height", ["panels.top-codend.twines"]), ValueError, "integer"),
    (lambda: RESULT.vjp({"drag/all": 1}), KeyError, "did you mean"),
    (lambda: RESULT.residual([0.0]), ValueError, "unknowns"),
    (lambda: RESULT.residual(numpy.full(len(RESULT.u), numpy.nan)), ValueError, "finite"),
    (lambda: RESULT.draw(view="behind"), ValueError, "oblique, side, top, front"),
    (lambda: RESULT.draw(field="tensoin"), ValueError, "tension"),
    (lambda: RESULT.save("/nowhere/at/all.hdf"), OSError, "/nowhere"),
    (lambda: netloft.read("/nowhere.hdf"), FileNotFoundError, "no such result file"),
    (lambda: netloft.read(__file__), OSError, ""),
    (lambda: netloft.add_plugins("/nowhere"), NotADirectoryError, "no such folder"),
    (lambda: netloft.study(GEAR, {"tow.speed": []}), ValueError, "has no values"),
    (lambda: netloft.study(GEAR, {"tow.speed": "2 kn"}), ValueError, "wants a list"),
    (lambda: netloft.Scene("83-112-flume-3.0kn.toml"), FileNotFoundError, "load()"),
    (lambda: RESULT.draw(width=100000), ValueError, "pixels wide"),
    (lambda: RESULT.draw("trawl.jpg"), ValueError, ".svg or .png"),
    (lambda: RESULT.jvp({"tow.speed": "0.1 kg"}), ValueError, "a mass"),
    (lambda: RESULT.jvp({"tow.speed": 0.1})["drag"], KeyError, "drag/all/x"),
]


class AMistake(unittest.TestCase):
    def test_says_its_cure(self):
        self.assertGreaterEqual(len(MISTAKES), 30)
        for number, (mistake, expected, words) in enumerate(MISTAKES):
            with self.subTest(number=number, words=words):
                with self.assertRaises(expected) as caught:
                    mistake()
                self.assertIn(words, str(caught.exception))

    def test_has_its_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rope.toml"
            path.write_text(ROPE.file.read_text().replace("length", "lenght"))
            with self.assertRaises(netloft.WrongInput) as caught:
                netloft.Scene(path).solve()
        message = caught.exception.messages[0]
        self.assertEqual(message["severity"], "error")
        self.assertGreater(message["line"], 1)
        self.assertIn("rope.toml", message["where"])

    def test_of_copying_a_scene_of_the_library_names_what_it_includes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "mine.toml"
            path.write_text(GEAR.file.read_text())
            with self.assertRaisesRegex(netloft.WrongInput, "the library has it: include") as caught:
                netloft.load(path).solve()
            includes = re.findall(r'the library has it: include = \[(".*?")\]', str(caught.exception))
            path.write_text(re.sub(r"include = .*", f"include = [{', '.join(includes)}]", GEAR.file.read_text()))
            self.assertEqual(netloft.load(path).with_({"gear.nodes": 150}).solve().report, RESULT.report)

    def test_of_a_search_keeps_its_shape(self):
        with self.assertRaises(netloft.NotConverged) as caught:
            ROPE.with_({"analysis.strategy": "direct", "analysis.max_iterations": 1}).solve()
        self.assertEqual(caught.exception.result.points.shape[1], 3)
        self.assertIn("node", caught.exception.part)


if __name__ == "__main__":
    unittest.main()
