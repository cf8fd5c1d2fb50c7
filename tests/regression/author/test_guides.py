# SPDX-License-Identifier: BSD-3-Clause
"""Runs every block of the guides, in order, in an empty folder: writes files, types commands, compares outputs.

```cpp otter.cpp    a file of that name
```sh               lines typed into a shell; all must end with 0
```text             output of the last commands, in this order; lines may be left out, and … stands for any text
"""
import re
import unittest

from installed import SOURCE, WithInstallation, code_lines

BLOCK = re.compile(r"^```(\w+) ?(\S*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def as_pattern(line):
    words = [re.escape(part).replace(r"\ ", " ") for part in line.split("…")]
    return re.compile(r"^\s*" + re.sub(" +", r"\\s+", ".*".join(words).strip()) + r"\s*$")


class Guides(WithInstallation):
    def follow(self, page):
        said = ""
        for kind, file, body in BLOCK.findall((SOURCE / "framework" / "guides" / page).read_text()):
            if file:
                self.write(file, body)
            elif kind == "sh":
                said = "".join(self.sh(line).out for line in body.splitlines())
            elif kind == "text":
                self.compare(body, said)
            else:
                self.fail(f"{page}: a block of {kind} without a file's name")

    def compare(self, promised, said):
        lines = iter(said.splitlines())
        for line in promised.splitlines():
            self.assertTrue(any(as_pattern(line).match(l) for l in lines), f"not said, or not in this place: {line}\n{said}")

    def test_element(self):
        self.follow("element.md")
        self.assertLessEqual(len(code_lines(self.folder / "CMakeLists.txt")), 4)

    def test_the_mistake_that_the_page_proposes(self):
        self.follow("element.md")
        text = (self.folder / "otter.cpp").read_text()
        self.assertIn(" + BW * W[c] / speed", text)
        self.write("otter.cpp", text.replace(" + BW * W[c] / speed", ""))
        self.sh("c++ $(netloft --cflags) otter.cpp -o otter.so")
        self.assertRegex(self.sh("netloft test otter.so", expect=1).out, "FAILED +tangent-is-derivative")

    def test_body(self):
        self.follow("body.md")
        self.assertLessEqual(len(code_lines(self.folder / "plate.cpp")), 80)

    def test_law(self):
        self.follow("law.md")

    def test_flow(self):
        self.follow("flow.md")

    def test_solver(self):
        self.follow("solver.md")
        self.assertLessEqual(len(code_lines(self.folder / "descent.cpp")), 30)

    def test_strategy(self):
        self.follow("strategy.md")
        self.assertLessEqual(len(code_lines(self.folder / "tide.cpp")), 60)

    def test_integrator(self):
        self.follow("integrator.md")

    def test_a_page_that_is_wrong_is_noticed(self):
        with self.assertRaises(AssertionError):
            self.compare("otter/board: conforms\n", "otter/board: does not conform\n")
        with self.assertRaises(AssertionError):
            self.compare("b\na\n", "a\nb\n")
        self.compare("a … ns\n", "x\n   a 12.5 ns  \n")


if __name__ == "__main__":
    unittest.main(verbosity=2)
