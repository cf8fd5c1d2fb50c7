#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the README's two commands in a fresh clone without a compiler cache.

  cold_start.py [--commit REVISION] [--second] [--folder FOLDER]

Prints processor time and wall time of the first command, the memory of its largest process and the disk space of the build;
with --second, also those of the second command. The packages should be installed already, and the machine should be idle.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMANDS = {"first": ["run", "gear-library/scenes/83-112-flume-3.0kn.toml"], "second": ["test"]}


def measure(clone, words):
    """Runs one command of ./bootstrap. Returns exit status, processor time and wall time [s], memory and disk [MB]."""
    environment = os.environ | {"CCACHE_DISABLE": "1"}
    begin = time.monotonic()
    process = subprocess.Popen(["./bootstrap", *words], cwd=clone, env=environment,
                               stdout=open(clone / f"{words[0]}.log", "w"), stderr=subprocess.STDOUT)
    _, status, usage = os.wait4(process.pid, 0)
    clock = time.monotonic() - begin
    disk = sum(file.lstat().st_blocks * 512 for file in (clone / "build").rglob("*") if file.is_file())
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, clock, usage.ru_maxrss / 1024, disk / 1e6


def minutes(seconds):
    return f"{seconds / 60:.1f} min"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--commit", default="HEAD")
    options.add_argument("--second", action="store_true")
    options.add_argument("--folder", help="folder in which the clone is made and kept (default: a temporary folder)")
    chosen = options.parse_args()
    folder = pathlib.Path(chosen.folder or tempfile.mkdtemp(prefix="netloft-cold-"))
    clone = folder / "netloft"
    subprocess.run(["git", "clone", "-q", ROOT, clone], check=True)
    subprocess.run(["git", "checkout", "-q", chosen.commit], cwd=clone, check=True)
    print(f"{'command':<8} {'exit':>4} {'processor':>10} {'clock':>10} {'memory':>8} {'disk':>8}   in {clone}")
    for name in ["first", "second"] if chosen.second else ["first"]:
        status, processor, clock, memory, disk = measure(clone, COMMANDS[name])
        print(f"{name:<8} {status:>4} {minutes(processor):>10} {minutes(clock):>10} {memory:>5.0f} MB {disk:>5.0f} MB", flush=True)


main()
