# SPDX-License-Identifier: BSD-3-Clause
"""Runs every flag of every `--help`.

The flags are those that the help of the program lists, the commands are below: a flag of the help that no command uses is a failure, and so is a flag that the help does not list. Each command must end with 0 and write the file or the text that follows it.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = os.environ["NETLOFT_PROGRAM"], Path(os.environ["NETLOFT_SOURCE_DIR"])
HARD_CASES = Path(PROGRAM).with_name("hard_cases")
PLUGINS = os.environ["NETLOFT_TEST_PLUGINS"]
ROPE, MOTION, GEAR = "rope.toml", "motion.toml", "gear.toml"
AT_SEA = SOURCE / "gear-library/scenes/gov-like-67m.toml"
PRINTED = "--color always --json"
COMMON = f"--plugins {PLUGINS} {PRINTED}"
SCENE = "--set parts.rope.cells=20 --threads 1 --scene-plugins " + COMMON


def until_it_serves(command):
    """The command with its output, stopped as by Ctrl-C as soon as it has printed its address."""
    return f"rm -f served; touch served; {command} > served & while kill -0 $! && ! grep -q http served; do sleep 0.05; done; kill -INT $!; wait $!; ended=$?; cat served; (exit $ended)"


# Each command, and words of its output or the file that it writes. The order matters, because commands read
# files that earlier commands have written.
COMMANDS = (
    ("netloft --help", "calibrate"),
    ("netloft --version", "netloft "),
    ("netloft --cflags", "-std="),
    (f"netloft run {ROPE} {SCENE} --strategy direct --solver newton --error -o error.hdf", '"converged"'),
    (f"netloft run {ROPE} --sensitivities -o depends.hdf", "depends most on"),
    (f"netloft run {ROPE} --stages -o stages.hdf", "written to stages.hdf"),
    (f"netloft run {ROPE} --output rope.hdf", "written to rope.hdf"),
    (f"netloft run {ROPE} --set parts.rope.cells=20 -o coarse.hdf", "written to coarse.hdf"),
    (f"mkdir motion.hdf.new; netloft run {MOTION} -o motion.hdf; rmdir motion.hdf.new; ls motion.hdf.part", "motion.hdf.part"),
    (f"netloft run {MOTION} --resume -o motion.hdf && [ ! -e motion.hdf.part ]", "finished"),
    (f"netloft run {ROPE} --set parts.rope.cells=20 --start-from rope.hdf -o again.hdf", "written to again.hdf"),
    (f"cp rope.hdf kept.hdf.part; netloft run {ROPE} --overwrite -o kept.hdf", "written to kept.hdf"),
    (f"netloft plan {ROPE} {SCENE} --strategy auto:restarts=2 --solver newton", '"memory"'),
    (until_it_serves(f"netloft design {ROPE} --no-browser --beside {ROPE} --port 7113 --threads 1 --scene-plugins {COMMON}"), "http://127.0.0.1:7113/"),
    (until_it_serves(f"netloft serve {ROPE} --beside {ROPE} --port 7114 --threads 1 --scene-plugins {COMMON}"), "http://127.0.0.1:7114/"),
    (f"netloft list {COMMON}", "rope/bar"),
    (f"netloft describe rope/bar {COMMON}", "rope.EA"),
    (f"netloft schema {COMMON}", "$schema"),
    (f"netloft test float --seconds 50 --verbose {COMMON}", "float/float"),
    ("netloft new law square_plate", "square_plate.cpp"),
    ("netloft new two-panel small -o first; ls first", "small.toml"),
    (f"netloft catalogue twine {PRINTED}", "pe-braided-4mm"),
    (f"netloft check {GEAR} --set ropes.headline.length=7 --scene-plugins {COMMON}", '"findings"'),
    (f"netloft draw {GEAR} --set ropes.headline.length=7 {PRINTED} --mesh --nodes 200 -o mesh.svg; ls mesh.svg", "mesh.svg"),
    ("netloft draw rope.hdf --view side --field part --state 0 --width 300 --fit all --dark --output rope.png; ls rope.png", "rope.png"),
    ("netloft draw rope.hdf --log --elements --dimensions -o tension.png; ls tension.png", "tension.png"),
    (f"netloft compare {ROPE} {SCENE} --strategy direct --solver newton --solver lbfgs --tolerance 1e-6:1e-6 --cells rope=10,20 "
     "--reference newton --repeats 1 -o table.csv -o work.svg; head -1 table.csv work.svg", "work.svg"),
    (f"netloft compare {MOTION} --set analysis.duration=0.1 --integrator newmark --accuracy 1e-1:1e-1 --repeats 1 {COMMON}", "newmark"),
    ("netloft diff rope.hdf coarse.hdf --json", '"after"'),
    ("netloft diff rope.hdf coarse.hdf --all", "quantity"),
    (f"netloft refine {ROPE} {SCENE} --strategy direct --solver newton --cells 10,20", "sag_z"),
    ("netloft refine trawl.toml --nodes 150,300", "headline"),
    (f"netloft scope {AT_SEA} {COMMON} --set gear.nodes=600 --threads 1 --scene-plugins --strategy auto --solver newton --depth 65:67:2 "
     "--warp 3.3:3.4:2 --heel -40:40 --spread 1:200 -o scope.svg; ls scope.svg", "scope.svg"),
    (f"netloft scope {AT_SEA} --set gear.nodes=600 --depth 65:67:2 --warp 3.3:3.4:2 --heel -40:40 --output scope.html", "headline"),
    (f"netloft sensitivity {AT_SEA} {COMMON} --set gear.nodes=300 --threads 1 --scene-plugins --strategy auto --solver newton --to ship.speed "
     "--of mouth/headline_height", '"per_unit"'),
    (f"netloft sensitivity {ROPE} --to parts.rope.rope --check -o bars.svg; ls bars.svg", "bars.svg"),
    (f"netloft sensitivity {ROPE} --to parts.rope.rope --output more.svg; ls more.svg", "more.svg"),
    (f"netloft sensitivity {ROPE} --to parts.rope.rope -o table.hdf; ls table.hdf", "table.hdf"),
    (f"hard_cases tests/stability --set analysis.newton.damping=0 --solver newton --size small --case flat-sketch --seed 2 --work 1000 "
     f"--seconds-per-case 5 --threads 1 -o matrix.html {COMMON}", '"newton"'),
    ("hard_cases tests/stability --strategy auto --without restarts --size small --case flat-sketch --update-references", "auto"),
    ("hard_cases tests/stability --strategy auto --flow on --size small --case trawl/current-1", "auto"),
    ("netloft import femnet gears/01_two_bars.don --mesh gears/01_two_bars.mdg --json -o bars.toml; ls bars.toml bars.mesh", "bars.mesh"),
    ("netloft import femnet gears/01_two_bars.don --divide -o divided.toml; ls divided.mesh", "divided.mesh"),
    ("netloft import femnet gears/09_hauling.don --motion -o moving.toml; grep dynamic moving.toml", "dynamic"),
    ("netloft import --check gears --color never", "01_two_bars"),
    (f"netloft study plan study.toml {COMMON} -o ropes", '"points": 6'),
    (f"netloft study run ropes --items 1-2 --jobs 2 --threads 1 {COMMON}", '"computed": 2'),
    ("netloft study collect ropes --color never --json; head -1 ropes/table.csv", '"converged": 6'),
    ("mkdir tables; netloft study collect ropes -o tables; head -1 tables/table.csv", "density"),
    ("netloft study missing ropes && echo none", "none"),
    (f"netloft study submit ropes --engine slurm --chunk 2 {COMMON}; ls ropes/slurm.sh", "slurm.sh"),
    (f"netloft study submit ropes --engine parallel --jobs 2 {COMMON}; ls ropes/parallel.sh", "parallel.sh"),
    ("netloft study show ropes --figure results/sag_z --over density --by cells --color never --json -o sag.svg; ls sag.svg", "sag.svg"),
    ("netloft study show ropes --figure results/sag_z --over density --at cells=20 --output sag.html; ls sag.html", "sag.html"),
    (f"netloft calibrate calibration.toml {COMMON}", '"variables"'),
    (f"netloft optimise optimum.toml {COMMON} -o best; ls best/scene.toml best/history.svg", "best/scene.toml"),
    ("netloft optimise optimum.toml --output again; netloft run again/scene.toml -o best.hdf", "written to best.hdf"),
    ("netloft report rope.hdf --json", '"sag_z"'),
    ("netloft report rope.hdf --csv", "sag_z"),
    ("netloft report rope.hdf --output rope-report.html; ls rope-report.html", "rope-report.html"),
    ("netloft report rope.hdf -o rope-page.html; ls rope-page.html", "rope-page.html"),
    ("netloft view rope.hdf --states 2 --json -o rope-view.html", "rope-view.html"),
    ("netloft export rope.hdf elements.csv --table elements --state 0 --json; head -1 elements.csv", "tension"),
    ("netloft export rope.hdf rope.glb --field part --json", "rope.glb"),
    ("netloft export rope.hdf -o rope.obj; ls rope.obj", "rope.obj"),
)
NESTED = ("study",)  # commands of commands
FLAG = re.compile(r"^ +(?:(-\w),)?(--[\w-]+(?:,--[\w-]+)*)", re.MULTILINE)
HEADING = "(?:Gears|Scenes|Results|Studies|Numerics|Plugins|Subcommands)"


def flags_in_help(*command):
    program = [HARD_CASES] if command == ("hard_cases",) else [PROGRAM, *command]
    text = subprocess.run([*program, "--help"], capture_output=True, text=True, timeout=20).stdout
    return {long: short for short, names in FLAG.findall(text) for long in names.split(",")}


def subcommands(*command):
    """All commands with their subcommands: "run", "study", "study plan"."""
    text = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, timeout=20).stdout
    names = re.findall(r"^  (\w+) +\w", "".join(re.findall(rf"^{HEADING}:\n((?:  .*\n)+)", text, re.MULTILINE)), re.MULTILINE)
    return [full for name in names for full in (" ".join((*command, name)), *subcommands(*command, name))]


def typed_flags(line):
    """(command, flag) of the first command of a line that is netloft's, or of hard_cases, which is a command itself."""
    words = shlex.split(next(re.finditer(r"(?:netloft|hard_cases) [^;&]*", line)).group())
    words = words if words[0] == "hard_cases" else words[1:]
    command = words[0] if not words[0].startswith("-") else ""
    command = " ".join(words[:2]) if command in NESTED else command
    return {(command, word) for word in words if re.match(r"--?[a-z]", word)}


