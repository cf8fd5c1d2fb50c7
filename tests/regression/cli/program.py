# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program as a user does: a command line in a new folder, with its exit code, two streams and the files that it writes.

NETLOFT_PROGRAM names the program, NETLOFT_SOURCE_DIR the source tree.
"""
import importlib.util
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["NETLOFT_PROGRAM"]
HARD_CASES = str(Path(PROGRAM).with_name("hard_cases"))
SOURCE = Path(os.environ["NETLOFT_SOURCE_DIR"])

# A panel of 4 x 4 meshes hangs from its fore edge and carries a rope along its aft edge. Tests of wrong
# scenes change this scene without moving the lines above the change, so that the expected line numbers can be
# counted here.
GOOD = """\
[water]
density = 1025
gravity = 9.81

[parts.net]
type = "priour/triangle"
panel = { across = 4, along = 4, bar = "0.6 m" }
cells = [4, 4]
sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]
twine = { diameter = "10 mm", EA = "10 kN", density = 2000 }

[parts.rope]
type = "rope/bar"
length = "3 m"
cells = 4
sketch = [[-2, 0, -4], [2, 0, -4]]
rope = { diameter = "20 mm", EA = "100 kN", EA_compression = 0, density = 1150 }

[[join]]
points = ["net.aft", "rope"]

[[hold]]
on = "net.fore"

[analysis]
solver = "newton"
tolerance = 1e-10

[results]
lowest_z = { of = "net", take = "min z" }
"""


# A line of 10 m that hangs from one end.
LINE = """\
[water]
density = 1025
gravity = 9.81
[parts.line]
type = "rope/bar"
length = "10 m"
cells = 4
sketch = [[0, 0, 0], [1, 0, -9]]
rope = { diameter = "20 mm", EA = "100 kN", density = 1150 }
[[hold]]
on = "line.start"
"""


def changed(text, *changes):
    """`text` with each (old, new) replaced; an old text that is missing is a mistake in the test."""
    for old, new in changes:
        assert text.count(old) >= 1, f"not in the scene: {old}"
        text = text.replace(old, new, 1)
    return text


def write_many_parts(folder, number):
    """Writes scene.toml with a chain of this number of ropes, like tests/bench/reading.py."""
    spec = importlib.util.spec_from_file_location("reading", SOURCE / "tests/bench/reading.py")
    bench = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(bench)
    bench.write(folder, bench.ropes(number))


class Finished:
    def __init__(self, process):
        self.code = process.returncode
        self.out = process.stdout.decode("utf-8", "replace")
        # On a busy machine, any command may take longer than a second, after which progress is printed.
        self.err = re.sub(r'(?m)^(progress |\{"event": "progress", ).*\n', "", process.stderr.decode("utf-8", "replace"))

    def json(self):
        """Standard output, which must be one JSON object and nothing else."""
        value = json.loads(self.out)
        assert isinstance(value, dict), "not an object"
        return value


class InFreshFolder(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def command(self, *words):
        """Runs netloft or, if the first word is hard_cases, that program in the same folder."""
        return [HARD_CASES, *words[1:]] if words[:1] == ("hard_cases",) else [PROGRAM, *words]

    def environment(self, **more):
        return {**{k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "NETLOFT_PLUGINS")}, **more}

    def netloft(self, *words, environment=None, **how):
        return Finished(subprocess.run(self.command(*words), cwd=self.folder, stdin=subprocess.DEVNULL,
                                       capture_output=True, timeout=120, env=environment or self.environment(), **how))

    def cut_journal(self, size, result, *words):
        """Cuts the journal of a motion as a kill may: it keeps whole outputs and `size` bytes of the next one."""
        in_the_way = self.folder / f"{result}.new"
        in_the_way.mkdir()  # its outputs stay a journal
        stuck = self.netloft("run", *words, "-o", result)
        assert stuck.code == 1, stuck.err
        in_the_way.rmdir()
        part = self.folder / f"{result}.part"
        assert part.stat().st_size > size, "it has fewer outputs"
        os.truncate(part, size)
        return part

    def files(self):
        return {str(p.relative_to(self.folder)): p.read_bytes() for p in self.folder.rglob("*") if p.is_file()}
