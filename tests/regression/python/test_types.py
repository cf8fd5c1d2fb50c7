# SPDX-License-Identifier: BSD-3-Clause
"""Editors and type checkers know the package: the code of its pages passes the strictest check."""
import ast
import inspect
import subprocess
import tempfile
import unittest
from pathlib import Path

import netloft
from blocks import FOLDER, blocks

PAGES = [FOLDER / "PYTHON.md", *sorted(FOLDER.glob("notebooks/*.ipynb"))]
MISTAKES = ['gear.solve().reprot', 'gear.solve(strat=None)', 'gear.solve().gradient("mouth/area")["tow.speed"].units', "gear.numbers[3]"]


def mypy(*files):
    return subprocess.run(["/usr/bin/mypy", "--config-file", Path(__file__).parent / "mypy.ini", "--cache-dir", Path(tempfile.gettempdir()) / "netloft_mypy",
                           "--no-error-summary", *files], env={"MYPYPATH": FOLDER, "PATH": "/usr/bin:/bin"}, capture_output=True, text=True)


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
