# SPDX-License-Identifier: BSD-3-Clause
"""The manual page and the completions that the program makes of its table of commands."""
import os
import pty
import re
import select
import shutil
import subprocess
import unittest

from program import InFreshFolder

FILES = ("gear.toml", "trawl.hdf", "notes.txt", "plan.svg", "trawl plan.toml")


class Manual(InFreshFolder):
    def setUp(self):
        super().setUp()
        self.page = self.netloft("--manual").out
        self.write("netloft.1", self.page)

    def test_has_every_command_with_its_options(self):
        for words in (".SS netloft draw", ".SS netloft study run", "\\fB\\-\\-dimensions\\fR", "\\fI{side,top,front,oblique}\\fR", ".TH NETLOFT 1"):
            self.assertIn(words, self.page)
        for text in re.findall(r"^  (\w+) +\w", self.netloft("--help").out, re.MULTILINE):
            self.assertIn(f"netloft {text}", self.page)

    def test_is_read_without_a_complaint(self):
        readers = [words for words in (["man", "--warnings", "-l"], ["groff", "-man", "-ww", "-z", "-k"], ["mandoc", "-T", "lint", "-W", "error"])
                   if shutil.which(words[0])]
        if not readers:
            self.skipTest("there is no man, groff or mandoc")
        for words in readers:
            with self.subTest(words[0]):
                ended = subprocess.run([*words, "netloft.1"], cwd=self.folder, capture_output=True, env=self.environment(LC_ALL="C.UTF-8"))
                self.assertEqual((ended.returncode, ended.stderr), (0, b""), ended.stdout[-300:])


class Bash(InFreshFolder):
    def completed(self, line):
        """The words that bash offers for the last word of a line."""
        self.write("completion", self.netloft("--completions", "bash").out)
        words = line.split(" ")
        quoted = " ".join(f"'{word}'" for word in words)
        script = f"source ./completion; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _netloft; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        ended = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True, timeout=20)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        return sorted(word for word in ended.stdout.split("\n") if word)

    def test_completes_commands_and_options(self):
        self.assertEqual(self.completed("netloft dr"), ["draw"])
        self.assertEqual(self.completed("netloft study s"), ["show", "submit"])
        self.assertEqual(self.completed("netloft draw --di"), ["--dimensions"])
        self.assertIn("--solver", self.completed("netloft run scene.toml --"))
        self.assertNotIn("--completions", self.completed("netloft --"))

    def test_completes_values_that_are_one_of_a_few_words(self):
        self.assertEqual(self.completed("netloft draw trawl.hdf --view "), ["front", "oblique", "side", "top"])
        self.assertEqual(self.completed("netloft draw --fit = b"), ["boards"])  # bash takes --fit=b apart
        self.assertEqual(self.completed("netloft new tw"), ["two-panel"])

    def test_completes_files_by_their_endings(self):
        for name in FILES:
            self.write(name, "")
        (self.folder / "folder").mkdir()
        self.assertEqual(self.completed("netloft run "), ["folder", "gear.toml", "trawl plan.toml"])
        self.assertEqual(self.completed("netloft draw t"), ["trawl plan.toml", "trawl.hdf"])
        self.assertEqual(self.completed("netloft draw gear.toml -o p"), ["plan.svg"])
        self.assertEqual(self.completed("netloft study run "), ["folder"])
        self.assertEqual(self.completed("netloft draw --width "), [])


@unittest.skipUnless(shutil.which("zsh"), "there is no zsh")
class Zsh(InFreshFolder):
    """zsh at a terminal, in which keys are pressed. A stand-in for netloft prints its arguments."""

    def typed(self, keys):
        (self.folder / "functions").mkdir(exist_ok=True)
        self.write("functions/_netloft", self.netloft("--completions", "zsh").out)
        start = ("PS1=; PS2=; unset zle_bracketed_paste; fpath=($PWD/functions $fpath); autoload -Uz compinit; compinit -u -D; "
                 "netloft() { print -r -- \"<$*>\" }; print re''ady\n")
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.execvpe("zsh", ["zsh", "-f", "-i"], self.environment(TERM="dumb", HOME=str(self.folder)))
        self.addCleanup(os.waitpid, child, 0)
        self.addCleanup(os.close, terminal)
        os.write(terminal, start.encode())
        self.read_until(terminal, rb"\nready")
        os.write(terminal, keys.encode() + b"\n")
        said = self.read_until(terminal, rb"\n<[^>\n]*>\r?\n")
        return re.findall(rb"\n<([^>\n]*)>", said)[-1].decode()

    def read_until(self, terminal, pattern):
        said = b""
        while not re.search(pattern, said):
            ready, _, _ = select.select([terminal], [], [], 30)
            self.assertTrue(ready, said)
            said += os.read(terminal, 4096)
        return said

    def test_completes_commands_options_values_and_files(self):
        self.write("trawl.hdf", "")
        self.write("trawl.txt", "")
        self.assertEqual(self.typed("netloft dra\ttra\t--vie\ttop"), "draw trawl.hdf --view=top")
        self.assertEqual(self.typed("netloft draw --view ob\t"), "draw --view oblique")
        self.assertEqual(self.typed("netloft study sho\t"), "study show")


if __name__ == "__main__":
    unittest.main(verbosity=2)
