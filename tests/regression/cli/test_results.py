# SPDX-License-Identifier: BSD-3-Clause
"""Commands that show stored results: `report`, `draw` of a result, `view`."""
import csv
import io
import json
import re
import struct
import unittest
import zlib
from base64 import b64decode
from html.parser import HTMLParser

import h5py
import numpy

from program import GOOD, SOURCE, InFreshFolder, changed

GEAR = str(SOURCE / "gear-library/scenes/83-112-flume-3.0kn.toml")
MOTION = str(SOURCE / "gear-library/scenes/dynamics/elastic-pendulum.toml")
HOSTILE = "</script><img src=x onerror=alert(1)>\"'&\u202e" + 10000 * "w"


class Elements(HTMLParser):
    """Names, attributes and texts of a page, parsed as by a browser."""

    def __init__(self, page):
        super().__init__()
        self.names, self.attributes, self.texts = [], [], []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.names.append(tag)
        self.attributes += [(tag, *pair) for pair in attrs]

    def handle_data(self, data):
        self.texts.append(data)


def pixels(png):
    """The pixels of a PNG file with eight bits a colour, whose rows name the filter none or sub."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at, data, size = 8, b"", None
    while at < len(png):
        length, name = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        assert zlib.crc32(name + body) == struct.unpack(">I", png[at + 8 + length:at + 12 + length])[0]
        size = struct.unpack(">II", body[:8]) if name == b"IHDR" else size
        data += body if name == b"IDAT" else b""
        at += 12 + length
    rows = numpy.frombuffer(zlib.decompress(data), numpy.uint8).reshape(size[1], 1 + 3 * size[0])
    assert set(rows[:, 0]) == {1}
    return numpy.cumsum(rows[:, 1:].reshape(size[1], size[0], 3), axis=1, dtype=numpy.uint8)


class Results(InFreshFolder):
    def solved(self, name, text, *words):
        self.write(f"{name}.toml", text)
        ended = self.netloft("run", f"{name}.toml", *words)
        self.assertIn(ended.code, (0, 3), ended.err)
        return f"{name}.hdf"

    def gear(self, *words):
        ended = self.netloft("run", GEAR, "--set", "gear.nodes=400", "-o", "gear.hdf", *words)
        self.assertEqual(ended.code, 0, ended.err)
        return "gear.hdf", ended.out

    def done(self, *words, code=0):
        ended = self.netloft(*words)
        self.assertEqual(ended.code, code, ended.out[:500] + ended.err[:500])
        return ended

    def refused(self, *words):
        ended = self.done(*words, code=2)
        self.assertEqual(ended.out, "")
        return ended.err

    def test_a_report_repeats_the_numbers_of_the_run(self):
        result, said = self.gear()
        again = self.done("report", result).out
        for line in said.splitlines():
            if re.match(r"  (headline|upper wing|mouth|drag|weight)", line):
                self.assertIn(line, again)
        self.assertIn("headline height", again)
        table = list(csv.DictReader(io.StringIO(self.done("report", result, "--csv").out)))
        report = self.done("report", result, "--json").json()
        with h5py.File(self.folder / result) as f:
            height = f["netloft/gear/mouth/headline_height"][()]
        self.assertEqual(report["gear"]["figures"]["mouth/headline_height"], height)
        self.assertEqual([float(row["value"]) for row in table if row["name"] == "mouth/headline_height"], [height])

    def test_an_error_without_the_mesh_is_not_known(self):
        result, said = self.gear()
        self.assertRegex(said, r"headline height +[\d.]+ m +height")
        self.assertIn("errors of the mesh are not known", said)
        error = self.done("report", result, "--json").json()["gear"]["errors"]["mouth/headline_height"]
        self.assertIsNone(error["mesh"])
        self.assertGreater(error["solver"], 0)

    def test_a_bill_of_materials_adds_up(self):
        result, _ = self.gear()
        rows = {row["name"]: row for row in self.done("report", result, "--json").json()["materials"]}
        self.assertEqual((rows["headline"]["number"], rows["upper-bridle"]["number"]), (47, 2))
        self.assertAlmostEqual(rows["upper-bridle"]["length"], 2 * 54.9)
        self.assertIsNone(rows["headline"]["mass"])  # the plan has their buoyancy alone
        bridle = rows["upper-bridle"]
        self.assertAlmostEqual(bridle["utilisation"], bridle["load"] / bridle["breaking_load"])
        with h5py.File(self.folder / result) as f:
            self.assertAlmostEqual(bridle["load"], f["netloft/gear/ropes/upper-bridle/tension_largest"][()])
            self.assertAlmostEqual(rows["top-wing"]["mass"], f["netloft/gear/panels/top-wing/mass"][()])

    def test_a_rope_that_would_break_is_warned_of(self):
        result, _ = self.gear("--set", 'ropes.upper-bridle.rope={ part = "6x19-fc-16mm", breaking_load = "5 kN" }')
        said = self.done("report", result)
        self.assertRegex(said.out, r"warning: upper-bridle carries \d+ N, 1\d\d % of the breaking load of 6x19-fc-16mm: it would break")

    def test_a_page_of_the_report_has_plan_views_and_materials(self):
        result, _ = self.gear()
        self.done("report", result, "-o", "page.html")
        page = (self.folder / "page.html").read_text()
        parts, words = Elements(page), " ".join(Elements(page).texts)
        self.assertEqual((parts.names.count("svg"), parts.names.count("image"), parts.names.count("script")), (5, 4, 0))
        for text in ("headline height", "Obliquely from ahead", "Materials, and loads against breaking loads", "6x19-fc-16mm", "From the front",
                     "The plan"):
            self.assertIn(text, words)
        plan = page[page.rindex("<svg"):]
        self.assertIn(">top-wing<", plan)
        self.assertGreater(plan.count("<line") + plan.count("<path"), 20)

    def test_a_report_of_what_has_not_converged_says_so(self):
        result = self.solved("a", GOOD, "--set", "analysis.max_iterations=1")
        ended = self.done("report", result, code=3)
        self.assertTrue(ended.out.startswith("a: not converged"), ended.out[:80])

    def test_twines_lie_where_the_file_says(self):
        result = self.solved("a", changed(GOOD, ("across = 4", 'netting = "square", across = 4')))
        with h5py.File(self.folder / result) as f:
            numpy.testing.assert_allclose(f["netloft/parts/twine_axes"][0], [1, 0, 0, 1])
            numpy.testing.assert_allclose(f["netloft/parts/diameter"][:], [0.01, 0.02])
            self.assertAlmostEqual(f["netloft/parts/bar"][0], 0.6)
            self.assertTrue(numpy.isnan(f["netloft/parts/twine_axes"][1]).all())

    def test_a_picture_shows_the_gear_and_not_a_blank(self):
        result, _ = self.gear()
        self.done("draw", result, "-o", "a.png", "--width", "600")
        image = pixels((self.folder / "a.png").read_bytes())[60:-60].astype(float)
        self.assertEqual(image.shape[1], 600)
        painted = (image.min(axis=2) < 200).mean()
        self.assertGreater(painted, 0.02)
        self.assertLess(painted, 0.6)
        self.done("draw", result, "-o", "b.png", "--width", "600")
        self.assertEqual(*((self.folder / name).read_bytes() for name in ("a.png", "b.png")))
        self.done("draw", result, "-o", "c.png", "--width", "600", "--view", "side")
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "c.png").read_bytes())

    def test_hidden_surfaces_are_hidden(self):
        # Two vertical panels, one behind the other as seen from port (y = -1 is nearer): the nearer one has the part's first colour.
        wall = changed(GOOD, ("sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]", "sketch = [[-2, 1, 0], [2, 1, 0], [2, 1, -4], [-2, 1, -4]]"))
        body = wall[wall.index("[parts.net]"):wall.index("[parts.rope]")]
        text = changed(wall[:wall.index("[parts.rope]")], ('"10 mm"', '"590 mm"')) + changed(
            body, ("parts.net", "parts.near"), ("sketch = [[-2, 1, 0], [2, 1, 0], [2, 1, -4], [-2, 1, -4]]", "sketch = [[-2, -1, 0], [2, -1, 0], [2, -1, -4], [-2, -1, -4]]"), ('"10 mm"', '"590 mm"'))
        text += '[[hold]]\non = "net.fore"\n[[hold]]\non = "near.fore"\n[analysis]\nsolver = "newton"\n'
        result = self.solved("walls", text)
        self.done("draw", result, "-o", "a.png", "--width", "300", "--view", "side", "--field", "part")
        image = pixels((self.folder / "a.png").read_bytes())
        middle = image[image.shape[0] // 2, 150].astype(int)
        self.assertLess(abs(middle - [0xe6, 0x9f, 0x00]).max(), 12, middle)  # of "near", the second part

    def test_an_svg_is_well_formed_and_names_what_it_shows(self):
        import xml.etree.ElementTree as tree
        result, _ = self.gear()
        self.done("draw", result, "--field", "opening")
        root = tree.parse(self.folder / "gear.svg").getroot()
        words = " ".join(root.itertext())
        self.assertIn("opening", words)
        self.assertIn("83-112-flume-3.0kn", words)
        self.assertRegex(words, r"\d m")
        image = root.find("{http://www.w3.org/2000/svg}image").attrib["href"]
        self.assertGreater(pixels(b64decode(image.split(",")[1])).std(), 5)

    def test_a_picture_of_parts_names_the_parts(self):
        import xml.etree.ElementTree as tree
        result = self.solved("a", GOOD)
        self.done("draw", result, "--field", "part")
        words = list(tree.parse(self.folder / "a.svg").getroot().itertext())
        self.assertLessEqual({"net", "rope"}, set(words))

    def test_a_field_that_is_not_there_is_refused_with_those_that_are(self):
        result = self.solved("a", GOOD)
        self.assertIn("has no field opning; it has tension, ", self.refused("draw", result, "--field", "opning"))

    def data_of(self, page):
        text = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S).group(1)
        self.assertNotIn("<", text)
        return json.loads(text)

    def array(self, packed):
        width = 4
        raw = numpy.frombuffer(zlib.decompress(b64decode(packed["d"])), numpy.uint8)
        return raw.reshape(width, -1).T.copy().view({"f32": "<f4", "u32": "<u4"}[packed["t"]]).ravel()

    def test_a_page_holds_the_shape_and_fields_of_the_result(self):
        result, _ = self.gear()
        self.done("view", result)
        page = (self.folder / "gear.html").read_text()
        one = self.data_of(page)["results"][0]
        with h5py.File(self.folder / result) as f:
            points = f["VTKHDF/Points"][:]
            tension = numpy.fmax(numpy.fmax(f["VTKHDF/CellData/tension"][:], f["VTKHDF/CellData/tension_u"][:]), f["VTKHDF/CellData/tension_v"][:])
        shown = self.array(one["states"][0]["points"]).reshape(-1, 3) + one["origin"]
        numpy.testing.assert_allclose(shown, points, atol=1e-6 * numpy.abs(points).max())
        at = [field["name"] for field in one["fields"]].index("tension")
        numpy.testing.assert_allclose(self.array(one["states"][0]["fields"][at]), tension, rtol=2**-15)
        self.assertTrue(one["half"])
        self.assertLess(len(page), 2e6)

    def test_a_motion_keeps_as_many_states_as_are_wanted(self):
        self.done("run", MOTION, "-o", "motion.hdf")
        self.done("view", "motion.hdf", "--states", "5", "-o", "page.html")
        one = self.data_of((self.folder / "page.html").read_text())["results"][0]
        with h5py.File(self.folder / "motion.hdf") as f:
            times = f["VTKHDF/Steps/Values"][:]
        self.assertEqual(len(one["states"]), 5)
        self.assertEqual((one["times"][0], one["times"][-1]), (times[0], times[-1]))

    def test_hostile_names_and_texts_become_no_markup(self):
        text = changed(GOOD, ("[parts.rope]", f"[parts.'{HOSTILE[:60]}']\ntype = \"rope/bar\"\nlength = \"1 m\"\ncells = 1\nsketch = [[9, 0, 0], [9, 0, -1]]\n"
                                              "rope = { diameter = \"20 mm\", EA = \"100 kN\", EA_compression = 0, density = 1150 }\n[parts.rope]"))
        result = self.solved("a", GOOD)
        with h5py.File(self.folder / result, "r+") as f:  # what a scene may not name, a file still may
            names = f["netloft/parts/name"]
            names[0] = HOSTILE
            f["netloft/status"].attrs["sentence"] = HOSTILE
            f["netloft/provenance/files/text"][0] = text + HOSTILE
            f["netloft/provenance/files/path"][0] = HOSTILE + ".toml"
            f["VTKHDF/CellData"].move("strain", "<b>strain")
            f["VTKHDF/Steps/CellDataOffsets"].move("strain", "<b>strain")
        for words in (["view", result, "-o", "a.html"], ["report", result, "-o", "b.html"]):
            self.done(*words)
            page = (self.folder / words[-1]).read_text()
            parts = Elements(page)
            self.assertNotIn("img", parts.names)
            self.assertNotIn("b", parts.names)
            self.assertEqual([a for a in parts.attributes if a[1].startswith("on")], [])
            self.assertEqual(parts.names.count("script"), 3 if words[0] == "view" else 0)
            policies = [a[2] for a in parts.attributes if a[0] == "meta" and a[2] and "default-src" in a[2]]
            self.assertEqual(len(policies), 1)
            self.assertIn("default-src 'none'", policies[0])
            self.assertNotIn("unsafe", policies[0])
        self.assertTrue(any(HOSTILE in text for text in parts.texts))
        self.done("draw", result)
        self.assertNotIn("<img", (self.folder / "a.svg").read_text())

    def test_the_policy_names_the_scripts_that_are_there(self):
        import base64
        import hashlib
        result = self.solved("a", GOOD)
        self.done("view", result)
        page = (self.folder / "a.html").read_bytes()
        policy = re.search(rb'Content-Security-Policy" content="([^"]*)"', page).group(1)
        bodies = re.findall(rb"<script>(.*?)</script>", page, re.S) + re.findall(rb"<style>(.*?)</style>", page, re.S)
        self.assertEqual(len(bodies), 3)
        for body in bodies:
            self.assertIn(b"'sha256-" + base64.b64encode(hashlib.sha256(body).digest()) + b"'", policy)

    def test_an_older_file_is_shown_as_far_as_it_goes(self):
        result = self.solved("a", GOOD)
        with h5py.File(self.folder / result, "r+") as f:
            for name in ("twine_axes", "diameter", "bar", "sheet"):
                del f["netloft/parts"][name]
            del f["VTKHDF/CellData/panel_corners"]
        said = self.done("report", result).out
        self.assertIn("it was written by an older version", said)
        self.done("view", result)
        self.done("draw", result)

    def test_files_that_cannot_be_shown_are_refused_with_a_sentence(self):
        result = self.solved("a", GOOD)
        whole = (self.folder / result).read_bytes()
        self.write("cut.hdf", whole[:len(whole) // 2])
        self.write("text.hdf", "no HDF5 at all")
        with h5py.File(self.folder / "other.hdf", "w") as f:
            f["numbers"] = [1, 2]
        self.write("newer.hdf", whole)
        with h5py.File(self.folder / "newer.hdf", "r+") as f:
            f["netloft"].attrs["schema"] = 99
        self.write("wild.hdf", whole)
        with h5py.File(self.folder / "wild.hdf", "r+") as f:
            f["VTKHDF/Connectivity"][0] = 123456789
        for command in (["report"], ["view"], ["draw"]):
            self.assertIn("it is truncated", self.refused(*command, "cut.hdf"))
            self.assertIn("it is not an HDF5 file", self.refused(*command, "text.hdf"))
            self.assertIn("not a result of netloft", self.refused(*command, "other.hdf"))
            self.assertIn("was written by a newer netloft, in format 99", self.refused(*command, "newer.hdf"))
            self.assertIn("there is no such file", self.refused(*command, "nowhere.hdf"))
        for command in (["view"], ["draw"]):  # a report has no need of the shape
            self.assertIn("wild.hdf is damaged: a cell refers to a node that does not exist", self.refused(*command, "wild.hdf"))

    def test_run_report_and_page_have_the_same_figures_in_the_same_order(self):
        scene = SOURCE / "gear-library/scenes/pelagic-with-doors.toml"
        run = self.netloft("run", str(scene), "--set", "gear.nodes=200", "-o", "doors.hdf").out
        report = self.netloft("report", "doors.hdf").out
        self.assertEqual(run, report)
        page = Elements(self.page("doors.hdf"))
        said = " ".join(" ".join(page.texts).split())
        for title in ("Boards and other bodies", "Water on bodies", "Forces on bodies", "board spread", "Warps", "Ropes across the gear", "towing power", "Netting", "Forces by part"):
            self.assertIn(title, said)
        for line in report.splitlines():
            words = line.split()
            if line.startswith("    ") and words[0] == "warp":
                for number in words[1:]:
                    self.assertIn(number, said, line)

    def page(self, result):
        self.done("report", result, "-o", "page.html")
        return (self.folder / "page.html").read_text()

    def test_what_it_is_made_from_is_never_replaced(self):
        result = self.solved("a", GOOD)
        before = (self.folder / result).read_bytes()
        self.assertIn("is an input of this command", self.refused("view", result, "-o", result))
        self.assertIn("is an input of this command", self.refused("draw", result, "-o", result))
        self.assertIn("is a folder or a device, and cannot be replaced", self.refused("draw", result, "-o", "."))
        self.assertEqual((self.folder / result).read_bytes(), before)

    def test_a_state_that_is_not_there_is_refused(self):
        result = self.solved("a", GOOD)
        for command in (["draw", result, "-o", "a.svg"], ["export", result, "a.csv"], ["export", result, "a.glb"]):
            self.assertIn(f"--state 7: {result} has one state, 0", self.refused(*command, "--state", "7"))

    def test_an_ending_that_is_not_written_is_refused(self):
        result = self.solved("a", GOOD)
        self.assertIn("a.pdf: the name of this file must end in .svg or .png", self.refused("draw", result, "-o", "a.pdf"))
        self.assertIn("a.pdf: the name of this file must end in .html or .htm", self.refused("view", result, "-o", "a.pdf"))

    def test_an_option_without_effect_is_refused(self):
        result = self.solved("a", GOOD)
        for option in (["--mesh"], ["--set", "a=1"]):
            self.assertIn(f"{option[0]} is for a net plan; {result} is a result", self.refused("draw", result, *option))
        self.assertIn("there is no option --plugins of `netloft draw`; `netloft check` has it", self.refused("draw", result, "--plugins", "."))
        plan = str(SOURCE / "gear-library" / "gears" / "four-panel.toml")
        for option in (["--view", "side"], ["--field", "tension"], ["--dimensions"], ["--fit", "all"]):
            self.assertIn(f"{option[0]} is for a result; {plan} is a net plan", self.refused("draw", plan, "-o", "a.svg", *option))
        self.assertIn("--field is for a .glb file; a.csv is a file of another kind", self.refused("export", result, "a.csv", "--field", "tension"))
        self.assertIn("--table is for a .csv file; a.glb is a file of another kind", self.refused("export", result, "a.glb", "--table", "nodes"))
        self.assertFalse({"a.svg", "a.csv", "a.glb"} & set(self.files()))

    def test_an_export_holds_every_part_where_it_is(self):
        result, _ = self.gear()
        self.done("export", result, "gear.glb")
        data = (self.folder / "gear.glb").read_bytes()
        self.assertEqual((data[:4], *struct.unpack("<II", data[4:12])), (b"glTF", 2, len(data)))
        length = struct.unpack("<I", data[12:16])[0]
        document, binary = json.loads(data[20:20 + length]), data[28 + length:]
        with h5py.File(self.folder / result) as f:
            points, names = f["VTKHDF/Points"][:], [n.decode() for n in f["netloft/parts/name"]]
            corners = sum(1 for kind in f["VTKHDF/Types"] if kind == 5) * 3
        self.assertEqual({mesh["name"] for mesh in document["meshes"]}, set(names) - {"flow"})  # the rim of the mouth is no part of the gear
        triangles = [p for mesh in document["meshes"] for p in mesh["primitives"] if p["mode"] == 4]
        self.assertEqual(sum(document["accessors"][p["attributes"]["POSITION"]]["count"] for p in triangles), corners)
        boxes = [document["accessors"][p["attributes"]["POSITION"]] for mesh in document["meshes"] for p in mesh["primitives"]]
        numpy.testing.assert_allclose(numpy.max([b["max"] for b in boxes], axis=0), points.max(axis=0), atol=1e-4)
        netting = [document["materials"][p["material"]]["pbrMetallicRoughness"] for p in triangles if "TEXCOORD_0" in p["attributes"]]
        self.assertTrue(netting and all("baseColorTexture" in material for material in netting))
        for image in document["images"]:
            view = document["bufferViews"][image["bufferView"]]
            twines = pixels(binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]])
            self.assertLess(twines.min(), 100)
            self.assertEqual(twines.max(), 255)
        view = document["bufferViews"][boxes[0]["bufferView"]]
        first = numpy.frombuffer(binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]], "<f4").reshape(-1, 3)
        numpy.testing.assert_allclose(first.min(axis=0), boxes[0]["min"], rtol=1e-6)

    def test_tables_hold_nodes_and_elements(self):
        result = self.solved("a", GOOD)
        self.done("export", result, "nodes.csv")
        self.done("export", result, "elements.csv", "--table", "elements")
        nodes = list(csv.DictReader(io.StringIO((self.folder / "nodes.csv").read_text())))
        elements = list(csv.DictReader(io.StringIO((self.folder / "elements.csv").read_text())))
        with h5py.File(self.folder / result) as f:
            self.assertEqual([float(n["z [m]"]) for n in nodes], list(f["VTKHDF/Points"][:, 2]))
            self.assertEqual(len(elements), f["VTKHDF/NumberOfCells"][0])
            self.assertEqual(elements[-1]["part"], "rope")
            self.assertEqual(float(elements[-1]["tension [N]"]), f["VTKHDF/CellData/tension"][-1])
        self.assertIn("it must be .glb, .csv, .mesh, .obj or .vtk", self.refused("export", result, "a.stl"))

    def test_two_results_come_with_what_changed_between_them(self):
        a, b = self.solved("a", GOOD), self.solved("b", changed(GOOD, ("density = 2000", "density = 2600")))
        self.done("view", a, b, "-o", "both.html")
        page = (self.folder / "both.html").read_text()
        self.assertIn("What changed", page)
        self.assertIn("results/lowest_z", page)
        self.assertEqual(len(self.data_of(page)["results"]), 2)


# Two bars of 1 m between points 1.8 m apart bear their weight hanging, and also standing, as an arch.
ARCH = """\
[water]
density = 0
gravity = 9.81

