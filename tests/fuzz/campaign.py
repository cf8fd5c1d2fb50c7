#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets each fuzzer work for so many minutes of processor time, however busy the machine is, and counts.

    campaign.py BUILD_FOLDER [FUZZER…] [--minutes 10] [--table FILE]

prints a Markdown table with a row for each fuzzer and exits with 1 if there was a finding. FILE holds the table of what has been
done so far. Inputs that reach new code go to BUILD_FOLDER/corpus, findings to BUILD_FOLDER/corpus/FUZZER-crash-…; a fuzzer
that has found something is started again for the rest of its time.
"""
import argparse
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["gear-library/scenes", "gear-library/scenes/dynamics", "-dict=tests/fuzz/scene.dict"]
FUZZERS = {"plan": ["gear-library/gears", "-dict=tests/fuzz/plan.dict"], "scene": SCENES,
           "topology": [], "catalogue": ["gear-library/catalogue", "-dict=tests/fuzz/scene.dict"], "table": [], "result": [], "part": [],
           "study": ["-dict=tests/fuzz/scene.dict"], "import": ["tests/validation/femnet_files", "-dict=tests/fuzz/import.dict"]}
# libFuzzer measures wall time, which is longer on a busy machine, so the limit is one that only an endless
# loop reaches.
LIMITS = ["-max_len=8192", "-timeout=600", "-rss_limit_mb=2000", "-print_final_stats=1"]
LOOK = 2  # [s] between two looks at the processor time
FINDINGS = ("crash", "timeout", "oom", "leak")


def cpu_seconds(pid):
    """The processor-time clock of a process that has not been waited for; the clocks of processes are numbered like this (clock_getcpuclockid)."""
    return time.clock_gettime((~pid << 3) | 2)


class Fuzzer:
    def __init__(self, name, folder, seconds):
        self.name, self.folder, self.seconds = name, folder, seconds
        self.cpu, self.executions, self.findings = 0, 0, 0
        self.corpus = folder / "corpus" / name

    def begin(self, left):
        self.corpus.mkdir(parents=True, exist_ok=True)
        environment = {"NETLOFT_FUZZ_RESULTS": str(self.folder / "results"), **os.environ}
        seeds = [folder for folder in [f"tests/fuzz/seeds/{self.name}"] if (ROOT / folder).exists()]
        words = [self.folder / "bin" / f"{self.name}_fuzzer", self.corpus, *seeds, *FUZZERS[self.name],
                 *LIMITS, f"-artifact_prefix={self.corpus}-", f"-seed={1 + int(self.seconds - left)}"]
        with open(f"{self.corpus}.log", "ab") as log:
            return subprocess.Popen(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=log, env=environment)

    def run(self, report):
        """Runs until the time is used up, and calls `report` now and then."""
        while (left := self.seconds - self.cpu) > 0:
            fuzzer, before, end = self.begin(left), self.cpu, None
            while (end := os.waitid(os.P_PID, fuzzer.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT)) is None:
                self.cpu = before + cpu_seconds(fuzzer.pid)
                self.count(report)
                if self.cpu >= self.seconds:
                    fuzzer.send_signal(signal.SIGINT)
                time.sleep(LOOK)
            self.cpu = before + cpu_seconds(fuzzer.pid)
            fuzzer.wait()
            self.count(report)
            if not self.executions:
                raise SystemExit(f"{self.name} executed nothing; {self.corpus}.log says why")

    def count(self, report):
        """Executions of all starts, as the log numbers them: "#4096 pulse" and, at the end, "stat::number_of_executed_units: 4099"."""
        self.executions = 0
        for start in Path(f"{self.corpus}.log").read_text(errors="replace").split("INFO: Seed:")[1:]:
            self.executions += max(map(int, re.findall(r"^(?:#|stat::number_of_executed_units: )(\d+)", start, re.M)), default=0)
        self.findings = sum(len(list(self.corpus.parent.glob(f"{self.name}-{kind}-*"))) for kind in FINDINGS)
        report()

    def row(self):
        return f"| `{self.name}` | {self.cpu / 60:.1f} | {self.executions} | {self.findings} |"


def table(fuzzers):
    return "\n".join(["| fuzzer | CPU minutes | executions | findings |", "|---|---|---|---|", *(f.row() for f in fuzzers if f.cpu)])


def keep(file, text):
    beside = file.with_name(file.name + ".new")
    beside.write_text(text + "\n")
    beside.replace(file)


def main(arguments):
    p = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    p.add_argument("folder", type=Path, help="build/fuzz")
    p.add_argument("fuzzers", nargs="*", metavar="FUZZER", choices=[[], *FUZZERS], help="all of them without this")
    p.add_argument("--minutes", type=float, default=10, help="of processor time, for each")
    p.add_argument("--table", type=Path, help="a file that holds the table of what has been done so far")
    words = p.parse_args(arguments)
    fuzzers = [Fuzzer(name, words.folder.resolve(), 60 * words.minutes) for name in words.fuzzers or FUZZERS]
    try:
        for fuzzer in fuzzers:
            fuzzer.run(lambda: words.table and keep(words.table, table(fuzzers)))
    except KeyboardInterrupt:
        print("interrupted: the table counts all work until then", file=sys.stderr)
    print(table(fuzzers), flush=True)
    return 1 if any(f.findings for f in fuzzers) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
