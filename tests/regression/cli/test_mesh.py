# SPDX-License-Identifier: BSD-3-Clause
"""Parts on a mesh in a separate file: the same gear as with the mesh of the program, and names of its nodes."""
import re
import unittest

from program import GOOD, InFreshFolder

ACROSS = ALONG = 4

SCENE = """\
[water]
gravity = 9.81
[parts.net]
type = "priour/triangle"
mesh = "gear.mesh"
panel = { bar = "0.6 m" }
twine = { diameter = "10 mm", EA = "10 kN", density = 2000 }
[parts.line]
type = "rope/bar"
mesh = "gear.mesh"
region = "rope"
length = "3 m"
rope = { diameter = "20 mm", EA = "100 kN", EA_compression = 0, density = 1150 }
[[hold]]
on = "*.top"
[analysis]
solver = "newton"
[results]
lowest_z = { of = "net", take = "min z" }
middle_z = { of = "line.middle", take = "z" }
"""


def node(i, j):
    return j * (ACROSS + 1) + i


def mesh():
    """The panel and the rope of program.GOOD, with the mesh that the program would make."""
    lines = ["netloft mesh 1", "[nodes]"]
    lines += [f"{-2 + i} 0 {-j}" for j in range(ALONG + 1) for i in range(ACROSS + 1)]
    lines.append("[triangles net]")
    for j in range(ALONG):
        for i in range(ACROSS):
            a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
            for corners in (((a, b, c), (a, c, d)) if (i + j) % 2 == 0 else ((a, b, d), (b, c, d))):
                lines.append(" ".join(str(node(*k)) for k in corners) + "  " + " ".join(f"{x} {y}" for x, y in corners))
    lines.append("[bars rope]")
    lines += [f"{node(i, ALONG)} {node(i + 1, ALONG)} {i / 4} {(i + 1) / 4}" for i in range(ACROSS)]
    lines += ["[set top]", " ".join(str(node(i, 0)) for i in range(ACROSS + 1)), "[end]", ""]
    return "\n".join(lines)


class Meshes(InFreshFolder):
    def figures(self, scene):
        ended = self.netloft("run", scene, "--json")
        self.assertEqual(ended.code, 0, ended.err)
        return ended.json()["results"]

    def test_a_gear_on_a_mesh_is_the_gear_that_the_program_divides(self):
        middle = 'middle_z = { of = "rope.middle", take = "z" }\n'
        self.write("divided.toml", GOOD + middle)
        self.write("meshed.toml", SCENE)
        self.write("gear.mesh", mesh())
        divided, meshed = self.figures("divided.toml"), self.figures("meshed.toml")
        self.assertEqual(divided.keys(), meshed.keys())
        for name, value in divided.items():
            self.assertAlmostEqual(meshed[name], value, delta=1e-8)

    def test_what_stands_on_every_node_stands_there_whole(self):
        """Two forces of 10 N on each of the five nodes of the line reduce the pull by 100 N."""
        self.write("gear.mesh", mesh())
        pull = SCENE + 'pull = { of = "net.top", take = "sum reaction z" }\n'
        self.write("bare.toml", pull)
        self.write("pulled.toml", pull.replace("[[hold]]", '[parts.lift]\ntype = "force/constant"\non = "line"\neach = 2\n'
                                                           "force = { z = 10 }\n[[hold]]"))
        self.assertAlmostEqual(self.figures("bare.toml")["pull"] - self.figures("pulled.toml")["pull"], 5 * 2 * 10, delta=1e-6)

    def test_a_result_is_an_input(self):
        """The mesh made from a result has the same ropes and panels, and is in equilibrium at the same positions."""
        self.write("divided.toml", GOOD)
        before = self.figures("divided.toml")
        ended = self.netloft("export", "divided.hdf", "shape.mesh")
        self.assertEqual(ended.code, 0, ended.err)
        text = (self.folder / "shape.mesh").read_text()
        self.assertIn("# rope: length = 3", text)
        scene = SCENE.replace("gear.mesh", "shape.mesh").replace('"*.top"', '"net.node-0"')
        scene = re.sub(r"middle_z.*\n", "", scene).replace('"net.node-0"', "[" + ", ".join(f'"net.node-{i}"' for i in range(5)) + "]")
        self.write("again.toml", scene.replace('"newton"', '"newton"\nmax_iterations = 3'))
        self.assertAlmostEqual(self.figures("again.toml")["lowest_z"], before["lowest_z"], delta=1e-8)

    def test_the_file_of_a_result_is_an_input_too(self):
        self.write("divided.toml", GOOD)
        before = self.figures("divided.toml")
        scene = SCENE.replace("gear.mesh", "divided.hdf").replace('"*.top"', "[" + ", ".join(f'"net.node-{i}"' for i in range(5)) + "]")
        scene = re.sub(r"middle_z.*\n", "", scene)
        self.write("again.toml", scene.replace('"newton"', '"newton"\nmax_iterations = 3'))
        self.assertAlmostEqual(self.figures("again.toml")["lowest_z"], before["lowest_z"], delta=1e-8)
        cut = (self.folder / "divided.hdf").read_bytes()[:3000]
        (self.folder / "cut.hdf").write_bytes(cut)
        self.write("cut.toml", scene.replace("divided.hdf", "cut.hdf"))
        ended = self.netloft("plan", "cut.toml")
        self.assertEqual(ended.code, 2)
        self.assertIn("cut.hdf", ended.err)

    def wrong(self, scene, text, where, says):
        self.write("scene.toml", scene)
        self.write("gear.mesh", text)
        ended = self.netloft("plan", "scene.toml")
        self.assertEqual(ended.code, 2, ended.out)
        first = next(line for line in ended.err.splitlines() if "error:" in line)
        self.assertTrue(first.startswith(where + ": error:"), first)
        self.assertIn(says, first)

    def test_what_is_wrong_is_said_with_its_place(self):
        self.wrong(SCENE.replace('region = "rope"\n', ""), mesh(), "scene.toml:10:8", 'has no region "line" of bars')
        self.wrong(SCENE.replace('"rope"', '"net"'), mesh(), "scene.toml:11:10", 'has no region "net" of bars')
        self.wrong(SCENE.replace("gear.mesh", "gaer.mesh", 1), mesh(), "scene.toml:5:8", '"gaer.mesh" cannot be read')
        self.wrong(SCENE.replace("*.top", "*.tpo"), mesh(), "scene.toml:15:6", 'no part has "tpo"')
        self.wrong(SCENE.replace('length = "3 m"\n', "cells = 4\n"), mesh(), "scene.toml:8:1", 'missing key "length"')
        self.wrong(SCENE, mesh().replace("0 1 6  0 0 1 0 1 1", "0 1 66  0 0 1 0 1 1"), "gear.mesh:29:1", "there is no node 66")
        self.wrong(SCENE, re.sub(r"\[end\]", "", mesh()), "gear.mesh:68:1", "cut off")


if __name__ == "__main__":
    unittest.main()
