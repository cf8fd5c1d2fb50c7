# SPDX-License-Identifier: BSD-3-Clause
"""Netloft as an author of plugins uses it: an installation, in an environment without anything else.

NETLOFT_BINARY_DIR names the build that is installed, NETLOFT_CMAKE and NETLOFT_COMPILER the tools of the author.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

BUILD = Path(os.environ["NETLOFT_BINARY_DIR"])
SOURCE = Path(os.environ["NETLOFT_SOURCE_DIR"])
CMAKE = os.environ.get("NETLOFT_CMAKE", "cmake")
SYSTEM = "/usr/local/bin:/usr/bin:/bin"


class Finished:
    def __init__(self, process):
        self.code = process.returncode
        self.out, self.err = (s.decode("utf-8", "replace") for s in (process.stdout, process.stderr))

    def __str__(self):
        return f"exit {self.code}\n{self.out}{self.err}"


class Installation:
    """An installation by `cmake --install` in a new folder, moved once, so that it contains no fixed path."""

    def __init__(self, folder):
        laid = folder / "laid"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", laid], check=True, stdout=subprocess.DEVNULL)
        self.prefix = folder / "usr"
        laid.rename(self.prefix)

    def environment(self):
        kept = {k: v for k, v in os.environ.items() if k in ("HOME", "LANG", "ASAN_OPTIONS", "UBSAN_OPTIONS", "OMP_THREAD_LIMIT")}
        return {**kept, "PATH": f"{self.prefix}/bin:{SYSTEM}", "CMAKE_PREFIX_PATH": str(self.prefix)}


class WithInstallation(unittest.TestCase):
    """Each test starts in a fresh folder; all tests of a class share one installation."""

    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.keeper.cleanup)
        cls.installed = cls.lay_down(Path(cls.keeper.name))

    @classmethod
    def lay_down(cls, folder):
        return Installation(folder)

    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)

    def sh(self, command, expect=0):
        """A line as typed into a shell."""
        ended = Finished(subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.installed.environment(),
                                        stdin=subprocess.DEVNULL, capture_output=True, timeout=280))
        if expect is not None:
            self.assertEqual(ended.code, expect, f"{command}\n{ended}")
        return ended

    def write(self, name, text):
        (self.folder / name).write_text(text)


def code_lines(file):
    """The lines that are neither empty nor comments."""
    return [line for line in Path(file).read_text().splitlines() if not re.match(r"^\s*(//|#(?!include)|$)", line)]


def have(tool):
    return shutil.which(tool, path=SYSTEM) is not None
