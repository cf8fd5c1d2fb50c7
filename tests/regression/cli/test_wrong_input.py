# SPDX-License-Identifier: BSD-3-Clause
"""Wrong input gives a message with its place and a hint, and no files."""
import unittest

from program import InFreshFolder
import wrong_boards
import wrong_bodies
import wrong_laws
import wrong_scenes


class WrongInput(InFreshFolder):
    maxDiff = None

    def check(self, wrong):
        self.answered(wrong)

    def answered(self, wrong):
        self.write("scene.toml", wrong.scene())
        for name, content in wrong.files.items():
            self.write(name, content)
        before = self.files()
        told = self.netloft("run", "scene.toml", "--json", *wrong.args)
        self.assertEqual(told.code, wrong.code, told.err)
        self.assertEqual(self.files(), before, "something was written")
        self.assertLess(len(told.err), 20000, "a flood")
        self.check_errors(wrong, told.err, told.json())
        return told

    def check_without_json(self, wrong):
        told = self.answered(wrong)
        before = self.files()
        plain = self.netloft("run", "scene.toml", *wrong.args)
        self.assertEqual((plain.code, plain.err), (told.code, told.err))
        self.assertEqual(plain.out, "", "standard output is for results")
        self.assertEqual(self.files(), before, "something was written")

    def check_errors(self, wrong, text, report):
        self.assertEqual(report["status"], "plugin refused" if wrong.code == 4 else "wrong input")
        self.assertTrue(report["reason"])
        found = [(e["where"], e["message"], e["hint"]) for e in report["errors"]]
        expected = sorted([(wrong.where, wrong.says)] + wrong.also, key=lambda e: self.line_of(e[0]))
        self.assertEqual(len(found), len(expected), found)
        for (where, message, hint), (wanted_where, words) in zip(found, expected):
            self.assertEqual(where, wanted_where)
            if wanted_where:
                self.assertIn(f"{where}: error: {message}", text)
            else:
                self.assertIn(message, text)
        for where, words in expected:
            self.assertTrue(any(w == where and words in m for w, m, h in found), (words, found))
        self.assertTrue(any(wrong.says in m and wrong.hint in h for w, m, h in found), (wrong.hint, found))

    @staticmethod
    def line_of(where):
        numbers = where.split(":")[1:]
        return [int(n) for n in numbers]


def add_case(wrong, check):
    name = "test_" + "".join(c if c.isalnum() else "_" for c in wrong.name)
    assert not hasattr(WrongInput, name), f"two cases are called {wrong.name}"
    setattr(WrongInput, name, lambda self: check(self, wrong))


# Standard error has the same text with --json; only every tenth scene is also run without it.
for number, each in enumerate(wrong_scenes.ALL + wrong_boards.ALL + wrong_bodies.ALL + wrong_laws.ALL):
    add_case(each, WrongInput.check if number % 10 else WrongInput.check_without_json)


class WrongPath(InFreshFolder):
    def check(self, words, says):
        ended = self.netloft("run", *words)
        self.assertEqual(ended.code, 2, ended.err)
        self.assertIn(says, ended.err)
        self.assertEqual(ended.out, "")
        self.assertEqual(self.files(), {})

    def test_missing_file(self):
        self.check(["nothing.toml"], "nothing.toml cannot be opened: No such file")

    def test_directory_instead_of_a_file(self):
        (self.folder / "gear").mkdir()
        self.check(["gear"], "gear is a directory; a TOML file is expected")

    def test_no_file_named(self):
        self.check([], "SCENE is required")

    def test_two_files(self):
        self.check(["a.toml", "b.toml"], "b.toml")


if __name__ == "__main__":
    unittest.main()
