# SPDX-License-Identifier: BSD-3-Clause
"""Every command of answers.py has the expected answer, and io/program/MESSAGES.md shows it; --write writes that page."""
import os
import re
import subprocess
import sys
import unittest

from answers import ALL, PRELUDE
from program import PROGRAM, SOURCE, InFreshFolder

PAGE = SOURCE / "io" / "program" / "MESSAGES.md"
HEAD = """\
# Wrong commands and failures, and their messages

Each command here once lost data, failed silently, crashed or hung. The table shows what it prints today. `…` stands for what differs
from machine to machine. `tests/regression/cli/test_answers.py` runs each of these commands, looks for these words and for the files that
have to be left, and writes this page (`--write`). Functions that stand for faults, such as `full_disk BYTES COMMAND`, are in
`tests/regression/cli/answers.py`; hundreds of wrong scenes and their answers in `wrong_*.py` beside it.

Kills and faults at every write are counted in [tests/fault](../../tests/fault/README.md), nonsense in files in
[tests/fuzz](../../tests/fuzz/README.md); what is promised is on [SECURITY.md](../../SECURITY.md).
"""


def row(case):
    command = case.command.replace("|", "\\|")
    return f"| `{command}` | {case.code} | {case.says.replace('|', chr(92) + '|')} |"


def page():
    text = HEAD
    for group in dict.fromkeys(case.group for case in ALL):
        text += f"\n## {group}\n\n| command | exit | words |\n|---|---|---|\n"
        text += "".join(row(case) + "\n" for case in ALL if case.group == group)
    return text


def pattern_of(says):
    return re.compile(r"[\s\S]*?".join(re.escape(piece.strip()) for piece in says.split("…")))


def is_there(need):
    given = {"FULL_DISK": os.environ.get("NETLOFT_FULL_DISK"), "PLUGINS": os.environ.get("NETLOFT_TEST_PLUGINS"),
             "MEMORY": "asan" not in PROGRAM}
    return not need or bool(given[need])


class Answers(InFreshFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "tests").mkdir()
        for name in ("gear-library", "tests/stability"):
            (self.folder / name).symlink_to(SOURCE / name)

    def check(self, case):
        script = f"{PRELUDE}{case.prepare}\n{case.command} >said 2>&1; code=$?\n{case.holds} || echo 'LOST: {case.holds}' >>lost\nexit $code\n"
        if ">" in case.command:
            script = script.replace(">said 2>&1", "2>said", 1)
        environment = self.environment(FULL_DISK=os.environ.get("NETLOFT_FULL_DISK", ""), PLUGINS=os.environ.get("NETLOFT_TEST_PLUGINS", ""),
                                       PATH=f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}")
        ended = subprocess.run(["bash", "-c", script], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                               env=environment, check=False)
        said = (self.folder / "said").read_text(errors="replace") if (self.folder / "said").exists() else ""
        self.assertEqual(ended.returncode, case.code, said + ended.stderr.decode())
        self.assertRegex(said, pattern_of(case.says))
        self.assertFalse((self.folder / "lost").exists(), f"{case.holds} does not hold")

    def test_the_page_shows_them(self):
        self.assertEqual(PAGE.read_text(), page(), "test_answers.py --write writes it")


def add_case(number, case):
    def check(self):
        if not is_there(case.needs):
            self.skipTest(f"this build has no {case.needs}")
        self.check(case)
    setattr(Answers, f"test_{number:02}_{re.sub(r'[^a-z0-9]+', '_', case.command.lower())[:60]}", check)


for at, each in enumerate(ALL):
    add_case(at, each)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(page())
    else:
        unittest.main()