[parts.arch]
type = "rope/bar"
length = "2 m"
cells = 2
sketch = [[0, 0, 0], [0.9, 0, 0.43], [1.8, 0, 0]]
rope = { diameter = "10 mm", EA = "10 kN", EA_compression = "10 kN", density = 1000 }

[[hold]]
on = ["arch.start", "arch.end"]

[[hold]]
on = "arch"
axes = "y"

[analysis]
strategy = "auto"

[analysis.auto]
without = "tension-stages"
restarts = 12

[results]
middle = { of = "arch", take = "mean z" }
thrust = { of = "arch.end", take = "sum reaction x" }
"""
RISE = (1 - 0.9 ** 2) ** 0.5 / 3  # of the mean of three nodes, if bars do not stretch
THRUST = 0.5 * 1000 * 9.81 * 3.14159265 / 4 * 0.01 ** 2 * 0.9 / (3 * RISE)  # half the weight at the middle, by moments

# Netting with turned meshes, held slack along two edges.
STIFF = """
[water]
density = 1025
[parts.net]
type = "priour/triangle"
panel = { across = 40, along = 40, bar = "0.06 m", netting = "t90" }
cells = [8, 8]
sketch = [[-1.2, 0, 0], [1.2, 0, 0], [1.2, 0, -3], [-1.2, 0, -3]]
twine = { diameter = "3 mm", EA = "1 kN", density = 1140, EI = "1e-4 N.m2", opening_angle = "30 deg" }
[[hold]]
on = ["net.fore", "net.aft"]
"""
ROPE = """
[water]
density = 1025
[parts.rope]
type = "rope/bar"
length = "10 m"
cells = 40
sketch = [[0, 0, 0], [8, 0, 0]]
rope = { diameter = "12 mm", EA = "100 kN", density = 1140, EI = "0.01 N.m2" }
[[hold]]
on = ["rope.start", "rope.end"]
"""


FLOAT = """
[water]
density = 1000
current = [1.7, 0, 0]
[parts.rod]
type = "rope/bar"
cells = 1
sketch = [[0, 0, 0], [0.05, 0.02, 2]]
length = 2
rope = { EA = 1e5, EA_compression = 1e5, diameter = 0.001, density = 1140 }
[parts.float]
type = "float/float"
on = "rod.end"
float = { buoyancy = 100, diameter = 0.2, mass = 5, drag_law = "sphere" }
[[hold]]
on = "rod.start"
[analysis]
max_iterations = 100
[results]
x = { of = "rod.end", take = "x" }
y = { of = "rod.end", take = "y" }
z = { of = "rod.end", take = "z" }
"""


class Swinging(InFreshFolder):
    """A float on a rod in its drag crisis swings, more and more: its drag falls as the water passes it faster."""

    def run_float(self, words, *more):
        self.write("float.toml", FLOAT.replace("max_iterations = 100", "max_iterations = 100\n" + words))
        return self.netloft("run", "float.toml", "--overwrite", *more)

    def test_is_unstable_unless_the_scene_accepts_it(self):
        for words, status, code in (("", "unstable", 3), ('swinging = "refused"', "unstable", 3), ('swinging = "accepted"', "converged", 0)):
            ended = self.run_float(words, "--json")
            self.assertEqual((ended.code, ended.json()["status"], ended.json()["stability"]), (code, status, "swinging"), ended.err)
            self.assertIn("swinging with a period of", ended.json()["reason"])

    def test_a_motion_may_begin_there_and_says_so_unless_the_scene_accepts_it(self):
        motion = '\nkind = "dynamic"\nstart = "equilibrium"\nduration = 0.02'
        for words, says in (("refused", True), ("accepted", False)):
            ended = self.run_float(f'swinging = "{words}"' + motion, "--json")
            self.assertEqual(ended.code, 0, ended.err)
            self.assertEqual("it began at an equilibrium that is not stable" in ended.json()["reason"], says, ended.json()["reason"])

    def test_says_how_much_each_result_depends_on_it(self):
        report = self.run_float('swinging = "accepted"', "--json").json()
        swing, at = report["swing"], report["results"]
        self.assertEqual(swing["furthest"], "rod node 1")
        change = [swing["per_metre"][axis] for axis in "xyz"]
        self.assertAlmostEqual(sum(c ** 2 for c in change), 1, delta=1e-6)  # of the end itself: as far as it goes
        self.assertLess(abs(change[0] * at["x"] - change[2] * at["z"]), 1e-3)  # across the rod, in the plane of the stream
        said = self.run_float('swinging = "accepted"').out
        table = [line for line in said.splitlines() if line.startswith("    x  ")]
        self.assertEqual(len(table), 1, said)
        self.assertIn(table[0], self.netloft("report", "float.hdf").out)
        again = self.netloft("report", "float.hdf", "--json").json()
        self.assertEqual(again["swing"], swing)

    def test_is_no_longer_an_answer_of_the_hard_cases_once_references_are_renewed(self):
        at = self.run_float("", "--json").json()["results"]
        kept = {"unknowns": 3, "energy": 0, "size": 2, "load": 100, "noise": 1e-9, "found_by": "newton", "nodes": [[1, at["x"], at["y"], at["z"]]]}
        elsewhere = {**kept, "nodes": [[1, at["x"], at["y"], -at["z"]]]}
        self.write("float/references.json", json.dumps({"swings/here": {"small": kept}, "swings/there": {"small": elsewhere}}))
        cases = "".join(f'[[case]]\nname = "{name}"\nexpected = "stable"\n' for name in ("here", "there"))
        self.write("float/swings.toml", f'scene = "../float.toml"\n[sizes]\nsmall = []\n{cases}')
        self.write("float/solvers.toml", '[[solver]]\nstrategy = "auto"\n')

        def words():
            return [case["where"] for case in self.netloft("hard_cases", "float", "--size", "small", "--json").json()["cases"]]

        self.assertEqual(words(), ["unstable", "unstable"])
        self.netloft("hard_cases", "float", "--size", "small", "--update-references")
        self.assertEqual(list(json.loads((self.folder / "float/references.json").read_text())), ["swings/there"])
        self.assertEqual(words(), ["flutters", "unstable"])

    def test_what_goes_away_without_swinging_says_what_depends_on_it_too(self):
        topples = FLOAT.replace("[1.7, 0, 0]", "[0, 0, 0.2]").replace("[0.05, 0.02, 2]", "[0, 0, -2]")  # a float that is pushed down
        self.write("float.toml", topples)
        ended = self.netloft("run", "float.toml", "--json", "--strategy", "direct", "--solver", "newton:method=classic")
        report = ended.json()
        self.assertEqual((ended.code, report["status"], report["stability"]), (3, "unstable", "unstable"), ended.err)
        self.assertIsNone(report["swing"]["period"])
        self.assertGreater(report["swing"]["tenfold_in"], 0)
        self.assertEqual(report["swing"]["furthest"], "rod node 1")
        change = report["swing"]["per_metre"]
        self.assertAlmostEqual(change["x"] ** 2 + change["y"] ** 2, 1, delta=1e-6)  # it falls over, to any side
        self.assertLess(change["z"], 1e-3)

    def test_of_a_negligible_part_of_the_gear_is_a_remark(self):
        heavy = """
