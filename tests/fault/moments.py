# SPDX-License-Identifier: BSD-3-Clause
"""Interrupts a run of a large scene at random moments: it must end within a second of processor time, and lose nothing."""
import importlib.util
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from answer import seconds_of

INTERRUPTED = 130
MOST = 1.0  # [s] of processor time from the signal to the end
PHASES = ("reading", "solving", "writing")
HEADS = ("run of", "under way", "tries", "ended 130", "had ended", "longest [s]", "later than 1 s", "another end", "harmed")
EARLIER = b"an earlier result"


def bench(source):
    spec = importlib.util.spec_from_file_location("reading", source / "tests/bench/reading.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def has_ended(process):
    return os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None


class Moments:
    """One scene, run repeatedly. `kind`: one of tests/bench/reading.py."""

    def __init__(self, netloft, source, kind, number, folder):
        self.netloft, self.name, self.folder = netloft, f"{number} {kind}", folder
        reading = bench(source)
        reading.write(folder, reading.KINDS[kind](number))
        self.rows = {phase: dict.fromkeys(HEADS[2:], 0) for phase in PHASES}
        process = self.begin()
        self.seconds, self.status = self.wait(process)
        if self.status != 0:
            raise ValueError(f"a run of {self.name} ends with {self.status}")
        self.size = (folder / "o.hdf").stat().st_size

    def begin(self):
        for path in self.folder.glob("o*"):
            path.unlink()
        (self.folder / "o.hdf").write_bytes(EARLIER)
        self.said = tempfile.TemporaryFile()
        return subprocess.Popen([self.netloft, "run", "--threads", "1", "scene.toml", "-o", "o.hdf"], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=self.said, stderr=subprocess.STDOUT,
                                env={**os.environ, "OMP_THREAD_LIMIT": "1"})

    @staticmethod
    def wait(process):
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return usage.ru_utime + usage.ru_stime, process.returncode

    def phase(self):
        """The present stage of the run, as shown by its files and messages."""
        part = self.folder / "o.hdf.part"
        if not part.exists():
            return "reading"
        return "writing" if part.stat().st_size > 65536 else "solving"

    def interrupt(self, moment, number):
        process = self.begin()
        while not has_ended(process) and seconds_of(process.pid) < moment:
            time.sleep(0.002)
        if has_ended(process):
            self.wait(process)
            return False
        phase, before = self.phase(), seconds_of(process.pid)
        process.send_signal(number)
        total, code = self.wait(process)
        self.judge(self.rows[phase], phase, total - before, code, number)
        return True

    def judge(self, row, phase, took, code, number):
        self.said.seek(0)
        said = self.said.read().decode("utf-8", "replace")
        self.said.close()
        row["tries"] += 1
        row["longest [s]"] = max(row["longest [s]"], took)
        is_odd = code not in (0, INTERRUPTED, -number) or (code == INTERRUPTED and "interrupted" not in said)
        faults = {"later than 1 s": took > MOST, "another end": is_odd,
                  "harmed": self.harm()}
        row["ended 130"] += code == INTERRUPTED
        row["had ended"] += code == 0
        for fault, there in faults.items():
            row[fault] += bool(there)
        if any(faults.values()):
            print(f"{self.name}, {phase}: {took:.2f} s after signal {number}, exit {code}, {faults['harmed']}: {said[-200:]!r}",
                  file=sys.stderr, flush=True)

    def harm(self):
        """Checks that earlier files exist under their names or as backups, and that a new result is complete."""
        result, backup = self.folder / "o.hdf", self.folder / "o.hdf~"
        if not result.exists():
            return "no o.hdf"
        if result.read_bytes() == EARLIER:
            return ""
        if not backup.exists() or backup.read_bytes() != EARLIER:
            return "the earlier result is lost"
        return "" if is_sealed(result) else "o.hdf is not whole"


def is_sealed(result):
    with open(result, "rb") as f:
        f.seek(-33, os.SEEK_END)
        return f.read().startswith(b"sealed ")


def cells(row):
    return [f"{value:.2f}" if isinstance(value, float) else str(value) for value in row.values()]


def try_moments(number, seed, netloft, source, folder, kinds=(("floats", 30000), ("ropes", 30000))):
    """A table, the number of tries, and the number of wrong ends."""
    rng = random.Random(seed)
    lines = ["| " + " | ".join(HEADS) + " |", "|---" * len(HEADS) + "|"]
    tries = wrong = 0
    for kind, size in kinds:
        place = Path(folder) / kind
        place.mkdir()
        moments = Moments(netloft, source, kind, size, place)
        done = 0
        while done < number / len(kinds):
            done += moments.interrupt(rng.uniform(0, moments.seconds), signal.SIGINT if done % 2 else signal.SIGTERM)
        for phase, row in moments.rows.items():
            lines.append("| " + " | ".join([moments.name, phase, *cells(row)]) + " |")
            tries += row["tries"]
            wrong += sum(row[fault] for fault in HEADS[6:])
    return "\n".join(lines), tries, wrong
