#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that no result is lost and that files of other people do no harm; counts losses and harm.

    campaign.py NETLOFT SOURCE_FOLDER FULL_DISK.so [--kills 60] [--minutes M] [--writes 12] [--mutants 100] [--moments 10] [--others]
                [--seed 1] [--only WORD] [--table FILE]

First come kills, full disks and other faults at every command that writes or reads results, then changed inputs (mutants.py), hostile
files (others.py), and interruptions of runs of large scenes (moments.py). It prints a Markdown table of each and exits with 1 unless
all counts of harm are 0. FILE holds the tables of what has been tried so far, so that a campaign which is itself killed is not lost.
The counts of the first table are of
    lost            what was there before the fault, or was confirmed, is not there, or not all of it
    unreadable      a file that counts cannot be read, or the command does not succeed once the fault is over
    silently wrong  a number differs from that of a run without faults, and nothing says so
    without a word  the command failed and gave no reason
"""
import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import moments
import mutants
import others
from journal import Damaged, Journal

HARMS = ("lost", "unreadable", "silently wrong", "without a word")
NOBODY = 65534
OF_THE_RUN = ("netloft/solve/seconds", "netloft/motion/resumed_from")  # numbers that a resumed or slower run has of its own
INTERRUPTED = 130
SIGNALS = {"killed": signal.SIGKILL, "terminated": signal.SIGTERM, "interrupted": signal.SIGINT}
TRIES_PER_TABLE = 50  # kept after so many: a minute or so


class Harm(Exception):
    """The kind of harm, one of HARMS, and a description."""


def numbers_of(file):
    """Every number of a result except those about time, machine and interruptions."""
    found = {}
    with h5py.File(file) as f:
        def add(name, item):
            is_result = name.startswith("VTKHDF") or name.split("/")[1:2] not in (["cost"], ["provenance"], ["convergence"])
            is_result &= name not in OF_THE_RUN
            if isinstance(item, h5py.Dataset) and item.dtype.kind in "fiu" and is_result:
                found[name] = item[()].tobytes()
        f.visititems(add)
    return found


class Program:
    def __init__(self, words):
        self.netloft, self.library = words.netloft, words.library

    def environment(self, faults):
        preload = {"LD_PRELOAD": self.library} if faults else {}
        return {**os.environ, "OMP_THREAD_LIMIT": "1", **preload, **{f"NETLOFT_{k}": str(v) for k, v in faults.items()}}

    def begin(self, words, folder, **how):
        return subprocess.Popen([self.netloft, *words], cwd=folder, stdin=subprocess.DEVNULL, env=self.environment({}), **how)

    def run(self, words, folder, faults=None, **how):
        return subprocess.run([self.netloft, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=3600, check=False, env=self.environment(faults or {}), **how)

    def succeed(self, words, folder):
        ended = self.run(words, folder)
        if ended.returncode not in (0, 3):
            raise Harm("unreadable", f"{' '.join(words)}: {ended.stderr.strip()}")
        return ended


class Case:
    """A command in a folder; subclasses define the files before it and those that must exist after a fault."""

    writes = True

    def __init__(self, name, words, program):
        self.name, self.words, self.program = name, words, program

    def prepare(self, folder):
        """Fills the folder, as it is before each try."""

    def observe(self, folder):
        """The data that are confirmed just before a kill."""

    def judge(self, folder, confirmed, ran_twice=False):
        """Raises Harm unless all is well after a fault."""

    def learn(self, folder):
        """Checks the files after a run without faults; returns its duration."""
        self.prepare(folder)
        self.program.succeed(self.words, folder)
        begun = time.monotonic()
        self.program.succeed(self.words, folder)
        return time.monotonic() - begun


class Result(Case):
    """`run` of an equilibrium, whose result file already exists, from another run."""

    def __init__(self, name, words, earlier, program):
        super().__init__(name, words, program)
        self.earlier = earlier

    def learn(self, folder):
        self.program.succeed(self.earlier, folder)
        self.old = (folder / "p.hdf").read_bytes()
        self.old_numbers = numbers_of(folder / "p.hdf")
        seconds = super().learn(folder)
        self.new_numbers = numbers_of(folder / "p.hdf")
        assert self.old_numbers != self.new_numbers
        return seconds

    def prepare(self, folder):
        (folder / "p.hdf").write_bytes(self.old)

    def judge(self, folder, confirmed, ran_twice=False):
        if not (folder / "p.hdf").exists():
            raise Harm("lost", "p.hdf is gone")
        self.program.succeed(["report", "p.hdf"], folder)
        numbers = numbers_of(folder / "p.hdf")
        if numbers not in (self.old_numbers, self.new_numbers):
            raise Harm("silently wrong", "p.hdf holds neither result")
        if numbers == self.new_numbers and not ran_twice and (folder / "p.hdf~").read_bytes() != self.old:
            raise Harm("lost", "the earlier result is not p.hdf~")
        self.program.succeed(self.words, folder)
        if numbers_of(folder / "p.hdf") != self.new_numbers:
            raise Harm("silently wrong", "p.hdf after the next run")


class Motion(Case):
    """`run` of a motion, or `run --resume` of one that was killed at `from_outputs`."""

    def __init__(self, name, words, from_outputs, program):
        super().__init__(name, words, program)
        self.from_outputs, self.there = from_outputs, 0

    def learn(self, folder):
        begun = time.monotonic()
        self.program.succeed(self.words, folder)
        seconds = time.monotonic() - begun
        self.whole = numbers_of(folder / "r.hdf")
        self.journal = None
        (folder / "r.hdf.new").mkdir()  # with this in its way a motion stays a journal
        self.program.run([*self.words, "--overwrite"], folder)
        (folder / "r.hdf.new").rmdir()
        self.series = Journal(folder / "r.hdf.part").series()
        if self.from_outputs:
            self.journal, self.there = self.cut(folder / "r.hdf.part")
            self.words = [*self.words, "--resume"]
        return seconds

    def cut(self, part):
        """A kill in the middle of an output: after the last whole output, the file has a part of the next one."""
        whole = part.read_bytes()
        content = whole[:int(len(whole) * self.from_outputs / len(self.series["time"]))]
        part.write_bytes(content)
        return content, len(Journal(part).outputs)

    def prepare(self, folder):
        if self.journal:
            (folder / "r.hdf.part").write_bytes(self.journal)

    def observe(self, folder):
        try:
            return len(Journal(folder / "r.hdf.part").outputs)
        except (OSError, Damaged):
            return 0

    def judge(self, folder, confirmed, ran_twice=False):
        least = max(confirmed or 0, self.there)
        part, whole = folder / "r.hdf.part", folder / "r.hdf"
        if whole.exists():
            self.program.succeed(["report", "r.hdf"], folder)
            if numbers_of(whole) != self.whole:
                raise Harm("silently wrong", "r.hdf")
        elif not part.exists() or part.stat().st_size == 0:
            if least > 0:
                raise Harm("lost", f"{least} outputs")
        else:
            self.judge_journal(folder, part, least)
        self.finish(folder, part)

    def judge_journal(self, folder, part, least):
        try:
            held = Journal(part).series()
        except Damaged as damage:
            raise Harm("unreadable", f"r.hdf.part: {damage}") from damage
        count = len(held["time"]) if held else 0
        if count < least:
            raise Harm("lost", f"{count} outputs of {least}")
        for name, values in held.items():
            if values.tobytes() != self.series[name][:count].tobytes():
                raise Harm("silently wrong", f"{name} in r.hdf.part")
        if count:
            self.program.succeed(["report", "r.hdf.part"], folder)

    def finish(self, folder, part):
        words = [word for word in self.words if word != "--resume"]
        is_left = self.observe(folder) > 0
        self.program.succeed([*words, *(["--resume"] if is_left else [])] if is_left or not (folder / "r.hdf").exists()
                             else ["report", "r.hdf"], folder)
        if numbers_of(folder / "r.hdf") != self.whole or (is_left and part.exists()):
            raise Harm("silently wrong", "r.hdf after --resume")


def fill(folder, files):
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


class Items(Case):
    """`study run`, in a folder in which some items have been computed; tables show the data of the records."""

    TABLES = ("table.csv", "table.hdf")

    def __init__(self, name, words, sources, program):
        super().__init__(name, words, program)
        self.sources = sources

    def prepare(self, folder):
        fill(folder, self.sources)

    def observe(self, folder):
        return {path.name: path.read_bytes() for path in (folder / "s.study" / "items").glob("*.json")}

    def learn(self, folder):
        seconds = super().learn(folder)
        self.new = self.finish(folder)
        return seconds

    def finish(self, folder):
        self.program.succeed(["study", "run", "s.study"], folder)
        self.program.succeed(["study", "collect", "s.study"], folder)
        return [(folder / "s.study" / name).read_bytes() for name in self.TABLES]

    def judge(self, folder, confirmed, ran_twice=False):
        there = {Path(name).name: content for name, content in self.sources.items() if name.endswith(".json")}
        for name, content in {**there, **(confirmed or {})}.items():
            if (folder / "s.study" / "items" / name).read_bytes() != content:
                raise Harm("lost", f"record {name}")
        if self.finish(folder) != self.new:
            raise Harm("silently wrong", "table of the study")


class Page(Case):
    """A command that reads some files and writes others, or none."""

    def __init__(self, name, words, outputs, sources, program, is_whole=None):
        super().__init__(name, words, program)
        self.outputs, self.sources, self.is_whole, self.writes = outputs, sources, is_whole, bool(outputs)

    def prepare(self, folder):
        fill(folder, {**self.sources, **{output: b"old" for output in self.outputs}})

    def learn(self, folder):
        seconds = super().learn(folder)
        self.new = {output: (folder / output).read_bytes() for output in self.outputs}
        return seconds

    def judge(self, folder, confirmed, ran_twice=False):
        for name, content in self.sources.items():
            if (folder / name).read_bytes() != content:
                raise Harm("lost", f"{name} was changed")
        for output, new in self.new.items():
            if not (folder / output).exists():
                raise Harm("lost", output)
            content = (folder / output).read_bytes()
            if content not in (b"old", new) and not (self.is_whole and self.is_whole(content, new)):
                raise Harm("silently wrong", f"{output} is neither the old nor the new one")


def is_whole_table(content, like):
    """Times differ from run to run; lines and columns do not."""
    shape = [line.count(b",") for line in content.split(b"\n")]
    return shape == [line.count(b",") for line in like.split(b"\n")]


class Tally:
    def __init__(self, file=None):
        self.by_name, self.file, self.other_tables, self.other_wrongs = {}, file, [], 0

    @property
    def rows(self):
        return list(self.by_name.values())

    def count(self, fault, case, tries):
        """`tries` yields functions, each of which does one try and raises Harm if it was harmed."""
        row = self.by_name.setdefault((fault, case), {"fault": fault, "case": case, "tries": 0, **{harm: 0 for harm in HARMS}})
        for attempt in tries:
            row["tries"] += 1
            try:
                attempt()
            except Harm as harm:
                self.add(row, *harm.args)
            except (OSError, subprocess.SubprocessError) as error:  # a file that must be there is not, or no end
                self.add(row, "lost", error)
            if self.file and sum(row["tries"] for row in self.rows) % TRIES_PER_TABLE == 0:
                self.keep()

    @staticmethod
    def add(row, harm, what):
        row[harm] += 1
        print(f"{row['fault']}, {row['case']}, try {row['tries']}: {harm}: {what}", file=sys.stderr, flush=True)

    def add_table(self, table, wrongs):
        self.other_tables.append(table)
        self.other_wrongs += wrongs
        if self.file:
            self.keep()

    def keep(self):
        beside = self.file.with_name(self.file.name + ".new")
        beside.write_text(self.tables() + "\n")
        beside.replace(self.file)

    def tables(self):
        return "\n\n".join([self.table(), *self.other_tables])

    def table(self):
        lines = ["| fault | command | tries | " + " | ".join(HARMS) + " |", "|---" * (3 + len(HARMS)) + "|"]
        total = {"fault": "all", "case": "", **{key: sum(row[key] for row in self.rows) for key in ("tries", *HARMS)}}
        for row in (*self.rows, total):
            lines.append("| " + " | ".join(str(value) for value in row.values()) + " |")
        return "\n".join(lines)

    def is_clean(self):
        return not self.other_wrongs and not any(row[harm] for row in self.rows for harm in HARMS)


def in_fresh_folder(action):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:  # a worker may outlive a kill by a moment
        return action(Path(folder))


def has_ended(run, seconds):
    try:
        run.wait(timeout=seconds)
        return True
    except subprocess.TimeoutExpired:
        return False


class Kill:
    """Signals at random instants of a command. Its duration depends on the load of the machine, which may stop it for minutes: each run that ends before its kill sets the estimated duration and is repeated, and each successful kill increases it, so that the end of the command stays within reach."""

    LONGER = 1.05

    def __init__(self, case, seconds, rng, number=signal.SIGKILL):
        self.case, self.seconds, self.rng, self.number = case, seconds, rng, number

    def __call__(self):
        while not in_fresh_folder(self.has_hit):
            pass

    def has_hit(self, folder):
        self.case.prepare(folder)
        begun = time.monotonic()
        with tempfile.TemporaryFile() as said:
            run = self.case.program.begin(self.case.words, folder, stdout=said, stderr=said)
            if has_ended(run, self.rng.uniform(0, self.seconds)):
                self.seconds = time.monotonic() - begun
                return False
            confirmed = self.case.observe(folder)
            run.send_signal(self.number)
            code = run.wait(timeout=3600)
            said.seek(0)
            words = said.read().decode("utf-8", "replace")
        # A signal that arrives before the program handles signals ends the program; a signal after the end of
        # the work has no effect.
        if code != -self.number and (code != INTERRUPTED or self.number == signal.SIGKILL):
            if code not in (0, 3):
                raise Harm("without a word", f"exit {code} after signal {self.number}: {words.strip()}")
            return False
        if code == INTERRUPTED and "interrupted" not in words:
            raise Harm("without a word", f"interrupted: {words.strip()}")
        self.seconds *= self.LONGER
        self.case.judge(folder, confirmed)
        return True


def deed_tries(case, most, rng):
    """Kills before each write, sync, truncation and change of a name."""
    deeds = in_fresh_folder(lambda folder: counts_of(case, folder)[1])

    def attempt(folder, at):
        case.prepare(folder)
        case.program.run(case.words, folder, {"SIGNAL_AT": at})
        case.judge(folder, None)
    for at in sample(deeds, most, rng):
        yield lambda at=at: in_fresh_folder(lambda folder: attempt(folder, at))


def counts_of(case, folder):
    """Numbers of writes and of all counted system calls. In a pool of workers, those of the last worker count, which may write nothing."""
    case.prepare(folder)
    count = folder / "count"
    case.program.run(case.words, folder, {"FAIL_WRITE": 0, "COUNT_FILE": count})
    return [max(1, int(word)) for word in count.read_text().split()]


def sample(count, most, rng):
    return range(1, count + 1) if count <= most else sorted(rng.sample(range(1, count + 1), most))


def full_disk_tries(case, most, rng):
    writes = in_fresh_folder(lambda folder: counts_of(case, folder)[0])

    def attempt(folder, number):
        case.prepare(folder)
        ended = case.program.run(case.words, folder, {"FAIL_WRITE": number})
        if ended.returncode == 0:
            raise Harm("silently wrong", f"write {number} of {writes} failed, but the command reports success")
        if "No space left on device" not in ended.stderr:
            raise Harm("without a word", f"write {number} of {writes}: {ended.stderr.strip()}")
        case.judge(folder, None)
    for number in sample(writes, most, rng):
        yield lambda number=number: in_fresh_folder(lambda folder: attempt(folder, number))


def oddity_tries(case, faults):
    """Faults in spite of which the program must succeed."""
    def attempt(folder):
        case.prepare(folder)
        ended = case.program.run(case.words, folder, faults)
        if ended.returncode not in (0, 3):
            raise Harm("unreadable", ended.stderr.strip())
        case.judge(folder, None)
    yield lambda: in_fresh_folder(attempt)


def protect(folder, mode_of_folders, mode_of_files):
    for path in (folder, *folder.rglob("*")):
        path.chmod(mode_of_folders if path.is_dir() else mode_of_files)


def read_only_tries(case):
    """A folder in which no file can be created."""
    def attempt(folder):
        case.prepare(folder)
        protect(folder, 0o555, 0o444)
        ended = case.program.run(case.words, folder, **({"user": NOBODY, "group": NOBODY} if os.geteuid() == 0 else {}))
        protect(folder, 0o755, 0o644)
        if case.writes and (ended.returncode == 0 or "Permission denied" not in ended.stderr):
            raise Harm("without a word", f"exit {ended.returncode}: {ended.stderr.strip()}")
        if not case.writes and ended.returncode not in (0, 3):
            raise Harm("unreadable", ended.stderr.strip())
        case.judge(folder, None)
    yield lambda: in_fresh_folder(attempt)


def two_writer_tries(case, seconds, number, rng):
    def attempt(folder):
        case.prepare(folder)
        ended = [None, None]

        def write(which, delay):
            time.sleep(delay)
            ended[which] = case.program.run(case.words, folder)
        writers = [threading.Thread(target=write, args=(i, rng.uniform(0, seconds / 2))) for i in range(2)]
        for writer in writers:
            writer.start()
        for writer in writers:
            writer.join()
        if all(e.returncode != 0 for e in ended):
            raise Harm("lost", "neither came to its end: " + " | ".join(e.stderr.strip() for e in ended))
        if any(e.returncode != 0 and not e.stderr.strip() for e in ended):
            raise Harm("without a word", "one of two writers")
        case.judge(folder, None, ran_twice=all(e.returncode == 0 for e in ended))
    for _ in range(number):
        yield lambda: in_fresh_folder(attempt)


STUDY = """\
scene = "scene.toml"
path = []
[variables.density]
key = "parts.rope.rope.density"
values = [300, 330, 360, 390]
"""


def make_study(folder, program, scene):
    """The files of a study whose items are all computed."""
    (folder / "scene.toml").write_text(scene.read_text().replace("cells = 200", "cells = 10"))
    (folder / "s.toml").write_text(STUDY)
    program.succeed(["study", "plan", "s.toml"], folder)
    program.succeed(["study", "run", "s.study"], folder)
    files = (folder / "scene.toml", folder / "s.toml", *sorted((folder / "s.study").rglob("*.json*")))
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def missing_item(study):
    for item in map(json.loads, study["s.study/manifest.jsonl"].splitlines()[1:]):
        if f"s.study/items/{item['hash'].split(':')[1]}.json" not in study:
            return str(item["id"])
    raise ValueError("no item is missing")


def make_cases(words, program, folder):
    scenes = Path(words.source) / "gear-library" / "scenes"
    panel = [str(scenes / "dead-weight-panel.toml"), "--set", "parts.net.cells=[2,2]"]
    rope = ["run", str(scenes / "dynamics" / "released-rope.toml"), "--set", "analysis.output_interval=0.01", "-o", "r.hdf"]
    program.succeed(["run", *panel, "-o", "p.hdf"], folder)
    source = {"p.hdf": (folder / "p.hdf").read_bytes()}
    study = make_study(folder, program, scenes / "hanging-rope.toml")
    plan = {name: content for name, content in study.items() if name.endswith(".toml")}
    begun = {name: content for i, (name, content) in enumerate(study.items()) if not name.endswith(".json") or i % 2}
    bars = {"bars.csv": (Path(words.source) / "tests" / "fuzz" / "seeds" / "import" / "table").read_bytes()}
    solve = ["compare", *panel, "--solver", "newton", "--tolerance", "1e-3:1e-2", "--repeats", "1", "-o", "out.csv"]
    return [Result("run, equilibrium", ["run", *panel, "-o", "p.hdf"], ["run", *panel, "-o", "p.hdf", "--set", "water.gravity=5"], program),
            Motion("run, motion", rope, 0, program),
            Motion("run --resume", rope, 200, program),
            Page("report", ["report", "p.hdf"], (), source, program),
            Page("report -o", ["report", "p.hdf", "-o", "out.html"], ("out.html",), source, program),
            Page("diff", ["diff", "p.hdf", "p.hdf"], (), source, program),
            Page("view", ["view", "p.hdf", "-o", "out.html"], ("out.html",), source, program),
            Page("draw", ["draw", "p.hdf", "-o", "out.svg"], ("out.svg",), source, program),
            Page("export", ["export", "p.hdf", "out.glb"], ("out.glb",), source, program),
            Page("import", ["import", "table", "bars.csv", "-o", "bars.toml"], ("bars.toml", "bars.mesh"), bars, program),
            Page("compare -o", solve, ("out.csv",), {}, program, is_whole_table),
            Page("study plan", ["study", "plan", "s.toml"], ("s.study/manifest.jsonl",), plan, program),
            Items("study run", ["study", "run", "s.study", "--jobs", "1"], begun, program),
            Items("study run --items", ["study", "run", "s.study", "--items", missing_item(begun)], begun, program),
            Page("study collect", ["study", "collect", "s.study"], ("s.study/table.hdf",), study, program),
            Page("study show", ["study", "show", "s.study", "-o", "out.html"], ("out.html",), study, program)]


def try_faults(words, case, seconds, tally, rng):
    if case.writes:
        tally.count("disk full from the k-th write on", case.name, full_disk_tries(case, words.writes, rng))
    tally.count("killed before the k-th deed", case.name, deed_tries(case, words.writes, rng))
    tally.count("short reads and writes", case.name, oddity_tries(case, {"SHORT_READS": 1, "SHORT_WRITES": 1}))
    tally.count("clock goes back", case.name, oddity_tries(case, {"CLOCK_BACK": 3600}))
    tally.count("folder is read-only", case.name, read_only_tries(case))
    if isinstance(case, (Result, Motion)):
        tally.count("two writers", case.name, two_writer_tries(case, seconds, max(1, words.kills // 100), rng))


def kill_all(words, cases, seconds, tally, rng):
    """Takes turns, so that each command has had as many kills if the campaign ends early."""
    end = time.monotonic() + 60 * words.minutes
    kills = [(fault, Kill(case, seconds[case.name], rng, number)) for fault, number in SIGNALS.items() for case in cases]
    for number in range(words.kills):
        if time.monotonic() > end:
            return
        fault, kill = kills[number % len(kills)]
        tally.count(fault, kill.case.name, (kill,))


def try_all(words, cases, tally):
    rng = random.Random(words.seed)
    seconds = {case.name: in_fresh_folder(case.learn) for case in cases}
    for case in cases:
        for fault in SIGNALS:
            tally.count(fault, case.name, ())
        try_faults(words, case, seconds[case.name], tally, rng)
    kill_all(words, cases, seconds, tally, rng)


def try_files_of_others(words, program, tally):
    netloft, source = words.netloft, Path(words.source)
    left = words.table.with_name(words.table.stem + "-mutants") if words.table else Path("mutants")
    if words.mutants:
        table, wrong = in_fresh_folder(lambda folder: mutants.try_mutants(words.mutants, words.seed, netloft, source, program, folder, left))
        tally.add_table(table, wrong)
    if words.others:
        table, tries, wrong = in_fresh_folder(lambda folder: others.ask_all(netloft, source, program, folder))
        tally.add_table(f"{table}\n\nHostile files: {tries} commands, {wrong} wrong answers.", wrong)
    if words.moments:
        table, _, wrong = in_fresh_folder(lambda folder: moments.try_moments(words.moments, words.seed, netloft, source, folder))
        tally.add_table(table, wrong)


def parse(arguments):
    p = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    p.add_argument("netloft", help="the program")
    p.add_argument("source", help="the source folder")
    p.add_argument("library", help="build/…/tests/support/full_disk.so")
    p.add_argument("--kills", type=int, default=60, help="kills in all")
    p.add_argument("--minutes", type=float, default=1e6, help="no more kills after these")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--writes", type=int, default=12, help="largest number of writes of a command that are made to fail, one after another")
    p.add_argument("--mutants", type=int, default=100, help="inputs with changes at random")
    p.add_argument("--moments", type=int, default=10, help="interruptions of runs of large scenes")
    p.add_argument("--others", action="store_true", help="every command on each hostile file")
    p.add_argument("--table", type=Path, help="a file that holds the tables of what has been tried so far")
    p.add_argument("--only", default="", help="only kills and faults of commands whose name contains this")
    words = p.parse_args(arguments)
    words.netloft, words.source, words.library = (os.path.abspath(path) for path in (words.netloft, words.source, words.library))
    return words


def main(arguments):
    words = parse(arguments)
    program, tally = Program(words), Tally(words.table)
    cases = in_fresh_folder(lambda folder: make_cases(words, program, folder))
    try:
        try_all(words, [case for case in cases if words.only in case.name], tally)
        try_files_of_others(words, program, tally)
    except KeyboardInterrupt:
        print("interrupted: the tables count all tries until then", file=sys.stderr)
    finally:
        print(tally.tables(), flush=True)
    return 0 if tally.is_clean() else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
