# SPDX-License-Identifier: BSD-3-Clause
"""Runs every command of the program on every page, in a copy of the gear library; each must end with 0.

Commands stand in blocks or between backticks and begin with `netloft` and a subcommand, and say on what. Words in capitals and invented file names stand for files of the library. Long runs use coarse meshes. The README and the guides have tests of
their own, and so have the page of answers to what goes wrong and the pages that `netloft new` writes.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = Path(os.environ["NETLOFT_PROGRAM"]), Path(os.environ["NETLOFT_SOURCE_DIR"])
ELSEWHERE = ("README.md", "framework/guides/", "io/program/templates/", "io/program/MESSAGES.md", "build/")
BLOCK = re.compile(r"^```[^\n]*\n(.*?)^```", re.DOTALL | re.MULTILINE)
FILE = re.compile(r"^```toml (\S+)\n(.*?)^```", re.DOTALL | re.MULTILINE)  # a page's own file, of that name
STANDS_FOR = (
    (r"SCENE --start-from", "gear.toml --set gear.nodes=200 --start-from"),
    (r"scenes/dynamics/SCENE\.toml", "scenes/dynamics/released-rope.toml"), (r"scenes/verification/SCENE\.toml", "scenes/verification/catenary-wire.toml"),
    (r"scenes/SCENE\.toml", "scenes/dead-weight-panel.toml"), (r"\bSCENE\b", "gear-library/scenes/hanging-rope.toml"),
    (r"gear-library/scenes/…", "gear-library/scenes/hanging-rope.toml"), (r"GEAR\.don", "gears/01_two_bars.don"),
    (r"GEAR\.toml", "gear.toml --set gear.nodes=200"), (r"GEAR\.csv", "imports/table"), (r"LINES\.txt", "imports/mooring"), (r"\bGEAR\b", "gear-library/gears/four-panel.toml"),
    (r"\bSTUDY\.toml", "ropes.toml"), (r"\bCALIBRATION\.toml", "calibration.toml"), (r"^netloft study submit$", "netloft study submit ropes.study --engine slurm"),
    (r"^netloft study estimate( FOLDER --at .*)?$", "netloft study estimate ropes.study --at density=2000"),
    (r"^netloft study (\w+)$", r"netloft study \1 ropes.study"), (r"^(netloft study .*)\bFOLDER\b", r"\1ropes.study"), (r"--items \d+", "--items 1"),
    (r"RESULT(\.hdf)?…?", "before.hdf"), (r"\bTYPE\b", "rope/bar"), (r"=P\b", "=diagonal"), (r"=STEP\b", "=1e4"), (r" N\b", " 2"),
    (r"\bSIZE\b", "small"), (r"^\./bootstrap hard-cases ", "hard_cases "), (r"^\./bootstrap ", "netloft "),
    (r"^(netloft (?:design|serve) )", r"timeout -s INT --preserve-status 8 \1"), (r"^build/release/bin/", ""), (r"io/studies/compare/work-precision", "work-precision"))
COARSER = (
    (r"^(netloft compare .*)--accuracy \S+", r"\1--accuracy 1e-1:1e-1 --repeats 1 --set analysis.duration=0.5"),
    (r"^(netloft compare .*)--tolerance \S+", r"\1--tolerance 1e-3:1e-2"), (r"^(netloft compare .*)--cells \S+", r"\1--cells 4,8,16"),
    (r"^(netloft compare .*(scene|panel)\.toml)", r"\1 --set parts.net.cells=[4,4] --repeats 1"),
    (r"^(netloft compare .*)--set parts\.net\.cells=\[8,8\]", r"\1"), (r"^(netloft refine .*)--nodes \S+", r"\1--nodes 150,300"),
    (r"^(hard_cases .*)--size \S+", r"\1--size small"), (r"^(?!.* --case )(hard_cases .*)", r"\1 --case flat-sketch"),
    (r"^(hard_cases .*)", r"\1 --seconds-per-case 0.2"),
    (r'^(netloft run .*) --set "parts\.net\.cells=\[\d+,\d+\]"', r"\1"),
    (r"^(netloft run .*(scene|panel)\.toml)", r"\1 --set parts.net.cells=[8,8]"),
    (r"^(netloft run .*panel-in-current\.toml).*", r"\1 --set parts.net.cells=[8,8] --set analysis.duration=0.5"))
NEED = ("arkode", "kinsol")  # built only where their libraries are


def commands_of(text):
    """The commands of a page, such as `netloft draw RESULT`, but not the mere name of a command, `netloft draw`."""
    lines = [line for block in BLOCK.findall(text) for line in block.replace("\\\n", " ").splitlines()]
    found = [re.sub(r"\s+#.*$", "", line) for line in lines]
    found += [" ".join(words.split()) for words in re.findall(r"`([^`]+)`", BLOCK.sub("", text))]
    found = [line for line in found if not re.fullmatch(r"netloft \w+ \d+", line)]  # the first line of a file: netloft mesh 1
    return [line for line in found if re.match(r"netloft \S+ +[^-\s]|(build/release/bin/)?hard_cases \S|\./bootstrap (run|hard-cases) \S", line)]


def as_tested(command):
    for table in (STANDS_FOR, COARSER):
        for pattern, told in table:
            command = re.sub(pattern, told, command)
    return command


def pages():
    found = {}
    for page in sorted(SOURCE.rglob("*.md")):
        name = str(page.relative_to(SOURCE))
        if not name.startswith(ELSEWHERE) and (commands := commands_of(page.read_text())):
            found[name] = commands
    return found


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = Path(keeper.name)
        shutil.copytree(SOURCE / "gear-library", cls.folder / "gear-library")
        shutil.copytree(SOURCE / "tests/validation/femnet_files", cls.folder / "gears")
        shutil.copytree(SOURCE / "tests/fuzz/seeds/import", cls.folder / "imports")
        shutil.copytree(SOURCE / "tests/stability", cls.folder / "tests/stability")
        shutil.copy(SOURCE / "gear-library/scenes/dead-weight-panel.toml", cls.folder / "scene.toml")
        (cls.folder / "gear.toml").write_text('include = ["gear-library/scenes/four-panel.toml"]\n')
        (cls.folder / "ropes.toml").write_text('scene = "gear-library/scenes/hanging-rope.toml"\n[variables.density]\n'
                                               'key = "parts.rope.rope.density"\nvalues = [2000, 2500, 3000]\n')
        (cls.folder / "calibration.toml").write_text('[scenes.one]\nscene = "gear-library/scenes/hanging-rope.toml"\n[variables.density]\n'
                                                     'key = "parts.rope.rope.density"\nrange = [2000, 3000]\n[[measured]]\n'
                                                     'scene = "one"\nfigure = "results/sag_z"\nvalue = -2.9\ndeviation = 0.1\n')
        cls.type("netloft study plan ropes.toml")
        cls.type("netloft study run ropes.study")
        cls.type("netloft run gear.toml --set gear.nodes=200 -o before.hdf")
        cls.type("netloft run gear.toml --set gear.nodes=200 --set floats.headline-floats.spread='14 along headline' -o after.hdf")
        cls.there = cls.type("netloft list").stdout

    @classmethod
    def type(cls, line):
        environment = {**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-c", line], cwd=cls.folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=200)

    def check(self, command):
        typed = as_tested(command)
        if any(re.search(rf"\b{name}\b", typed) and f"\n{name}" not in self.there for name in NEED):
            return
        with self.subTest(command):
            ended = self.type(typed)
            self.assertEqual(ended.returncode, 0, f"{typed}\n{ended.stdout}{ended.stderr}")

    def test_commands_are_found_in_blocks_and_between_backticks(self):
        page = "Type `netloft draw RESULT`, which is\n`netloft list` and `netloft`.\n```sh\nnetloft run \\\nSCENE # why\n```\n"
        self.assertEqual(commands_of(page), ["netloft run  SCENE", "netloft draw RESULT"])
        self.assertGreater(sum(map(len, pages().values())), 30)

    def test_what_is_typed_is_what_stands_there_but_for_made_up_names(self):
        self.assertEqual(as_tested("netloft describe lumped/net"), "netloft describe lumped/net")
        self.assertEqual(as_tested("netloft draw RESULT.hdf"), "netloft draw before.hdf")

    def test_a_wrong_command_is_noticed(self):
        with self.assertRaises(AssertionError):
            self.assertEqual(self.type("netloft run no-such-scene.toml").returncode, 0)


for name, commands in pages().items():
    def test(self, name=name, commands=commands):
        for file, content in FILE.findall((SOURCE / name).read_text()):
            (self.folder / file).write_text(content)
        for command in commands:
            self.check(command)
    setattr(Pages, "test_" + "".join(c if c.isalnum() else "_" for c in name), test)

if __name__ == "__main__":
    unittest.main(verbosity=2)