class Flags(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = Path(keeper.name)
        library = SOURCE / "gear-library"
        shutil.copy(library / "scenes/hanging-rope.toml", cls.folder / ROPE)
        shutil.copy(library / "scenes/dynamics/panel-in-current.toml", cls.folder / MOTION)
        shutil.copy(library / "gears/four-panel.toml", cls.folder / GEAR)
        shutil.copytree(SOURCE / "tests/validation/femnet_files", cls.folder / "gears")
        shutil.copytree(SOURCE / "tests/stability", cls.folder / "tests/stability")
        shutil.copytree(library, cls.folder / "gear-library")
        (cls.folder / "study.toml").write_text(f'scene = "{ROPE}"\npath = ["density"]\n'
                                               '[variables.cells]\nkey = "parts.rope.cells"\nvalues = [10, 20]\n'
                                               '[variables.density]\nkey = "parts.rope.rope.density"\nvalues = [2000, 2500, 3000]\n')
        (cls.folder / "calibration.toml").write_text(f'[scenes.one]\nscene = "{ROPE}"\n[variables.density]\n'
                                                     'key = "parts.rope.rope.density"\nrange = [2000, 3000]\n[[measured]]\n'
                                                     'scene = "one"\nfigure = "results/sag_z"\nvalue = -2.9\ndeviation = 0.1\n')
        (cls.folder / "optimum.toml").write_text(f'scene = "{ROPE}"\n[variables.length]\nkey = "parts.rope.length"\nrange = ["9 m", "11 m"]\n'
                                                 '[objective]\nminimise = "results/end_tension"\nunit = "N"\n')
        (cls.folder / "trawl.toml").write_text(f'include = ["{library}/scenes/four-panel.toml"]\n')

    def type(self, line):
        environment = {**os.environ, "PATH": f"{Path(PROGRAM).parent}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-c", line], cwd=self.folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=100)

    def test_commands_with_every_flag_work(self):
        for line, says in COMMANDS:
            with self.subTest(line):
                ended = self.type(line)
                self.assertEqual(ended.returncode, 0, f"{line}\n{ended.stdout}{ended.stderr}")
                self.assertIn(says, ended.stdout + ended.stderr, line)

    def test_every_flag_of_the_help_is_typed(self):
        typed = set().union(*(typed_flags(line) for line, _ in COMMANDS))
        listed = subcommands()
        self.assertGreater(len(listed), 15)
        for command in ["", *listed, "hard_cases"]:
            for flag, short in flags_in_help(*command.split()).items():
                if flag == "--help" and command:
                    continue  # asked for here
                self.assertTrue({(command, flag), (command, short)} & typed, f"no command types {command} {flag}")

    def test_every_flag_that_is_typed_is_in_the_help(self):
        for line, _ in COMMANDS:
            for command, flag in typed_flags(line):
                known = flags_in_help(*command.split())
                self.assertIn(flag, {*known, *known.values()}, line)

    def test_the_table_of_solvers_has_the_parameters_that_the_program_has(self):
        page = (SOURCE / "io/scenes/SCENE.md").read_text()
        for solver in ("newton", "ptc", "relaxation", "lbfgs"):
            cell = re.search(rf"^\| `{solver}` \| (.*) \|$", page, re.MULTILINE)[1]
            listed = set(re.findall(r"`(\w+)`", cell))
            described = json.loads(self.type(f"netloft describe {solver} --json").stdout)
            self.assertTrue(listed, solver)
            self.assertLessEqual(listed, {p["name"] for p in described["parameters"]}, solver)

    def test_a_flag_that_nobody_types_is_noticed(self):
        self.assertNotIn(("run", "--frobnicate"), set().union(*(typed_flags(line) for line, _ in COMMANDS)))
        self.assertEqual(typed_flags("netloft run a.toml --set x=1 -o b.hdf; ls --all"), {("run", "--set"), ("run", "-o")})


if __name__ == "__main__":
    unittest.main(verbosity=2)