[parts.other]
type = "rope/bar"
cells = 1
sketch = [[20, 0, 0], [20.05, 0.02, 2]]
length = 2
rope = { EA = 1e5, EA_compression = 1e5, diameter = 0.001, density = 1140 }
[parts.buoy]
type = "float/float"
on = "other.end"
float = { buoyancy = 100, diameter = 0.2, mass = MASS }
[[hold]]
on = "other.start"
"""
        topples = FLOAT.replace("[1.7, 0, 0]", "[0, 0, 0.2]").replace("[0.05, 0.02, 2]", "[0, 0, -2]")
        for mass, code, stability in (("20000", 0, "locally unstable"), ("200", 3, "unstable")):
            self.write(f"two-{mass}.toml", topples + heavy.replace("MASS", mass))
            ended = self.netloft("run", f"two-{mass}.toml", "--json", "--strategy", "direct", "--solver", "newton:method=classic")
            report = ended.json()
            self.assertEqual((ended.code, report["stability"]), (code, stability), report["reason"])
            self.assertEqual(report["swing"]["furthest"], "rod node 1")
            self.assertEqual(report["swing"]["share"] < 1e-3, code == 0)
            self.assertIn("with these nodes held, nothing grows" if code == 0 else "not a stable one", report["reason"])
            with h5py.File(self.folder / f"two-{mass}.hdf") as f:
                self.assertEqual(f["netloft/swing/share"][()], report["swing"]["share"])
                self.assertEqual(f["netloft/status"].attrs["stability"], stability)

    def test_a_gear_that_rests_has_none(self):
        self.write("float.toml", FLOAT.replace("1.7", "0.2"))
        self.assertIsNone(self.netloft("run", "float.toml", "--json").json()["swing"])
        with h5py.File(self.folder / "float.hdf") as f:
            self.assertNotIn("swing", f["netloft"])


class SeveralEquilibria(InFreshFolder):
    def solved(self, text, *words):
        self.write("arch.toml", text)
        ended = self.netloft("run", "arch.toml", *words)
        self.assertEqual(ended.code, 0, ended.err)
        return ended

    def test_numbers_have_their_least_and_largest_over_all_that_were_found(self):
        report = self.solved(ARCH, "--json").json()
        self.assertEqual(len(report["shapes"]["others"]), 1)
        self.assertEqual(report["shapes"]["chosen_by"], "least energy")
        self.assertEqual(report["results"]["middle"], report["spread"]["middle"]["least"])
        for name, size in ("middle", RISE), ("thrust", THRUST):
            self.assertAlmostEqual(report["spread"][name]["least"] / -size, 1, delta=1e-3)
            self.assertAlmostEqual(report["spread"][name]["largest"] / size, 1, delta=1e-3)

    def test_a_report_of_the_file_repeats_them(self):
        said = self.solved(ARCH).out
        self.assertIn("the answer is the one of least energy", said)
        table = [line for line in said.splitlines() if line.startswith("    middle")]
        self.assertEqual(len(table), 1)
        self.assertIn(table[0], self.netloft("report", "arch.hdf").out)
        again = self.netloft("report", "arch.hdf", "--json").json()["spread"]["middle"]
        self.assertAlmostEqual(again["largest"] / RISE, 1, delta=1e-3)
        with h5py.File(self.folder / "arch.hdf") as f:
            self.assertEqual(f["netloft/spread/largest/middle"][()], again["largest"])

    def test_one_equilibrium_has_no_spread(self):
        report = self.solved(changed(ARCH, ("restarts = 12", "restarts = 0")), "--json").json()
        self.assertIsNone(report["shapes"])
        self.assertIsNone(report["spread"])
        with h5py.File(self.folder / "arch.hdf") as f:
            self.assertNotIn("spread", f["netloft"])

    def test_a_shape_that_bending_holds_is_compared_with_that_from_the_drawing(self):
        self.write("stiff.toml", STIFF)
        energies = {}
        for strategy in ("auto", "auto:restarts=0", "direct"):
            report = self.netloft("run", "stiff.toml", "--json", "--overwrite", "--strategy", strategy).json()
            self.assertEqual(report["status"], "converged", report["reason"])
            energies[strategy] = report["energy"]
        self.assertGreater(energies["auto:restarts=0"], energies["direct"] + 0.05 * abs(energies["direct"]), "it is crumpled")
        self.assertLess(energies["auto"], energies["direct"] + 1e-9 * abs(energies["direct"]))

    def test_a_rope_that_only_bends_has_one_shape(self):
        self.write("rope.toml", ROPE)
        report = self.netloft("run", "rope.toml", "--json").json()
        self.assertEqual(report["status"], "converged", report["reason"])
        self.assertIsNone(report["shapes"], "tension makes its shape stable without bending")

    def test_where_a_force_has_no_energy_they_are_looked_for_on_demand_and_the_first_is_the_answer(self):
        flows = changed(ARCH, ("density = 0", "density = 1\ncurrent = [0.1, 0, 0]"))
        report = self.solved(flows, "--json").json()
        self.assertIsNone(report["shapes"])
        report = self.solved(changed(flows, ("restarts = 12", "restarts = 12\neverywhere = true")), "--json").json()
        self.assertEqual(report["shapes"]["chosen_by"], "found first")
        self.assertEqual(report["results"]["middle"], report["spread"]["middle"]["largest"])
        self.assertAlmostEqual(report["spread"]["middle"]["least"] / -RISE, 1, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
