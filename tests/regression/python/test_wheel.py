# SPDX-License-Identifier: BSD-3-Clause
"""The wheel: made without a network, installed in a virtual environment, used from an empty folder."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import netloft

BUILD, SOURCE = Path(os.environ["NETLOFT_BINARY_DIR"]), Path(os.environ["NETLOFT_SOURCE_DIR"])
SMOKE = """
import json, netloft
r = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 150}).solve()
maps = open("/proc/self/maps").read().split()
print(json.dumps({"figures": {name: float(q).hex() for name, q in r.report.items()}, "file": netloft.__file__,
                  "libraries": [m for m in maps if m.endswith(".so") or ".so." in m]}))
"""


# Names in libraries under the GPL, or in archives together with them: names of functions, and of sources that
# appear in messages.
UNDER_THE_GPL = re.compile(rb"cholmod_|umfpack_|CGAL[:_/ ]", re.IGNORECASE)
LICENCES = {"libaec": "BSD", "libsz": "BSD", "libfmt": "MIT", "libtomlplusplus": "MIT", "libmetis": "Apache", "libquadmath": "LGPL",
            "libgfortran": "GPL with the exception for what compilers add"}
OF_SUITESPARSE = [Path("/usr/lib/x86_64-linux-gnu") / name for name in ("libcholmod.so", "libumfpack.so", "libcholmod.a", "libumfpack.a")]


def parts_under_the_gpl(content):
    """Names of UNDER_THE_GPL in the bytes of a program or library, and in its remaining symbols."""
    return sorted({name.decode() for name in UNDER_THE_GPL.findall(content)})


class TheWheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name)
        subprocess.run([sys.executable, SOURCE / "io/python/make_wheel.py", "--cmake", os.environ["NETLOFT_CMAKE"], "--build", BUILD,
                        "--source", SOURCE, "--version", netloft.__version__.split("+")[0].split(" ")[0], "--output", folder], check=True, stdout=subprocess.DEVNULL)
        cls.wheel = next(folder.glob("*.whl"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_names_no_folder_of_the_machine_it_was_made_on(self):
        with zipfile.ZipFile(self.wheel) as archive:
            names = archive.namelist()
            for name in names:
                content = archive.read(name)
                for folder in (BUILD, SOURCE):
                    self.assertNotIn(str(folder).encode() + b"/", content, name)
        self.assertIn("netloft/lib/netloft/rope.so", names)
        self.assertIn("netloft/share/netloft/gear-library/catalogue/twines.toml", names)

    def test_has_no_part_under_the_gpl(self):
        with zipfile.ZipFile(self.wheel) as archive:
            programs = {name: archive.read(name) for name in archive.namelist() if ".so" in name}
            self.assertIn("Neither contains a part under the GPL", archive.read(next(n for n in archive.namelist() if n.endswith("/METADATA"))).decode())
            libraries = {name.split("/")[-1].split(".so")[0] for name in archive.namelist() if name.startswith("netloft/libs/")}
            notices = {name.split("copyright-of-")[1] for name in archive.namelist() if "/licences/" in name}
        self.assertLessEqual(libraries, LICENCES.keys())  # of another one the licence has to be looked up first
        self.assertLessEqual({"libmumps-seq-dev", "libeigen3-dev", "pybind11-dev", "libmetis5", "libfmt9"}, notices)
        self.assertGreater(len(programs), 20)
        programs |= {str(path): path.read_bytes() for path in (BUILD / "python").rglob("*.so")}  # not stripped: hidden symbols, too
        programs["netloft"] = (BUILD / "bin/netloft").read_bytes()
        self.assertEqual({name: found for name, content in programs.items() if (found := parts_under_the_gpl(content))}, {})

    @unittest.skipUnless(any(path.exists() for path in OF_SUITESPARSE), "there is no CHOLMOD to find")
    def test_would_find_parts_under_the_gpl(self):
        for path in OF_SUITESPARSE:
            if path.exists():
                self.assertTrue(parts_under_the_gpl(path.read_bytes()), path)

    def test_works_in_an_environment_of_its_own(self):
        place = Path(self.folder.name) / "environment"
        empty = Path(self.folder.name) / "empty"
        empty.mkdir()
        clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "NETLOFT"))}
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", place], check=True)
        subprocess.run([sys.executable, "-m", "pip", "--python", place / "bin/python", "install", "--no-index", "--no-deps", "--quiet", self.wheel],
                       check=True, env=clean)
        done = subprocess.run([place / "bin/python", "-c", SMOKE], check=True, cwd=empty, env=clean, capture_output=True, text=True)
        found = json.loads(done.stdout)
        self.assertTrue(found["file"].startswith(str(place)))
        foreign = {Path(library).name: library for library in found["libraries"]}
        self.assertIn("libmetis.so.5", foreign)
        self.assertTrue(foreign["libmetis.so.5"].startswith(str(place)), foreign["libmetis.so.5"])
        here = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": 150}).solve()
        self.assertEqual(found["figures"], {name: float(q).hex() for name, q in here.report.items()})
        self.assertEqual(list(empty.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
