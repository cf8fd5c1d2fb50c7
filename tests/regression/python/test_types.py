# SPDX-License-Identifier: BSD-3-Clause
"""Editors and type checkers know the package: the code of its pages passes the strictest check."""
import ast
import importlib.util
import inspect
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import netloft
from blocks import FOLDER, blocks

PACKAGE = Path(netloft.__file__).parent
PAGES = [FOLDER / "PYTHON.md", *sorted(FOLDER.glob("notebooks/*.ipynb"))]
MISTAKES = ['gear["tow"].sped', 'gear.solve().reprot', 'gear.solve(strat=None)', 'gear.solve().gradient("mouth/area")["tow.speed"].units', "gear.numbers[3]"]


def mypy(*files):
    return subprocess.run(["/usr/bin/mypy", "--config-file", Path(__file__).parent / "mypy.ini", "--cache-dir", Path(tempfile.gettempdir()) / "netloft_mypy",
                           "--no-error-summary", *files], env={"MYPYPATH": PACKAGE.parent, "PATH": "/usr/bin:/bin"}, capture_output=True, text=True)


class Types(unittest.TestCase):
    def test_are_those_that_pages_use(self):
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for page in PAGES:
                if code := "\n".join(blocks(page)):
                    files.append(Path(folder) / (page.stem.lower().replace("-", "_") + ".py"))
                    files[-1].write_text(code)
            self.assertTrue(files)
            for name in ("torch", "jax"):  # their own code, too
                files.append(Path(folder) / f"with_{name}.py")
                files[-1].write_text(f"import netloft.{name}\n")
            done = mypy(*files)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_find_mistakes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "mistakes.py"
            file.write_text("import netloft\ngear = netloft.load('two-panel.toml')\n" + "\n".join(MISTAKES))
            found = mypy(file).stdout
        lines = [int(line.split(":")[1]) for line in found.splitlines() if ": error: " in line]
        self.assertEqual(lines, [3 + i for i in range(len(MISTAKES))], found)

    def test_of_the_module_have_its_names(self):
        tree = ast.parse((FOLDER / "netloft/_netloft.pyi").read_text())
        for item in (node for node in tree.body if isinstance(node, ast.ClassDef)):
            written = {f.name for f in item.body if isinstance(f, ast.FunctionDef)}
            self.assertEqual(written, {name for name in vars(getattr(netloft, item.name)) if not name.startswith("_")}, item.name)


class TheNamesOfParameters(unittest.TestCase):
    def test_are_those_of_this_build(self):
        with tempfile.TemporaryDirectory() as folder:
            again = Path(folder) / "_tables.pyi"
            subprocess.run([sys.executable, "-B", "-P", FOLDER / "make_stub.py", os.environ["NETLOFT_PROGRAM"], again], check=True)
            self.assertEqual(again.read_text(), (PACKAGE / "_tables.pyi").read_text())

    def test_are_those_of_scenes(self):
        """Every attribute of a part and of a table of a gear, and every output of its elements, is known to type checkers."""
        known = {c.name: {f.name: ast.get_docstring(f) or "" for f in c.body} for c in ast.parse((PACKAGE / "_tables.pyi").read_text()).body
                 if isinstance(c, ast.ClassDef)}
        gear = netloft.load("83-112-at-sea-66m.toml").with_({"gear.nodes": 150})
        r = gear.solve()
        for part in r.parts:
            self.assertLessEqual({name for name in dir(gear[part]) if name.isidentifier()}, known["Numbers"].keys(), part)
            self.assertLessEqual(r[part].outputs.keys(), known["Outputs"].keys(), part)
        for table in ("bed", "ship"):
            self.assertLessEqual(set(dir(gear[table])), known[f"Table_{table}"].keys())
        self.assertIn(f"{gear['headrope'].length.doc} [m]", known["Numbers"]["length"])
        self.assertIn("[kg/m3]", known["Numbers_rope"]["density"])

    @unittest.skipUnless(importlib.util.find_spec("jedi"), "jedi, which completes names in editors, is not installed")
    def test_complete_in_an_editor_with_unit_and_sentence(self):
        import jedi

        project = jedi.Project(tempfile.gettempdir(), added_sys_path=[PACKAGE.parent])
        for line, name, words in (('gear["headrope"].le', "length", "[m]"), ('gear["top-wing"].twine.di', "diameter", "diameter of one twine [m]"),
                                  ('gear.solve()["headrope"].ten', "tension", "[N]")):
            code = f"import netloft\ngear = netloft.load('x')\n{line}"
            completions = {c.name: c.docstring() for c in jedi.Script(code, project=project).complete(3, len(line))}
            self.assertIn(words, completions.get(name, ""), line)


class Help(unittest.TestCase):
    def test_is_there_for_everything_public(self):
        for name in netloft.__all__:
            what = getattr(netloft, name)
            self.assertTrue(inspect.getdoc(what), name)
            members = vars(what).items() if inspect.isclass(what) and what.__module__ != "netloft._netloft" else []
            for member, value in members:
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
