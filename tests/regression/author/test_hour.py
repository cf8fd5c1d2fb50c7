# SPDX-License-Identifier: BSD-3-Clause
"""From an installation alone to a tested, running plugin, within the limits that the README promises."""
import json
import unittest

from installed import WithInstallation, code_lines

CLOSED_FORMS = {"element": ("end_z", -3.0, 1e-6), "law": ("end_x", 5.0, 1e-3), "flow": ("slowed", 0.0463114020, 1e-8), "solver": ("horizontal_tension", 2.99708988, 5e-4),
                "integrator": ("lowest", -10.196133, 2e-5), "strategy": ("horizontal_tension", 2.99708988, 5e-4)}


class Hour(WithInstallation):
    def answer(self, command, kind):
        name, value, within = CLOSED_FORMS[kind]
        result = json.loads(self.sh(command + " --json").out)
        found = next(r for r in result["results"] if r["name"] == name) if isinstance(result["results"], list) else result["results"][name]
        self.assertAlmostEqual(found["value"] if isinstance(found, dict) else found, value, delta=within)

    def test_four_commands_with_cmake(self):
        for kind in CLOSED_FORMS:
            with self.subTest(kind):
                self.sh(f"netloft new {kind} otter_{kind}")
                self.sh(f"cmake -S otter_{kind} -B b_{kind}")
                self.sh(f"cmake --build b_{kind}")
                tested = self.sh(f"ctest --test-dir b_{kind}")
                self.assertIn("100% tests passed, 0 tests failed out of 3", tested.out)
                self.answer(f"netloft run otter_{kind}/otter_{kind}.toml --plugins b_{kind}", kind)

    def test_four_commands_without_cmake(self):
        for kind in CLOSED_FORMS:
            with self.subTest(kind):
                name = f"board_{kind}"
                self.sh(f"netloft new {kind} {name}")
                self.sh(f"c++ $(netloft --cflags) {name}/{name}.cpp -o {name}.so")
                self.assertIn(f"{name}/{name}: conforms", self.sh(f"netloft test {name}.so").out)
                self.answer(f"netloft run {name}/{name}.toml --plugins .", kind)

    def test_a_strategy_of_ones_own_is_listed_described_and_completed(self):
        self.sh("netloft new strategy otter && c++ $(netloft --cflags) otter/otter.cpp -o otter.so")
        listed = json.loads(self.sh("netloft list --json --plugins .").out)["components"]
        self.assertIn(("otter/otter", "strategy"), [(c["type"], c["kind"]) for c in listed])
        described = json.loads(self.sh("netloft describe otter/otter --json --plugins .").out)
        self.assertEqual([p["name"] for p in described["parameters"]], ["softest", "factor"])
        table = json.loads(self.sh("netloft schema --plugins .").out)["properties"]["analysis"]["properties"]["otter"]
        self.assertEqual(sorted(table["properties"]), ["factor", "softest"])

    def test_the_author_writes_little(self):
        self.sh("netloft new element otter")
        self.assertLessEqual(len(code_lines(self.folder / "otter" / "otter.cpp")), 30)
        self.assertLessEqual(len(code_lines(self.folder / "otter" / "CMakeLists.txt")), 4)
        self.assertEqual(sorted(p.name for p in (self.folder / "otter").iterdir()),
                         ["CMakeLists.txt", "README.md", "otter.cpp", "otter.toml", "otter_test.cpp"])

    def test_nothing_is_left_of_the_template(self):
        for kind, mine in (("solver", "MySolver"), ("integrator", "MyIntegrator"), ("strategy", "MyStrategy")):
            self.sh(f"netloft new {kind} steepest_{kind}")
            for file in (self.folder / f"steepest_{kind}").iterdir():
                for left in (f"my_{kind}", mine, "SPDX", "/work", "~~~"):
                    self.assertNotIn(left, file.name + file.read_text())

    def test_wrong_names_are_refused_with_the_reason(self):
        self.write("there", "")
        for name, why in (("rope", "there is already a plugin of that name"), ("Otter", "small letters"), ("2nd", "small letters"),
                          ("a/b", "small letters"), ("", "small letters"), ("x" * 41, "40 at most"), ("test", "this word already has a meaning"),
                          ("there", "a file or folder of that name exists")):
            with self.subTest(name):
                ended = self.sh(f"netloft new element '{name}'", expect=2)
                self.assertIn(why, ended.err)
        self.assertIn("element", self.sh("netloft new boat otter", expect=2).err)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["there"])

    def test_a_plugin_for_this_processor_is_built_on_request(self):
        self.sh("netloft new law otter")
        self.sh("cmake -S otter -B build -DNETLOFT_X86_64_V3=ON && cmake --build build")
        self.assertTrue((self.folder / "build" / "otter.so").exists())
        if "x86_64" in self.sh("uname -m").out:
            self.assertTrue((self.folder / "build" / "x86-64-v3" / "otter.so").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
