# SPDX-License-Identifier: BSD-3-Clause
"""Runs every command of the README, in order, in a copy of the gear library.

```sh              lines typed into a shell at the top of the repository; all must end with 0
```toml NAME       a file of that name

Commands that install or build are replaced by the tested build; long runs use coarse meshes.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

BUILD, SOURCE = (Path(os.environ[name]) for name in ("NETLOFT_BINARY_DIR", "NETLOFT_SOURCE_DIR"))
README = SOURCE / "README.md"
BLOCK = re.compile(r"^```(\w*) ?(\S*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
BUILT = ((re.compile(r"^\./bootstrap test"), f"ctest --test-dir {BUILD} --show-only"),
         (re.compile(r"^\./bootstrap hard-cases "), "hard_cases "),
         (re.compile(r"^\./bootstrap "), "netloft "),
         (re.compile(r"\$PWD/build/release"), str(BUILD)))
COARSER = ((re.compile(r"^netloft run .*(83-112|fewer-floats)"), " --set gear.nodes=300"),
           (re.compile(r"^netloft run .*dead-weight"), " --set parts.net.cells=[8,8]"),
           (re.compile(r"^netloft compare"), " --set parts.net.cells=[8,8] --repeats 1 --tolerance 1e-8:1e-6"),
           (re.compile(r"^hard_cases "), " --case flat-sketch"))


def as_tested(line):
    line = re.sub(r"\s+#.*$", "", line)
    for pattern, built in BUILT:
        line = pattern.sub(lambda _: built, line)
    for pattern, coarser in COARSER:
        line += coarser if pattern.search(line) else ""
    return line


class Readme(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)
        shutil.copytree(SOURCE / "gear-library", self.folder / "gear-library")
        (self.folder / "tests").symlink_to(SOURCE / "tests")
        self.path = f"{BUILD}/bin:{os.environ['PATH']}"

    def type(self, line):
        ended = subprocess.run(["bash", "-c", as_tested(line)], cwd=self.folder, env={**os.environ, "PATH": self.path},
                               stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200)
        self.assertEqual(ended.returncode, 0, f"{as_tested(line)}\n{ended.stdout}{ended.stderr}")

    def test_every_command_works(self):
        typed = 0
        for kind, name, body in BLOCK.findall(README.read_text()):
            if name:
                (self.folder / name).write_text(body)
                continue
            self.assertEqual(kind, "sh", "a block that is neither typed nor a file")
            for line in filter(None, body.splitlines()):
                self.type(line)
                typed += 1
        self.assertGreater(typed, 10)

    def test_what_is_typed_is_what_stands_there_but_for_builds_and_long_runs(self):
        self.assertEqual(as_tested("netloft list   # what there is"), "netloft list")
        self.assertEqual(as_tested("./bootstrap run a.toml"), "netloft run a.toml")
        self.assertEqual(as_tested('export PATH="$PWD/build/release/bin:$PATH"'), f'export PATH="{BUILD}/bin:$PATH"')

    def test_a_wrong_command_is_noticed(self):
        with self.assertRaises(AssertionError):
            self.type("netloft run no-such-scene.toml")

    def test_it_fits_its_promise_of_length(self):
        self.assertLessEqual(len(README.read_text().splitlines()), 130)


if __name__ == "__main__":
    unittest.main(verbosity=2)
