# SPDX-License-Identifier: BSD-3-Clause
"""The Debian package: its contents, its dependencies, and the first plugin of an author who has only unpacked it."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from installed import BUILD, CMAKE, Installation, WithInstallation, have

CPACK = str(Path(CMAKE).parent / "cpack") if "/" in CMAKE else "cpack"
HOLDS = ("usr/bin/netloft", "usr/lib/netloft/rope.so", "usr/lib/netloft/newton.so", "usr/include/netloft/plugin.h",
         "usr/include/netloft/element.hpp", "usr/include/netloft/solver.hpp", "usr/lib/cmake/netloft/netloftConfig.cmake",
         "usr/lib/cmake/netloft/plugin.map", "usr/share/netloft/gear-library/scenes/hanging-rope.toml",
         "usr/share/doc/netloft/guides/element.md", "usr/share/doc/netloft/guides/law.md", "usr/share/doc/netloft/guides/solver.md", "usr/share/doc/netloft/guides/strategy.md",
         "usr/share/netloft/scene.schema.json", "usr/share/doc/netloft/copyright", "usr/share/doc/netloft/copyright-of-libhdf5-dev",
         "usr/share/man/man1/netloft.1", "usr/share/bash-completion/completions/netloft", "usr/share/zsh/site-functions/_netloft")


class Unpacked(Installation):
    """`dpkg -x` into a fresh folder."""

    def __init__(self, folder):
        subprocess.run([CPACK, "-G", "DEB", "-B", folder], cwd=BUILD, check=True, stdout=subprocess.DEVNULL)
        self.package = next(folder.glob("netloft_*.deb"))
        subprocess.run(["dpkg", "-x", self.package, folder / "root"], check=True)
        self.prefix = folder / "root" / "usr"


class Package(WithInstallation):
    @classmethod
    def lay_down(cls, folder):
        return Unpacked(folder)

    def field(self, name):
        return subprocess.run(["dpkg-deb", "-f", self.installed.package, name], check=True, capture_output=True, text=True).stdout.strip()

    def test_holds_what_it_should(self):
        root = self.installed.prefix.parent
        self.assertEqual([name for name in HOLDS if not (root / name).is_file()], [])
        strange = [p for p in root.rglob("*") if p.is_symlink() or "test" in p.name.lower() and "CMake" not in p.name]
        self.assertEqual(strange, [])

    def test_depends_on_the_libraries_it_is_linked_to(self):
        depends = self.field("Depends")
        for library in ("libc6 (>=", "libstdc++6 (>=", "libmetis"):  # AMD and BLAS are archives
            self.assertIn(library, depends)
        self.assertEqual(self.field("Package"), "netloft")
        for library in ("sundials", "gtest", "cholmod", "blas"):
            self.assertNotIn(library, depends)

    def test_names_no_folder_of_the_machine_it_was_built_on(self):
        for file in self.installed.prefix.rglob("*"):
            if file.is_file() and file.suffix in (".cmake", ".map", ".md", ".html", ".toml", ".json", ".h", ".hpp"):
                self.assertNotIn(str(BUILD).encode(), file.read_bytes(), file)

    def test_has_a_package_of_python_beside_it(self):
        package = next(self.installed.package.parent.glob("python3-netloft_*.deb"))
        depends = subprocess.run(["dpkg-deb", "-f", package, "Depends"], check=True, capture_output=True, text=True).stdout
        for name in ("netloft", "python3-numpy", "libc6 (>="):
            self.assertIn(name, depends)
        subprocess.run(["dpkg", "-x", package, self.installed.prefix.parent], check=True)
        code = "import netloft; print(netloft.__file__, netloft.load('hanging-rope.toml').solve().status)"
        said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(self.installed.prefix / "lib/python3/dist-packages")}).stdout
        self.assertTrue(said.startswith(str(self.installed.prefix)), said)
        self.assertTrue(said.rstrip().endswith("converged"), said)

    def test_an_author_needs_nothing_else(self):
        self.sh("netloft new element otter")
        self.sh("cmake -S otter -B b && cmake --build b")
        self.sh("ctest --test-dir b --output-on-failure")
        self.sh("netloft run otter/otter.toml --plugins b")
        self.sh("netloft run $(dirname $(dirname $(which netloft)))/share/netloft/gear-library/scenes/hanging-rope.toml")


if __name__ == "__main__":
    if not (have("dpkg-deb") and have("dpkg-shlibdeps")):
        print("skipped: there is no dpkg-deb or no dpkg-shlibdeps")
        sys.exit(77)
    unittest.main(verbosity=2)
