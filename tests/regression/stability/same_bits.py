# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a run that must have the same bits on every machine: its stages and results, without times and paths of files."""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

OF_THE_RUN = ("netloft/provenance", "netloft/plan")  # when, where, by which words, on how many threads
SECONDS = "s"


def without_times(value):
    """A JSON value without times and without the path of the result."""
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if "seconds" not in k and k not in ("output", "threads", "plan")}
    if isinstance(value, list):
        return [without_times(v) for v in value]
    return value


def datasets(file):
    """Every dataset of a result except times, as bytes by name."""
    found = {}

    def keep(name, item):
        is_time = item.attrs.get("unit") in (SECONDS, SECONDS.encode()) and not name.startswith("VTKHDF")
        if isinstance(item, h5py.Dataset) and not is_time and not name.startswith(OF_THE_RUN):
            found[name] = repr(item[()]).encode() if item.dtype == object else item[()].tobytes()

    with h5py.File(file) as f:
        f.visititems(keep)
    return found


def run(program, scene, settings, threads):
    """The answer and the datasets of one run; a run that did not converge counts like any other."""
    words = [program, "run", scene, "--json", "--threads", str(threads)]
    for setting in settings:
        words += ["--set", setting]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "result.hdf"
        ended = subprocess.run([*words, "-o", file], capture_output=True, text=True, check=False)
        if ended.returncode not in (0, 3):
            raise RuntimeError(f"{scene}: exit {ended.returncode}\n{ended.stderr}")
        return without_times(json.loads(ended.stdout)), datasets(file)


class Busy:
    """A context in which this number of processes keep processors busy."""

    def __init__(self, count=None):
        self.count = count or 2 * (os.cpu_count() or 1)

    def __enter__(self):
        loop = [sys.executable, "-c", "while True: pass"]
        self.processes = [subprocess.Popen(loop) for _ in range(self.count)]
        return self

    def __exit__(self, *_):
        for process in self.processes:
            process.kill()
        for process in self.processes:
            process.wait()
