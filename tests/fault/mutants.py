# SPDX-License-Identifier: BSD-3-Clause
"""Good inputs with a few random changes: every command that reads them must give an answer."""
import json
import random
import re
import shutil
import sys
from pathlib import Path

from answer import CODES, WRONGS, Answer

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import files_of_others as others

NUMBER = re.compile(rb"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ODD_NUMBERS = (b"0", b"-1", b"1e308", b"-1e308", b"5e-324", b"nan", b"inf", b"99999999999999999999", b"2147483648", b"1e6",
               b"0x7fffffff", b"1_0", b"1.")
CONTROLS = [bytes([c]) for c in (*range(32), 127)] + [chr(c).encode() for c in range(0x80, 0xA0)] + [bytes([c]) for c in range(0x80, 0xA0)]


def flip(rng, data):
    at = rng.randrange(8 * len(data))
    return data[:at // 8] + bytes([data[at // 8] ^ 1 << at % 8]) + data[at // 8 + 1:]


def cut(rng, data):
    return data[:rng.randrange(len(data))]


def leave_out(rng, data):
    begin = rng.randrange(len(data))
    return data[:begin] + data[begin + rng.randrange(1, 200):]


def with_lines(change):
    def changed(rng, data):
        lines = data.split(b"\n")
        change(rng, lines)
        return b"\n".join(lines)
    return changed


@with_lines
def swap(rng, lines):
    i, k = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[i], lines[k] = lines[k], lines[i]


@with_lines
def repeat(rng, lines):
    lines.insert(rng.randrange(len(lines)), lines[rng.randrange(len(lines))])


def renumber(rng, data):
    """A number of another magnitude, or a text that is not a number."""
    numbers = list(NUMBER.finditer(data))
    if not numbers:
        return flip(rng, data)
    one = rng.choice(numbers)
    other = one.group() + b"e%d" % rng.randrange(-12, 13) if rng.random() < 0.5 and b"e" not in one.group() else rng.choice(ODD_NUMBERS)
    return data[:one.start()] + other + data[one.end():]


def insert(rng, data):
    at = rng.randrange(len(data))
    return data[:at] + rng.choice(CONTROLS) + data[at:]


def exchange(rng, data):
    """One word for another."""
    words = list(re.finditer(rb"[A-Za-z_][\w-]*", data))
    if not words:
        return flip(rng, data)
    one, other = rng.choice(words), rng.choice(words)
    return data[:one.start()] + other.group() + data[one.end():]


TEXT = (flip, cut, leave_out, swap, repeat, renumber, renumber, renumber, insert, insert, exchange)
BINARY = (flip, flip, flip, cut, leave_out)


def mutant(rng, data, changes):
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        data = rng.choice(changes)(rng, data) or b" "
    return data


def unsealed(content):
    """A result without its checksums, so that HDF5 reads the changed bytes."""
    return content[:content.rindex(b"netloft checksums 1\n")]


STUDY = """\
scene = "scene.toml"
set = ["parts.rope.cells=4"]
[variables.density]
key = "parts.rope.rope.density"
range = [300, 360]
[design]
samples = 4
"""


class Kind:
    """Files of one kind: their good contents by name, changes, and commands that read NAME."""

    def __init__(self, name, goods, changes, commands, seal=bytes):
        self.name, self.goods, self.changes, self.commands, self.seal = name, goods, changes, commands, seal

    def keep_what_is_good(self, netloft, folder):
        """Keeps only inputs that are accepted unchanged, because changes of refused ones would show nothing."""
        self.goods = [good for good in self.goods if self.is_good(*good, netloft, folder)]
        if not self.goods:
            raise ValueError(f"there is no good {self.name}")

    def is_good(self, name, content, netloft, folder):
        (folder / name).write_bytes(content)
        answers = [Answer(netloft, [word.replace("NAME", name) for word in command], folder) for command in self.commands]
        return all(answer.code in (0, 3) and not answer.wrongs(name) for answer in answers)

    def try_one(self, number, rng, netloft, folder):
        """The answer, and what was wrong with it."""
        name, good = self.goods[number % len(self.goods)]
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        content = mutant(rng, good, self.changes)
        content = self.seal(content) if rng.random() < 0.7 else content
        place.write_bytes(content)
        words = [word.replace("NAME", name) for word in self.commands[number // len(self.goods) % len(self.commands)]]
        answer = Answer(netloft, words, folder)
        place.write_bytes(good)  # others may be read beside it
        return answer, name, content, answer.wrongs(*self.named(name))

    @staticmethod
    def named(name):
        return (name, Path(name).name, str(Path(name).parent)) if "/" in name else (name,)


def seal_record(content):
    """Corrects the checksums, as the author of a hostile file could."""
    return others.sealed_record(content.rsplit(b"crc32 ", 1)[0])


def seal_manifest(content):
    first, _, rest = content.partition(b"\n")
    try:
        return others.sealed_manifest(dict(json.loads(first)), rest)
    except (ValueError, TypeError):
        return content


def scene_goods(source):
    """Scenes in one file, without others that they include."""
    places = (*sorted((source / "tests/fuzz/seeds/scene").glob("*.toml")), *sorted((source / "tests/stability").glob("*.toml")),
              source / "gear-library/scenes/hanging-rope.toml", source / "gear-library/scenes/dynamics/released-rope.toml")
    return [("m.toml", text) for text in map(Path.read_bytes, places) if b"include" not in text]


def make_kinds(source, program, folder):
    """Makes the good files in a folder. `program`: as of campaign.py."""
    seeds, library = source / "tests/fuzz/seeds", source / "gear-library"
    shutil.copy(library / "scenes/hanging-rope.toml", folder / "scene.toml")
    program.succeed(["run", "scene.toml", "-o", "good.hdf", "--set", "parts.rope.cells=10"], folder)
    program.succeed(["run", str(library / "scenes/dynamics/released-rope.toml"), "--set", "analysis.output_interval=0.5", "-o", "motion.hdf"], folder)
    (folder / "s.toml").write_text(STUDY)
    program.succeed(["study", "plan", "s.toml"], folder)
    program.succeed(["study", "run", "s.study"], folder)
    shutil.copytree(library / "catalogue", folder / "parts")
    (folder / "with-parts.toml").write_text('catalogue = ["parts"]\n' + (library / "gears/four-panel.toml").read_text())
    goods = {name: (folder / name).read_bytes() for name in ("good.hdf", "motion.hdf", "s.toml", "s.study/manifest.jsonl")}
    record = sorted((folder / "s.study/items").glob("*.json"))[0]
    gears = [("g.toml", path.read_bytes()) for path in (*sorted((library / "gears").glob("*.toml")), seeds / "plan/everything.toml")]
    results = [("m.hdf", change(goods[name])) for name in ("good.hdf", "motion.hdf") for change in (bytes, unsealed)]
    femnet = source / "tests/validation/femnet_files"
    shown = (["report", "NAME"], ["report", "NAME", "--json"], ["view", "NAME", "-o", "o.html"], ["draw", "NAME", "-o", "o.svg"],
             ["export", "NAME", "o.csv"], ["export", "NAME", "o.glb"], ["diff", "good.hdf", "NAME"],
             ["run", "scene.toml", "--start-from", "NAME", "-o", "o.hdf"])
    on_study = [["study", action, "s.study", *more] for action, more in (
        ("missing", ()), ("collect", ()), ("show", ()),
        ("submit", ("--engine", "slurm")), ("run", ("--jobs", "1")))]
    return [
        Kind("scene", scene_goods(source), TEXT, (["plan", "NAME"], ["plan", "NAME", "--json"],
                                                  ["run", "NAME", "-o", "o.hdf", "--overwrite", "--set", "analysis.max_seconds=2"])),
        Kind("catalogue", [("parts/" + path.name, path.read_bytes()) for path in sorted((library / "catalogue").glob("*.toml"))], TEXT,
             (["check", "with-parts.toml"], ["check", "with-parts.toml", "--json"])),
        Kind("net plan", gears, TEXT, (["check", "NAME"], ["check", "NAME", "--json"], ["draw", "NAME", "-o", "o.svg"])),
        Kind("study", [("s.toml", goods["s.toml"])], TEXT, (["study", "plan", "NAME", "-o", "o.study"],)),
        Kind("manifest", [("s.study/manifest.jsonl", goods["s.study/manifest.jsonl"])], TEXT, on_study, seal_manifest),
        Kind("record", [(str(record.relative_to(folder)), record.read_bytes())], TEXT, on_study, seal_record),
        Kind("gear of another program", [("m.csv", (seeds / "import/table").read_bytes())], TEXT, (["import", "table", "NAME", "-o", "o.toml"],)),
        Kind("mooring", [("m.txt", (seeds / f"import/{name}").read_bytes()) for name in ("mooring", "mooring-of-version-1")], TEXT,
             (["import", "moordyn", "NAME", "-o", "o.toml"],)),
        Kind("FEMNET", [("m.don", path.read_bytes()) for path in sorted(femnet.glob("*.don"))], TEXT, (["import", "femnet", "NAME", "-o", "o.toml"],)),
        Kind("result", results, BINARY, shown)]


class Count:
    """Results of the mutants of one kind: exit codes and faults."""

    def __init__(self):
        self.codes, self.short_of_memory, self.with_a_line, self.wrongs = dict.fromkeys(CODES, 0), 0, 0, dict.fromkeys(WRONGS, 0)

    def add(self, answer, name, wrongs):
        if answer.code in self.codes:
            self.codes[answer.code] += 1
        self.short_of_memory += answer.is_short_of_memory()
        self.with_a_line += answer.code == 2 and answer.has_a_line(name)
        for wrong in wrongs:
            self.wrongs[wrong] += 1

    def cells(self):
        codes = list(self.codes.values())
        return (sum(codes) + self.wrongs["signal"] + self.wrongs["hang"], *codes, self.with_a_line, self.short_of_memory, *self.wrongs.values())


HEADS = ("mutants of a", "tries", *(f"exit {code}" for code in CODES), "2 with a line", "1 for want of memory", *WRONGS)


def table_of(counts):
    sums = [sum(column) for column in zip(*(count.cells() for count in counts.values()))]
    rows = [HEADS, ["---"] * len(HEADS), *((name, *count.cells()) for name, count in counts.items()), ("all", *sums)]
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in rows)


def try_mutants(number, seed, netloft, source, program, folder, kept):
    """A table and the number of wrong answers; these inputs are kept in the folder `kept`."""
    kinds, wrong = make_kinds(source, program, folder), 0
    for kind in kinds:
        kind.keep_what_is_good(netloft, folder)
    counts = {kind.name: Count() for kind in kinds}
    for i in range(number):
        kind = kinds[i % len(kinds)]
        answer, name, content, wrongs = kind.try_one(i // len(kinds), random.Random(f"{seed} {i}"), netloft, folder)
        counts[kind.name].add(answer, kind.named(name), wrongs)
        if wrongs:
            wrong += 1
            kept.mkdir(parents=True, exist_ok=True)
            (kept / f"{i}-{Path(name).name}").write_bytes(content)
            print(f"mutant {i}, {kind.name}: {', '.join(wrongs)}: netloft {' '.join(answer.words)}: exit {answer.code}, "
                  f"{answer.seconds:.1f} s, {answer.peak >> 20} MiB: {answer.err[-300:]!r}", file=sys.stderr, flush=True)
    return table_of(counts), wrong
