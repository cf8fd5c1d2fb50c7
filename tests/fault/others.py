# SPDX-License-Identifier: BSD-3-Clause
"""Every command that reads files of other people, on each hostile file of its kind, and on folders, pipes and devices."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from answer import Answer

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import files_of_others as others

# Commands that read no files written by other people: plugins are trusted, and parts of the catalogue are the
# user's own.
READ_NONE = {"list", "describe", "schema", "catalogue", "test", "new", "study"}
NO_FILES = {"pipe": "../pipe", "link to a pipe": "link", "device": "/dev/zero", "folder": "empty"}
STUDY = """\
scene = "scene.toml"
[variables.water]
key = "parts.rope.rope.density"
values = [300, 330]
"""
CALIBRATION = """\
[scenes.one]
scene = "FILE"
[variables.density]
key = "parts.rope.rope.density"
range = [300, 360]
[[measured]]
scene = "one"
figure = "results/z"
value = -5
deviation = 1
"""
OPTIMUM = """\
scene = "FILE"
[variables.density]
key = "parts.rope.rope.density"
range = [300, 360]
[objective]
minimise = "results/z"
unit = "m"
"""


class Ground:
    """A folder `work` of a user, beside files that must not be read, shown or changed."""

    def __init__(self, netloft, source, program, outer):
        self.netloft, self.source, self.program, self.outer, self.work = netloft, source, program, outer, outer / "work"
        self.work.mkdir()
        others.lay_out(outer)
        scene = (source / "tests/fault/scene.toml").read_text()
        (self.work / "scene.toml").write_text(scene)
        self.mesh_scene = scene.replace('cells = 6\nsketch = [[0, 0, 0], [3, 0, 0]]\n', 'mesh = "FILE"\n')
        assert self.mesh_scene != scene
        program.succeed(["run", "scene.toml", "-o", "good.hdf"], self.work)
        (self.work / "mesh.toml").write_text(self.mesh_scene.replace("FILE", "good.hdf"))
        program.succeed(["plan", "mesh.toml"], self.work)
        self.good = (self.work / "good.hdf").read_bytes()

    def everything(self):
        return {str(p.relative_to(self.outer)): p.read_bytes() for p in self.outer.rglob("*") if p.is_file() and not p.is_symlink()}

    def ask(self, words, writes, refuses=False):
        """The cell of a table: an exit code or a fault. `refuses`: a good answer is wrong, too."""
        before = self.everything()
        answer = Answer(self.netloft, words, self.work, {"PATH": f"{self.outer}:{os.environ['PATH']}"})
        wrongs = answer.wrongs()
        after = self.everything()
        for name, content in after.items():
            if content == before.get(name):
                continue
            own = Path(name).parts
            if "EXECUTED" in name:
                wrongs.append("executed")
            elif own[0] != "work" or not any("/".join(own[1:]).startswith(one) for one in writes):
                wrongs.append(f"wrote {name}")
            elif others.shows_what_is_foreign(content):
                wrongs.append(f"foreign bytes in {name}")
        wrongs += [f"lost {name}" for name in set(before) - set(after) if not any(name.startswith(f"work/{one}") for one in writes)]
        if others.shows_what_is_foreign(answer.out) or others.shows_what_is_foreign(answer.err):
            wrongs.append("foreign bytes shown")
        if refuses and answer.code in (0, 3):
            wrongs.append(f"exit {answer.code}")
        for name in set(after) - set(before):
            (self.outer / name).unlink()
        for name, content in before.items():
            if after.get(name) != content:
                (self.outer / name).write_bytes(content)
        if wrongs:
            print(f"netloft {' '.join(words)}: {', '.join(wrongs)}: {answer.err[-300:]!r}", file=sys.stderr, flush=True)
        return ", ".join(wrongs) or str(answer.code), bool(wrongs)


class Table:
    """Rows are commands, columns files."""

    def __init__(self, what):
        self.what, self.rows, self.columns, self.wrong, self.tries = what, {}, [], 0, 0

    def add(self, row, column, cell, is_wrong):
        self.rows.setdefault(row, {})[column] = cell
        self.columns += [column] * (column not in self.columns)
        self.wrong += is_wrong
        self.tries += 1

    def __str__(self):
        rows = [[self.what, *self.columns], ["---"] * (len(self.columns) + 1),
                *([row, *(cells.get(column, "") for column in self.columns)] for row, cells in self.rows.items())]
        return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def spoken(words, name):
    """A command without names of files, so that equal commands share a row."""
    return " ".join(word.replace(name, "FILE") for word in words)


def ask_results(ground):
    table = Table("command on a result")
    for kind, change in {**{name: change for name, (change, _) in others.REFUSED.items()}, **others.SHOWN}.items():
        name = "x.hdf"
        others.write_result(ground.work / name, ground.good, change)
        (ground.work / "mesh.toml").write_text(ground.mesh_scene.replace("FILE", name))
        for writes, *words in others.commands_on(name):
            is_refused = kind in others.REFUSED and not (kind == "names-of-holds" and "mesh.toml" in words)
            table.add(spoken(words, name), kind, *ground.ask(words, (*writes, "o.xdmf"), is_refused))
    for name in ("x.hdf", "mesh.toml"):
        (ground.work / name).unlink()
    return table


def ask_journals(ground):
    """Files that a killed run may leave, and journals whose inputs refer to other files."""
    table = Table("command on a journal")
    motion = ["run", str(ground.source / "gear-library/scenes/dynamics/released-rope.toml"), "--set", "analysis.duration=2", "--set",
              "analysis.output_interval=0.5", "--set", "parts.rope.cells=4", "-o", "r.hdf"]
    part = ground.work / "r.hdf.part"
    (ground.work / "r.hdf.new").mkdir()  # with this in its way a motion stays a journal
    ground.program.run(motion, ground.work)
    (ground.work / "r.hdf.new").rmdir()
    journal = part.read_bytes()
    asked = (["report", part.name], ["view", part.name, "-o", "o.html"], ["diff", part.name, part.name], ["export", part.name, "o.csv"],
             ["draw", part.name, "-o", "o.svg"], motion, [*motion, "--resume"])

    def ask(kind):
        for words in asked:
            words_shown = words if words[0] != "run" else ["run", "SCENE", "-o", "r.hdf", *words[8:][2:]]
            table.add(spoken(words_shown, part.name), kind, *ground.ask(words, ("o.", "r."), words[0] != "run"))
    for kind, (change, _) in others.IN_JOURNALS.items():
        part.write_bytes(journal)
        others.rewrite_journal(part, others.in_image(change, ground.outer / "image"))
        (ground.outer / "image").unlink()
        ask(kind)
    for kind, (change, _) in others.OUTSIDE.items():
        others.write_result(part, ground.good, change)
        ask(f"result, {kind}")
    part.unlink()
    return table


def ask_studies(ground):
    table = Table("action on a study")
    (ground.work / "s.toml").write_text(STUDY)
    ground.program.succeed(["study", "plan", "s.toml"], ground.work)
    ground.program.succeed(["study", "run", "s.study"], ground.work)
    name, place = "x.study", ground.work / "x.study"

    def ask(kind, refuses):
        for words in others.actions_on(name):
            words = [word.replace("water=1005", "water=310") for word in words]
            table.add(spoken(words, name), kind, *ground.ask(["study", *words], (name,), refuses))
        shutil.rmtree(place)

    def change(values):
        return lambda head: head.update(values)
    for kind, called in {**others.NAMES_OF_STUDIES, "absolute": str(ground.outer / "pwned")}.items():
        shutil.copytree(ground.work / "s.study", place)
        others.change_manifest(place / "manifest.jsonl", change({"name": called}))
        ask(f"named {kind}", True)
    for kind in ("pipe", "link"):
        for victim in ("manifest.jsonl", "record"):
            shutil.copytree(ground.work / "s.study", place)
            path = place / victim if "." in victim else sorted((place / "items").glob("*.json"))[0]
            path.unlink()
            os.mkfifo(path) if kind == "pipe" else path.symlink_to(ground.outer / "pipe")
            ask(f"{victim} is a {kind}", victim != "record")
    shutil.copytree(ground.work / "s.study", place)
    record = sorted((place / "items").glob("*.json"))[0]
    record.with_suffix(".failed").write_text(others.ESCAPES)
    record.unlink()
    ask("escapes in a failure", False)
    return table


def commands_on_inputs(ground):
    """Words of a command, with FILE for the file that it reads, and files that refer to FILE."""
    made = {"included.toml": 'include = ["FILE"]\n', "mesh.toml": ground.mesh_scene,
            "parts.toml": 'catalogue = ["FILE"]\n' + (ground.work / "scene.toml").read_text(),
            "of.toml": STUDY.replace("scene.toml", "FILE"), "cal.toml": CALIBRATION, "best.toml": OPTIMUM}
    direct = (["run", "FILE"], ["run", "scene.toml", "--start-from", "FILE"], ["plan", "FILE"], ["refine", "FILE"], ["compare", "FILE", "--solver", "newton"],
              ["scope", "FILE", "--depth", "20:40"], ["sensitivity", "FILE"], ["check", "FILE"], ["draw", "FILE", "-o", "o.svg"], ["calibrate", "FILE"], ["optimise", "FILE"],
              ["report", "FILE"],
              ["view", "FILE", "-o", "o.html"], ["diff", "FILE", "good.hdf"], ["diff", "good.hdf", "FILE"], ["export", "FILE", "o.csv"],
              ["import", "table", "FILE"], ["import", "moordyn", "FILE"], ["import", "femnet", "FILE"],
              ["import", "femnet", str(ground.source / "tests/validation/femnet_files/01_two_bars.don"), "--mesh", "FILE"], ["import", "--check", "FILE"],
              ["study", "plan", "FILE"], *(["study", *words] for words in others.actions_on("FILE")))
    through = (["plan", "included.toml"], ["run", "included.toml"], ["plan", "mesh.toml"], ["run", "mesh.toml"], ["plan", "parts.toml"],
               ["check", "included.toml"], ["study", "plan", "of.toml"], ["calibrate", "cal.toml"], ["optimise", "best.toml"])
    return made, direct, through


def ask_inputs(ground):
    table = Table("command that reads")
    made, direct, through = commands_on_inputs(ground)
    (ground.work / "link").symlink_to(ground.outer / "pipe")
    (ground.work / "empty").mkdir()
    for kind, path in NO_FILES.items():
        for name, text in made.items():
            (ground.work / name).write_text(text.replace("FILE", path))
        for words in (*direct, *through):
            # An empty folder is accepted: as an empty catalogue, and by --check as a folder without gears.
            may_be = kind == "folder" and ("--check" in words or "parts.toml" in words) or "parts.toml" in words
            words_now = [path if word == "FILE" else word for word in words]
            shown = " ".join(Path(word).name if word.startswith("/") else word for word in words)
            table.add(shown, kind, *ground.ask(words_now, ("o.",), not may_be))
    asked = {words[0] for words in (*direct, *through)}
    help_text = subprocess.run([ground.netloft, "--help"], capture_output=True, text=True, check=True).stdout
    for command in re.findall(r"(?m)^  ([a-z]+) {2,}[a-z]", help_text):
        if command not in asked | READ_NONE:
            table.add(command, "pipe", "not asked: add it here", True)
    return table


def ask_all(netloft, source, program, outer):
    """Tables, the number of commands, and the number of wrong answers."""
    ground = Ground(netloft, source, program, outer)
    tables = [ask(ground) for ask in (ask_results, ask_journals, ask_studies, ask_inputs)]
    return "\n\n".join(map(str, tables)), sum(table.tries for table in tables), sum(table.wrong for table in tables)
