#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Edits designs at random, and counts what `netloft serve` does wrong.

    design_edits.py NETLOFT GEAR_LIBRARY [--edits 10000] [--gears 7] [--nodes 150] [--seed 1] [--table FILE]

Each gear is a copy of files of the library, with comments. Edits are new values of numbers, one or several before the answer to the last, other
values of the plan, parts that are added and removed, texts that are wrong or cut off, undo, redo, and files that another program changes. Last,
the load of a truss of two bars is moved, which snaps through: every snap has to be said. It prints a Markdown table and exits with 1 unless
all of these counts are 0:
    ended           the program or its solver ended, or a request was answered by neither its answer nor a sentence
    other figures   after `run`, a figure differs from that of `netloft run` of the saved file by more than 1e-9, or one of both found none
    other lines     an edit of a number changed another line or a comment, a refused part changed a text, or a saved file is not the text that was shown
    silent jumps    the shape is noticeably, and farther than the tangent led, from where it led, and nothing says so
    no way back     after undoing a part or everything, the texts are not those before, to the byte
    memory          both processes together hold over 5 % more after the last quarter of the edits than after the second
"""
import argparse
import base64
import http.client
import json
import random
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

import numpy as np

SCENES = ("83-112-flume-3.0kn", "gov-like-67m", "83-112-at-sea-66m", "four-panel", "two-panel", "pelagic-with-doors", "codend-from-plan")
# Two bars, 2 m wide and 0.2 m high, that lean against each other; under about 30 N at the top they snap through (tests/unit/io/studies/truss.hpp).
TRUSS = """[water]
density = 0
[parts.truss]
type = "rope/bar"
cells = 2
length = 2.0396078054371140
sketch = [[-1, 0, 0], [0, 0, 0.2], [1, 0, 0]]
rope = { diameter = "10 mm", EA = 10000, EA_compression = 10000, density = 1e-6 }
[parts.load]
type = "force/constant"
on = "truss.middle"
force = { z = 1 }
[[hold]]
on = ["truss.start", "truss.end"]
[[hold]]
on = "truss.middle"
axes = "y"
[results]
z = { of = "truss.middle", take = "z" }
"""
FOLD = 30.5  # N, 3 % more than the load at the fold, 29.6 N by (1) and (2) of truss.hpp
MOVES_OF_TRUSS = 60
HARMS = ("ended", "other figures", "other lines", "silent jumps", "no way back", "memory")
SAME = 1e-9
NOTICED = 3e-3  # of the extent of the shape: three times the fraction of the sketch's that the program notices
MOST_MEMORY = 1.05
EVERY = 25  # edits between two looks at the memory
COMMENT = re.compile(r"#.*")


class Harm(Exception):
    """One of HARMS, and a description."""


def points_of(packed):
    """Three coordinates per node: bytes are sorted by their place within a number."""
    data = np.frombuffer(zlib.decompress(base64.b64decode(packed["d"])), np.uint8)
    return data.reshape(4, -1).T.copy().view("<f4").reshape(-1, 3).astype(float)


class Design:
    """A program that serves a copy of a scene."""

    def __init__(self, program, library, text):
        self.keeper = tempfile.TemporaryDirectory()
        self.folder, self.program = Path(self.keeper.name), program
        for name in ("gears", "scenes"):
            shutil.copytree(library / name, self.folder / name, ignore=shutil.ignore_patterns("dynamics", "validation", "verification"))
        (self.folder / "own.toml").write_text(text)
        self.process = subprocess.Popen([program, "serve", "own.toml", "--json", "--threads", "1"], cwd=self.folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)
        host, self.token = re.fullmatch(r"http://(.*?)/(\w+)/", json.loads(self.process.stdout.readline())["address"]).groups()
        self.connection = http.client.HTTPConnection(host, timeout=600)

    def ask(self, name, **body):
        """The answer; None if the request is refused with a sentence."""
        try:
            self.connection.request("POST", f"/{self.token}/api/{name}", json.dumps(body), {"Content-Type": "application/json"})
            reply = self.connection.getresponse()
            answer = json.loads(reply.read())
        except (OSError, http.client.HTTPException, ValueError) as e:
            raise Harm("ended", f"{name} {body}: {e}") from e
        if reply.status == 200:
            outcome = answer.get("outcome") or answer
            if outcome.get("status") == "solver ended":
                raise Harm("ended", f"{name} {body}: {outcome['sentence']}")
            return answer
        if reply.status not in (409, 422) or not answer.get("error"):
            raise Harm("ended", f"{name} {body}: {reply.status} {answer}")
        return None

    def texts(self):
        return {f["name"]: f["text"] for f in self.ask("state")["files"]}

    def memory(self):
        """Resident bytes of the program and its solver [kB]."""
        pid = self.process.pid
        solvers = [p for task in Path(f"/proc/{pid}/task").glob("*/children") for p in task.read_text().split()]
        return sum(int(re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{p}/status").read_text())[1]) for p in (pid, *solvers))

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(60)
        self.keeper.cleanup()


class Editor:
    """Edits one design and looks for harm."""

    def __init__(self, design, chance):
        self.design, self.chance, self.counts = design, chance, {harm: 0 for harm in HARMS}
        self.said, self.done, self.runs, self.jumps, self.parts = [], {}, 0, 0, 0
        self.first = self.attempt(self.begin)
        self.memories = []

    def begin(self):
        if self.design.ask("solve")["status"] != "converged":
            raise Harm("ended", "the scene of the library has no equilibrium")
        return self.design.texts()

    def attempt(self, work):
        try:
            return work()
        except Harm as harm:
            self.counts[harm.args[0]] += 1
            self.said.append(harm.args[1])
        return None

    def edit(self, count):
        kinds = ((self.move, 30), (self.hurry, 30), (self.compare_ghost, 8), (self.other_value, 8), (self.spoil, 8), (self.take_back, 12), (self.by_another, 1), (self.compare_run, 3),
                 (self.add_part, 5), (self.remove_part, 5))
        for i in range(count):
            work = self.chance.choices([k for k, _ in kinds], [w for _, w in kinds])[0]
            self.done[work.__name__] = self.done.get(work.__name__, 0) + 1
            self.attempt(work)
            if self.design.process.poll() is not None:
                return
            if i % EVERY == 0:
                self.memories.append(self.design.memory())
        self.attempt(self.go_all_the_way_back)
        self.attempt(self.compare_memory)

    # ---- edits

    def number(self):
        """A number of the scene and a new value, within its range and near the one in the first text."""
        numbers = [n for n in self.design.ask("state")["numbers"] if n["value"] is not None and n["path"] not in ("gear.nodes", "gear.size")]
        if not numbers:
            return None
        one = self.chance.choice(numbers)
        to = one["value"] * self.chance.uniform(0.9, 1.1)
        to = round(to) + self.chance.choice((0, 0, 1)) if one.get("whole") else float(f"{to:.4g}")
        for name, clip in (("least", max), ("largest", min)):
            if one.get(name) is not None:
                to = clip(to, one[name])
        return one["path"], to

    def move(self, wait=True):
        chosen = self.number()
        if not chosen:
            return self.design.ask("undo")
        before = self.design.texts()
        answer = self.design.ask("apply", path=chosen[0], to=chosen[1], wait=wait, goes_on=self.chance.random() < 0.2)
        if answer:
            self.look_at_lines(before, {f["name"]: f["text"] for f in answer["files"]}, answer["edit"])
        if answer and wait and answer["outcome"] and answer["outcome"]["status"] == "wrong input":
            self.design.ask("undo")
        return answer

    def hurry(self):
        for _ in range(self.chance.randint(1, 4)):
            self.move(wait=False)
        if self.design.ask("solve")["status"] != "converged" and self.chance.random() < 0.8:
            self.design.ask("undo")

    def other_value(self):
        paths = ("gear.nodes=120", "gear.nodes=180", "gear.extent=whole", "gear.extent=half", "elements.netting.twine.EA_compression=0",
                 "floats.headline.spread=40 along headrope", "tow.speed=2 kg", "no.such=3", "panels=[1]", "analysis.max_iterations=3")
        if self.design.ask("apply", set=self.chance.choice(paths), wait=True) and self.chance.random() < 0.8:
            self.design.ask("undo")

    def spoil(self):
        """A text with a line doubled, without a line, cut off, or with characters that do not belong there."""
        name, text = self.chance.choice(sorted(self.design.texts().items()))
        lines, at = text.split("\n"), self.chance.randrange(text.count("\n") + 1)
        wrong = self.chance.choice((lines[:at] + lines[at:at + 1] + lines[at:], lines[:at] + lines[at + 1:], lines[:at], lines[:at] + ['= "\u2620 ]['] + lines[at:],
                                    lines[:at] + [lines[at].replace("=", "= -9e9 #")] + lines[at + 1:]))
        self.design.ask("apply", file=name, text="\n".join(wrong), wait=True)
        self.design.ask("check")
        self.design.ask("undo")

    def take_back(self):
        for _ in range(self.chance.randint(1, 6)):
            self.design.ask("undo")
        for _ in range(self.chance.randint(0, 6)):
            self.design.ask("redo")

    def by_another(self):
        """Another program adds a comment to a file that is saved."""
        self.design.ask("save")
        name = self.chance.choice(sorted(self.design.texts()))
        changed = (self.design.folder / name).read_text() + "# by another program\n"
        (self.design.folder / name).write_text(changed)
        for _ in range(200):
            if self.design.texts()[name] == changed:
                return
            time.sleep(0.1)
        raise Harm("other lines", f"{name} was changed by another program and not read again")

    def add_part(self):
        found = self.design.ask("parts")
        if not found:
            return
        kind, choices = self.chance.choice(found["templates"]), {}
        for field in kind["fields"]:
            if field["choices"]:
                choices[field["name"]] = self.chance.choice(field["choices"])
            elif self.chance.random() < 0.5:
                choices[field["name"]] = self.chance.choice((1, 3, 12, 2.5)) if field["of"] == "metres" else self.chance.randint(1, 40)
        self.change_parts("add", kind=kind["kind"], **choices)

    def remove_part(self):
        found = self.design.ask("parts")
        if found and found["parts"]:
            self.change_parts("remove", part=self.chance.choice(found["parts"]))

    def change_parts(self, request, **body):
        before = self.design.texts()
        answer = self.design.ask(request, wait=self.chance.random() < 0.8, **body)
        if answer is None and self.design.texts() != before:
            raise Harm("other lines", f"{request} {body} was refused and has changed a text")
        if answer is None:
            return
        self.parts += 1
        if self.chance.random() < 0.7:
            self.design.ask("undo")
            if self.design.texts() != before:
                raise Harm("no way back", f"{request} {body} was undone, and the text is another one")

    # ---- what must be

    def look_at_lines(self, before, after, edit):
        for name, text in after.items():
            old, new = before[name].split("\n"), text.split("\n")
            if name != edit["file"]:
                if old != new:
                    raise Harm("other lines", f"{name} was changed, too: {edit}")
                continue
            begin = edit["line"] - 1
            end = len(new) - begin - 1 - edit["after"].count("\n")
            if old[:begin] != new[:begin] or (end > 0 and old[-end:] != new[-end:]):
                raise Harm("other lines", f"{name}: more than {edit}")
            if "\n" not in edit["before"] + edit["after"] and COMMENT.findall(old[begin]) != COMMENT.findall(new[begin]):
                raise Harm("other lines", f"{name}: the comment of line {begin + 1}")

    def compare_ghost(self):
        outcome = self.design.ask("solve")
        chosen = self.number()
        if not chosen or not outcome or outcome["status"] != "converged":
            return
        tangent = self.design.ask("jvp", path=chosen[0])
        answer = self.design.ask("apply", path=chosen[0], to=chosen[1], wait=True)
        after = answer and answer["outcome"]
        if not tangent or not tangent["motion"] or not after or after["status"] != "converged" or after["revision"] != answer["revision"]:
            return
        before, now, motion = points_of(outcome["points"]), points_of(after["points"]), points_of(tangent["motion"])
        self.jumps += after["jump"] is not None
        if not after["same_mesh"] or len(now) != len(before):
            return
        led = (chosen[1] - tangent["value"]) * motion
        off = np.linalg.norm(now - before - led, axis=1).max()
        if off > NOTICED * np.ptp(before, axis=0).max() and off > 1.02 * np.linalg.norm(led, axis=1).max() and not after["jump"]:
            raise Harm("silent jumps", f"{chosen}: {off:.3g} m off")

    def compare_run(self):
        """Whether a run of the saved file finds what is shown."""
        outcome = self.design.ask("run")
        if not outcome:
            return
        if self.design.ask("save") is None:
            return  # the file was just changed by another program
        for name, text in self.design.texts().items():
            if (self.design.folder / name).read_text() != text:
                raise Harm("other lines", f"{name} is not what was shown")
        run = subprocess.run([self.design.program, "run", "own.toml", "--json", "-o", "own.hdf"], cwd=self.design.folder, capture_output=True, text=True,
                             timeout=600)
        self.runs += 1
        is_found = run.returncode == 0
        if is_found != (outcome["status"] == "converged" and outcome["as_run"]):
            raise Harm("other figures", f"the page says {outcome['status']}, the run ends with {run.returncode}: {run.stderr[-300:]}")
        if not is_found:
            return
        shown = {f["name"]: f["value"] for f in outcome["figures"]}
        for name, value in json.loads(run.stdout)["gear"]["figures"].items():
            if value is not None and not abs(shown[name] - value) <= SAME * max(abs(value), 1):
                raise Harm("other figures", f"{name}: {shown[name]} shown, {value} in the run")

    def go_all_the_way_back(self):
        while self.design.ask("state")["can_undo"]:
            self.design.ask("undo")
        if self.design.texts() != self.first:
            raise Harm("no way back", "the first texts are not those after undoing everything")

    def compare_memory(self):
        quarter = len(self.memories) // 4
        if quarter < 4:
            return  # too few to tell
        then, now = statistics.median(self.memories[quarter:2 * quarter]), statistics.median(self.memories[-quarter:])
        self.growth = now / then
        if now > MOST_MEMORY * then:
            raise Harm("memory", f"{then:.0f} kB, and later {now:.0f} kB")


def edit_gear(options, scene, index):
    """A row of the table, and what is to say about it."""
    text = f'# a design\ninclude = ["scenes/{scene}.toml"]   # of the library\n[gear]\nnodes = {options.nodes}   # few\n'
    design = Design(str(Path(options.netloft).resolve()), options.library.resolve(), text)
    editor = Editor(design, random.Random(f"{options.seed} {scene}"))
    share = options.edits // options.gears + (index < options.edits % options.gears)
    if editor.first:
        editor.edit(share)
    design.end()
    growth = getattr(editor, "growth", None)
    return [scene, share, editor.runs, editor.parts, editor.jumps, "" if growth is None else f"{100 * (growth - 1):+.1f} %", *editor.counts.values()], editor.said


def snap_truss(options):
    """The row of the truss: its load goes up and down beyond that of the fold."""
    design, chance, counts, said = Design(str(Path(options.netloft).resolve()), options.library.resolve(), TRUSS), random.Random(options.seed), dict.fromkeys(HARMS, 0), []
    height = lambda outcome: next(f["value"] for f in outcome["figures"] if f["name"] == "z")
    z, jumps, snaps = height(design.ask("solve")), 0, 0
    for _ in range(MOVES_OF_TRUSS):
        load = FOLD * chance.uniform(-1.4, 1.4)
        outcome = design.ask("apply", path="parts.load.force.z", to=round(load, 2), wait=True)["outcome"]
        has_snapped = height(outcome) * z < 0
        jumps, snaps, z = jumps + (outcome["jump"] is not None), snaps + has_snapped, height(outcome)
        if has_snapped and not outcome["jump"]:
            counts["silent jumps"] += 1
            said.append(f"the truss snapped under {load} N")
    design.end()
    if not snaps:
        counts["silent jumps"] += 1
        said.append("the truss never snapped")
    return ["truss that snaps", MOVES_OF_TRUSS, 0, 0, jumps, "", *counts.values()], said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft")
    parser.add_argument("library", type=Path)
    parser.add_argument("--edits", type=int, default=10000)
    parser.add_argument("--gears", type=int, default=len(SCENES), choices=range(1, len(SCENES) + 1))
    parser.add_argument("--nodes", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--table", type=Path)
    options = parser.parse_args()
    lines = ["| gear | edits | runs compared | parts changed | jumps said | memory grew | " + " | ".join(HARMS) + " |", "|---" * (6 + len(HARMS)) + "|"]
    print("\n".join(lines))
    harm = 0
    rows = [lambda scene=scene, index=index: edit_gear(options, scene, index) for index, scene in enumerate(SCENES[:options.gears])]
    for make in (*rows, lambda: snap_truss(options)):
        row, said = make()
        harm += sum(row[6:])
        lines.append("| " + " | ".join(map(str, row)) + " |")
        print(lines[-1], *said, sep="\n", flush=True)
        if options.table:
            options.table.write_text("\n".join(lines) + "\n")
    return 1 if harm else 0


if __name__ == "__main__":
    sys.exit(main())
