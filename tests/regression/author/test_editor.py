# SPDX-License-Identifier: BSD-3-Clause
"""The schema in a real TOML checker and language server, Taplo (npm: @taplo/cli, @taplo/lsp): it completes keys and reports a wrong one.

Skipped where they are not installed: `npm install --prefix FOLDER @taplo/cli @taplo/lsp`, and FOLDER in NETLOFT_TAPLO.
"""
import os
import subprocess
import sys
import unittest
from pathlib import Path

from installed import SOURCE, WithInstallation, have

MODULES = Path(os.environ.get("NETLOFT_TAPLO", "/nonexistent")) / "node_modules"
sys.path.insert(0, str(SOURCE / "tests" / "support" / "editor"))
from language_server import LanguageServer  # noqa: E402

UNFINISHED = """\
#:schema file://SCHEMA
[water]
density = 1025
gra

[parts.rope]
type = "rope/bar"
le
rope = { di }

[analysis]
"""


class Editor(WithInstallation):
    def setUp(self):
        super().setUp()
        self.schema = self.installed.prefix / "share" / "netloft" / "scene.schema.json"
        self.scene = (SOURCE / "gear-library" / "scenes" / "hanging-rope.toml").read_text()

    def lint(self, text):
        self.write("scene.toml", text)
        command = [MODULES / ".bin" / "taplo", "lint", "--colors", "never", "--schema", self.schema.as_uri(), "scene.toml"]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=120)

    def test_shipped_scenes_are_valid(self):
        for file in sorted((SOURCE / "gear-library" / "scenes").glob("*.toml")):
            ended = self.lint(file.read_text())
            self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_a_wrong_key_is_named(self):
        for right, wrong in (("length", "lenght"), ("EA_compression", "EA_compresion"), ("density = 0", "densty = 0")):
            ended = self.lint(self.scene.replace(right, wrong, 1))
            self.assertNotEqual(ended.returncode, 0)
            self.assertIn(f"'{wrong.split()[0]}' was unexpected", ended.stderr)

    def test_keys_are_completed_and_explained(self):
        server = LanguageServer(["node", SOURCE / "tests" / "support" / "editor" / "taplo_stdio.cjs", MODULES], self.folder)
        self.addCleanup(server.close)
        text = server.open("scene.toml", UNFINISHED.replace("SCHEMA", str(self.schema)))
        self.assertIn("gravity", server.completions(text, 3, 3))
        self.assertIn("length", server.completions(text, 7, 2))
        self.assertIn("diameter", server.completions(text, 8, 11))
        self.assertIn("tolerance", server.completions(text, 11, 0))
        self.assertIn("density of the water", server.hover(text, 2, 3))


if __name__ == "__main__":
    if not (MODULES / "@taplo").is_dir() or not have("node"):
        print("skipped: no Taplo in NETLOFT_TAPLO")
        sys.exit(77)
    unittest.main(verbosity=2)
