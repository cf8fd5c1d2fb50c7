#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of a cold build, for each top-level folder and plugin: objects, preprocessed lines and processor time.

  build_cost.py BUILD [--time] [--check TABLE.md]

BUILD is a configured build folder. --time compiles every object once, without a cache, and adds its processor time.
--check compares objects and lines with a table that this script has printed, and fails if a folder has grown by a tenth.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_GROWTH = 1.1  # allowed growth of the objects and lines of a folder; an ordinary new feature stays below


def objects_of(build):
    """Yields folder in the sources, command and working folder for every object of the program and its plugins."""
    targets = subprocess.run(["ninja", "-C", build, "-t", "commands", "netloft", "netloft_plugins"],
                             check=True, capture_output=True, text=True).stdout
    wanted = set(re.findall(r" -o (\S+\.o) -c ", targets))
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        output = words[words.index("-o") + 1]
        if output in wanted:
            yield output.split("/CMakeFiles/")[0], [w for w in words if not w.endswith("ccache")], entry["directory"]


def preprocessed_lines(command, folder):
    words = command.copy()
    at = words.index("-o")
    del words[at:at + 2]
    words[words.index("-c")] = "-E"
    text = subprocess.run(words, cwd=folder, check=True, capture_output=True).stdout
    return sum(1 for line in text.split(b"\n") if line.strip() and not line.startswith(b"#"))


def processor_time(command, folder):
    words = command.copy()
    words[words.index("-o") + 1] = "/dev/null"
    process = subprocess.Popen(words, cwd=folder, env=os.environ | {"CCACHE_DISABLE": "1"})
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit("does not compile: " + shlex.join(words))
    return usage.ru_utime + usage.ru_stime


def measure(build, timed):
    """Returns objects, lines and seconds for each folder of the sources."""
    def one(item):
        room, command, folder = item
        return room, preprocessed_lines(command, folder), processor_time(command, folder) if timed else 0.0
    rooms = collections.defaultdict(lambda: [0, 0, 0.0])
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for room, lines, seconds in pool.map(one, objects_of(build)):
            for i, value in enumerate((1, lines, seconds)):
                rooms[room][i] += value
    return dict(sorted(rooms.items()))


def print_table(rooms, timed):
    print("| room | objects | preprocessed lines |" + (" processor time [s] |" if timed else ""))
    print("|---|---|---|" + ("---|" if timed else ""))
    total = [sum(values) for values in zip(*rooms.values())]
    for room, (objects, lines, seconds) in [*rooms.items(), ("all", total)]:
        print(f"| {room} | {objects} | {lines} |" + (f" {seconds:.1f} |" if timed else ""))


def grown(rooms, table):
    """Returns a sentence for every folder that has grown by a tenth over the printed table, or is missing in it."""
    known = {row[0]: (int(row[1]), int(row[2]))
             for row in re.findall(r"^\| (\S+) \| (\d+) \| (\d+) \|", table, re.MULTILINE)}
    for room, (objects, lines, _) in rooms.items():
        if room not in known:
            yield f"{room}: is not in the table"
            continue
        for what, now, before in zip(("objects", "preprocessed lines"), (objects, lines), known[room]):
            if now > MOST_GROWTH * before:
                yield f"{room}: {now} {what}, {before} in the table"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=lambda path: pathlib.Path(path).resolve())
    options.add_argument("--time", action="store_true")
    options.add_argument("--check", type=pathlib.Path)
    chosen = options.parse_args()
    rooms = measure(chosen.build, chosen.time)
    print_table(rooms, chosen.time)
    if chosen.check:
        faults = list(grown(rooms, chosen.check.read_text()))
        print("\n".join(faults), file=sys.stderr)
        sys.exit(bool(faults))


main()
