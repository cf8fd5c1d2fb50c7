# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of keys on a page from what `netloft describe` prints:

    /usr/bin/python3 scene_tables.py NETLOFT PAGE.md [--write]

A block of the page looks like this; the lines between the two comments are made of `netloft describe NAME --json`:

    <!-- keys of analysis, from integrator -->
    <!-- end of keys -->

NAME is a table of the scene (water, analysis, gear), or an element, whose block lists the keys of its geometry. `from KEY`
and `before KEY` select a part of the rows. Without --write the page is compared, and the exit code is 1 if it differs.
"""
import difflib
import json
import re
import subprocess
import sys
from pathlib import Path

BLOCK = re.compile(r"(<!-- keys of ([\w/-]+)(?:, (from|before) (\w+))? -->\n).*?(<!-- end of keys -->)", re.DOTALL)
COLUMNS = (("key", "name"), ("allowed", "allowed"), ("default", "default"), ("what it is", "doc"))


def described(netloft, name):
    said = json.loads(subprocess.run([netloft, "describe", name, "--json"], check=True, capture_output=True).stdout)
    return said.get("geometry") or said["parameters"]


def part_of(rows, side, key):
    if not side:
        return rows
    names = [row["name"] for row in rows]
    if key not in names:
        sys.exit(f"there is no key {key}; there are: {', '.join(names)}")
    return rows[names.index(key):] if side == "from" else rows[:names.index(key)]


def cell(row, column):
    text = str(row.get(column, "")).replace("|", "\\|")
    return f"`{text}`" if column == "name" else text


def table(rows):
    lines = [[title for title, _ in COLUMNS], ["---"] * len(COLUMNS)]
    lines += [[cell(row, column) for _, column in COLUMNS] for row in rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines).replace("|  |", "| |")


def filled(page, netloft):
    return BLOCK.sub(lambda m: m[1] + table(part_of(described(netloft, m[2]), m[3], m[4])) + m[5], page)


def main():
    netloft, file, *rest = sys.argv[1:]
    before = Path(file).read_text()
    if not BLOCK.search(before):
        sys.exit(f"{file}: has no block of keys")
    after = filled(before, netloft)
    if rest == ["--write"]:
        Path(file).write_text(after)
    elif after != before:
        sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), after.splitlines(True), "the page", "the program"))
        sys.exit(f"{file}: differs from the output of the program; to update it: tests/support/scene_tables.py {netloft} {file} --write")


if __name__ == "__main__":
    main()
