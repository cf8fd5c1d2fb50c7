#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lists the sources that take longest to compile and the longest tests, in seconds.

    ci_times.py BUILD_FOLDER [ROWS]

Times of sources are those of the latest build of each in ninja's log; an object out of the compiler cache has the short time that
it took from there. Times of tests are those in the output of ctest, which .ci/run stores beside the folder as ci-NAME.log.
"""
import re
import sys
from pathlib import Path


def times_of_sources(folder):
    """Returns the seconds of each step of the build, by its output."""
    latest = {}
    for line in (folder / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, output, _ = line.split("\t")
        latest[output] = (int(end) - int(begin)) / 1000
    return {re.sub(r"CMakeFiles/|\.dir|\.o$", "", output): seconds for output, seconds in latest.items()
            if not output.startswith("/") and seconds > 0}


def times_of_tests(folder):
    """Returns the seconds of each test by name; empty if there is no log."""
    log = folder.parent / f"ci-{folder.name}.log"
    if not log.exists():
        return {}
    found = re.findall(r"Test +#\d+: (.+?) \.*\s*(?:Passed|Skipped|\*\*\*\w+) +([0-9.]+) sec", log.read_text(errors="replace"))
    return {name: float(seconds) for name, seconds in found}


def print_table(title, times, rows):
    print(f"{sum(times.values()):8.0f}  {title}, {len(times)} in all")
    for name, seconds in sorted(times.items(), key=lambda one: -one[1])[:rows]:
        print(f"{seconds:8.1f}  {name}")


def main():
    folder, rows = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 20
    print_table("seconds of building", times_of_sources(folder), rows)
    print_table("seconds of testing", times_of_tests(folder), rows)


if __name__ == "__main__":
    main()
