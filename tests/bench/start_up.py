#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of a run apart from its solution: processor time of the program's start, of plugins and of the result file.

    start_up.py PROGRAM [OTHER-PROGRAM…] [--times N]

Runs take turns, so that a busy machine slows all of them down alike. For each run the least time is printed, and its ratio to
a start of Python. The scene is a rope of two bars, whose solution takes half a millisecond.
"""
import argparse
import os
import subprocess
import tempfile
from pathlib import Path

SCENE = """
[parts.rope]
type = "rope/bar"
length = "10 m"
cells = 2
sketch = [[-4, 0, 0], [0, 0, -2], [4, 0, 0]]
rope = { diameter = "20 mm", EA = "100 N", density = 1200 }

[[hold]]
on = "rope.start"

[[hold]]
on = "rope.end"
"""


def milliseconds(command, folder):
    """Returns the processor time of a command and of its child processes [ms]."""
    child = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    text = child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f"{' '.join(command)} ends with {child.returncode}:\n{text.decode()}")
    return 1e3 * (usage.ru_utime + usage.ru_stime)


def commands_of(program):
    return {f"{program} --version": [program, "--version"],
            f"{program} plan": [program, "plan", "rope.toml"],
            f"{program} run": [program, "run", "--threads", "1", "rope.toml", "-o", "rope.hdf"]}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("programs", nargs="+")
    options.add_argument("--times", type=int, default=40)
    arguments = options.parse_args()
    commands = {"python3 -c pass": ["/usr/bin/python3", "-c", "pass"]}
    for program in arguments.programs:
        commands |= commands_of(os.path.abspath(program))
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "rope.toml").write_text(SCENE)
        least = {name: float("inf") for name in commands}
        for _ in range(arguments.times):
            for name, command in commands.items():
                least[name] = min(least[name], milliseconds(command, folder))
    for name, time in least.items():
        print(f"{time:8.1f} ms {time / least['python3 -c pass']:6.2f}  {name}")


if __name__ == "__main__":
    main()
