# SPDX-License-Identifier: BSD-3-Clause
"""Studies: a manifest, items that any process may compute, one table. No item is lost or counted twice."""
import contextlib
import csv
import json
import os
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import GOOD, SOURCE, InFreshFolder, changed

FULL_DISK = os.environ.get("NETLOFT_FULL_DISK", "")
SCENE = changed(GOOD, ('lowest_z = { of = "net", take = "min z" }',
                       'lowest_z = { of = "net", take = "min z" }\npull = { of = "net.fore", take = "sum reaction z" }'))
STUDY = """\
scene = "scene.toml"
[variables.water]
key = "water.density"
values = [1000, 1010, 1020, 1030]
[variables.rope]
key = "parts.rope.rope.density"
values = ["2000 kg/m3", "3000 kg/m3", "4000 kg/m3"]
[variables.twine]
key = "parts.net.twine.EA"
range = ["8 kN", "12 kN"]
[design]
samples = 6
"""
ITEMS, POINTS = 6, 6 * 12


def state_of(pid):
    """T: stopped, Z and X: dead (proc_pid_stat)."""
    with open(f"/proc/{pid}/stat") as f:
        return f.read().rpartition(")")[2].split()[0]


class Studies(InFreshFolder):
    def setUp(self):
        super().setUp()
        self.write("scene.toml", SCENE)
        self.write("s.toml", STUDY)

    def study(self, *words, code=0, **how):
        ended = self.netloft("study", *words, **how)
        self.assertEqual(ended.code, code, f"{words}\n{ended.out}{ended.err}")
        return ended

    def make_table(self, folder="s.study"):
        self.study("collect", folder)
        return self.table(folder)

    def table(self, folder="s.study"):
        return [(self.folder / folder / name).read_bytes() for name in ("table.csv", "table.hdf")]

    def rows(self, folder="s.study"):
        with open(self.folder / folder / "table.csv", newline="") as f:
            return list(csv.DictReader(f))

    def records(self):
        return sorted((self.folder / "s.study" / "items").glob("*.json"))

    def whole_study(self):
        self.study("plan", "s.toml")
        self.study("run", "s.study")
        return self.make_table()


class ShippedStudies(Studies):
    """No item is computed here, because a path takes a quarter of a minute."""

    def test_studies_of_the_library_can_be_planned(self):
        found = sorted((SOURCE / "gear-library/studies").glob("*.toml"))
        self.assertGreater(len(found), 0)
        for path in found:
            with self.subTest(path.name):
                planned = self.study("plan", str(path), "-o", path.stem, "--json").json()
                self.assertGreater(planned["points"], planned["items"])


class WholeStudies(Studies):
    def test_a_study_is_planned_computed_and_collected(self):
        planned = self.study("plan", "s.toml", "--json").json()
        self.assertEqual((planned["items"], planned["points"], planned["computed_before"]), (ITEMS, POINTS, 0))
        lines = [json.loads(line) for line in (self.folder / "s.study/manifest.jsonl").read_text().splitlines()]
        self.assertEqual(len(lines), 1 + ITEMS)
        for key in ("id", "sample", "seed", "set", "points", "hash"):
            self.assertIn(key, lines[1])
        ran = self.study("run", "s.study", "--json").json()
        self.assertEqual(ran, {"items": ITEMS, "computed": ITEMS, "computed_before": 0, "failed": 0})
        self.assertEqual(self.study("run", "s.study", "--json").json()["computed"], 0)
        self.make_table()
        rows = self.rows()
        self.assertEqual(len(rows), POINTS)
        self.assertEqual({row["status"] for row in rows}, {"converged"})
        self.assertEqual(sum(row["start"] == "anew" for row in rows), ITEMS)
        self.assertEqual(len({(row["sample"], row["water"], row["rope [kg/m3]"]) for row in rows}), POINTS)

    def test_a_row_says_what_a_run_says(self):
        self.whole_study()
        manifest = [json.loads(line) for line in (self.folder / "s.study/manifest.jsonl").read_text().splitlines()]
        item, place = manifest[4], 7
        sets = [word for one in item["set"] + item["points"][place]["set"] for word in ("--set", one)]
        run = self.netloft("run", "scene.toml", *sets, "--json").json()
        row = self.rows()[(item["id"] - 1) * 12 + place]
        self.assertEqual(float(row["twine [kN]"]), item["values"][0][1])
        for name in ("lowest_z", "pull"):
            column = f"results/{name} [{run['units'][name]}]"
            self.assertAlmostEqual(float(row[column]) / run["results"][name], 1, delta=1e-8)

    def test_both_tables_say_the_same(self):
        self.whole_study()
        rows = self.rows()
        with h5py.File(self.folder / "s.study/table.hdf") as f:
            study = f["study"]
            self.assertEqual(study["figures/results/pull"].attrs["unit"], "N")
            np.testing.assert_array_equal(study["figures/results/pull"][:], [float(r["results/pull [N]"]) for r in rows])
            np.testing.assert_array_equal(study["variables/twine"][:], [float(r["twine [kN]"]) for r in rows])
            self.assertEqual([s.decode() for s in study["status"][:]], [r["status"] for r in rows])
            np.testing.assert_array_equal(study["cost/factorisations"][:], [int(r["factorisations"]) for r in rows])

    def test_continued_points_take_few_factorisations(self):
        self.whole_study()
        continued = [int(r["factorisations"]) for r in self.rows() if r["start"] == "continued"]
        self.assertEqual(len(continued), POINTS - ITEMS)
        self.assertLessEqual(np.mean(continued), 4)

    def test_the_same_file_makes_the_same_bits(self):
        tables = []
        for folder, jobs in (("a", "1"), ("b", "2")):
            self.study("plan", "s.toml", "-o", folder)
            self.study("run", folder, "--jobs", jobs)
            tables.append(self.make_table(folder))
        self.assertEqual(*((self.folder / folder / "manifest.jsonl").read_bytes() for folder in "ab"))
        self.assertEqual(*tables)

    def test_a_larger_study_goes_on_with_what_has_been_computed(self):
        self.write("s.toml", STUDY + 'sampling = "sobol"\n')
        before = self.whole_study()
        self.write("s.toml", "# more\n" + STUDY.replace("samples = 6", "samples = 8") + 'sampling = "sobol"\n')
        self.assertEqual(self.study("plan", "s.toml", "--json").json()["computed_before"], ITEMS)
        self.assertEqual(self.study("run", "s.study", "--json").json()["computed"], 2)
        after = self.make_table()
        self.assertTrue(after[0].startswith(before[0]))

    def test_parts_and_lists_are_varied_too(self):
        self.write("s.toml", """\
scene = "scene.toml"
figures = ["results/lowest_z"]
[variables.twine]
key = "parts.net.twine"
values = ["pe-braided-4mm", "pe-braided-3mm"]
[variables.cells]
key = "parts.net.cells"
values = [[4, 4], [4, 8]]
[design]
combine = "list"
""")
        self.whole_study()
        self.assertEqual([(r["twine"], r["cells"]) for r in self.rows()],
                         [("pe-braided-4mm", "[4, 4]"), ("pe-braided-3mm", "[4, 8]")])
        self.assertEqual([c for c in self.rows()[0] if "/" in c], ["results/lowest_z [m]"])


class ShownStudies(Studies):
    def setUp(self):
        super().setUp()
        self.whole = self.whole_study()

    def picture(self, *words):
        self.study("show", "s.study", "-o", "p.svg", *words)
        return (self.folder / "p.svg").read_text()

    def test_a_page_has_a_plot_of_every_figure_that_varies(self):
        self.assertIn("plots written to s.study/s.html", self.study("show", "s.study").out)
        page = (self.folder / "s.study/s.html").read_text()
        self.assertIn("results/pull [N]", page)
        self.assertNotIn("<script", page)

    def test_lines_are_medians_and_bands_have_nine_tenths_of_the_draws(self):
        svg = self.picture("--figure", "results/pull", "--over", "rope", "--by", "water")
        self.assertEqual(svg.count("<polyline"), 4)
        self.assertEqual(svg.count("fill-opacity"), 4)
        self.assertIn(">rope [kg/m3]<", svg)
        points = [[float(x) for x in pair.split(",")] for pair in svg.split("<polyline points=\"")[1].split("\"")[0].split()]
        rows = [r for r in self.rows() if r["water"] == "1000"]
        medians = [np.median([float(r["results/pull [N]"]) for r in rows if r["rope [kg/m3]"] == rope]) for rope in ("2000", "3000", "4000")]
        sampled = [(points[0][1] - p[1]) / (points[0][1] - points[2][1]) for p in points]
        for got, wanted in zip(sampled, medians):
            self.assertAlmostEqual(got, (wanted - medians[0]) / (medians[2] - medians[0]), delta=1e-3)

    def test_what_is_neither_axis_nor_line_is_held_and_said(self):
        svg = self.picture("--figure", "results/pull", "--over", "twine", "--by", "water", "--at", "rope=3000 kg/m3")
        self.assertIn(">at rope 3000 kg/m3<", svg)
        self.assertIn(">at rope 2000 kg/m3<", self.picture("--figure", "results/pull", "--over", "twine", "--by", "water"))

    def test_over_a_variable_that_is_drawn_there_are_markers_alone(self):
        svg = self.picture("--figure", "results/lowest_z", "--over", "twine")
        self.assertEqual(svg.count("<polyline"), 0)
        self.assertGreaterEqual(svg.count("<circle"), 6)

    def test_wrong_names_are_answered(self):
        for words, answer in ((["--figure", "results/pul"], 'did you mean "results/pull"?'), (["--over", "wter"], 'did you mean "water"?'),
                              (["--by", "twine"], "twine is sampled"), (["--at", "rope=1"], "rope is never 1 in the study; its values are 2000 kg/m3"),
                              (["--at", "rope"], "--at NAME=VALUE"), (["-o", "a.png"], ".svg or .html"), (["-o", "a.svg"], "name one with --figure"),
                              (["--over", "water", "--by", "water"], "water is the axis")):
            self.assertIn(answer, self.study("show", "s.study", *words, code=2).err, words)
        for record in self.records():
            record.unlink()
        self.assertIn("no point that would be drawn", self.study("show", "s.study", code=2).err)


class LostStudies(Studies):
    """After kills, full disks or damaged files, one command continues, and the table is that of an undisturbed study."""

    def setUp(self):
        super().setUp()
        self.whole = self.whole_study()
        for record in self.records():
            record.unlink()

    def assert_resumed(self):
        self.study("run", "s.study")
        self.assertEqual(self.make_table(), self.whole)
        self.assertEqual(len(self.records()), ITEMS)
        left = {p.suffix for p in (self.folder / "s.study/items").iterdir()}
        self.assertEqual(left, {".json"})

    def begin(self, *words):
        return subprocess.Popen(self.command("study", "run", "s.study", *words), cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def workers_of(self, engine):
        try:
            with open(f"/proc/{engine.pid}/task/{engine.pid}/children") as f:
                return [int(pid) for pid in f.read().split()]
        except OSError:
            return []

    def stopped_worker_of(self, engine):
        """A stopped worker, which goes on only when told to, so that its engine cannot end before; None if the engine has ended."""
        while engine.poll() is None:
            for pid in self.workers_of(engine):
                with contextlib.suppress(ProcessLookupError, FileNotFoundError):
                    os.kill(pid, signal.SIGSTOP)
                    while (state := state_of(pid)) not in "TZX":
                        time.sleep(0.001)
                    if state == "T":
                        return pid
        return None

    def begin_and_stop_a_worker(self, *words):
        while True:
            for record in self.records():
                record.unlink()
            engine = self.begin(*words)
            if pid := self.stopped_worker_of(engine):
                return engine, pid

    def test_killed_engines(self):
        for records in (0, 1, 3):
            engine = self.begin("--jobs", "2")
            while len(self.records()) < records and engine.poll() is None:
                time.sleep(0.001)
            engine.kill()
            engine.wait()
        self.assert_resumed()

    def test_killed_workers_harm_one_item_each_and_are_named(self):
        engine, pid = self.begin_and_stop_a_worker("--jobs", "1")
        killed = []
        while pid and len(killed) < 2:
            os.kill(pid, signal.SIGKILL)
            killed.append(pid)
            pid = self.stopped_worker_of(engine) if len(killed) < 2 else None
        self.assertEqual(engine.wait(), 1)
        self.assertEqual(self.study("collect", "s.study", code=1).err.count("was ended by signal 9"), len(killed))
        missing = [r for r in self.rows() if r["status"] == "missing"]
        self.assertEqual(len(missing), 12 * len(killed))
        self.assertIn("signal 9", missing[0]["reason"])
        self.assert_resumed()

    def test_an_interrupt_ends_workers_and_is_resumed(self):
        engine, pid = self.begin_and_stop_a_worker("--jobs", "2")
        engine.send_signal(signal.SIGTERM)
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGCONT)
        self.assertEqual(engine.wait(timeout=100), 130)
        self.assert_resumed()

    @unittest.skipUnless(FULL_DISK, "needs tests/support/full_disk")
    def test_full_disks(self):
        full = self.environment(LD_PRELOAD=FULL_DISK, NETLOFT_DISK_BYTES="2000")
        ended = self.study("run", "s.study", code=1, environment=full)
        self.assertIn("No space left", ended.err)
        self.assertEqual(self.records(), [])
        self.study("run", "s.study")
        before = self.table()
        self.study("collect", "s.study", code=1, environment=full)
        self.assertEqual(self.table(), before)
        self.assert_resumed()

    def test_garbage_of_a_bad_node(self):
        self.study("run", "s.study")
        records = self.records()
        records[0].write_bytes(b"")
        records[1].write_bytes(records[2].read_bytes())
        records[3].write_bytes(records[3].read_bytes()[:-40])
        records[4].write_bytes(os.urandom(5000))
        ended = self.study("collect", "s.study", code=1)
        self.assertEqual(ended.err.count("is missing"), 4)
        self.assertIn("it is the record of another item", ended.err)
        self.assertEqual(self.study("run", "s.study", "--json").json()["computed"], 4)
        self.assert_resumed()

    def test_clocks_that_differ(self):
        for year, record in enumerate(self.records()):
            os.utime(record, (86400 * 365 * year, 86400 * 365 * 40 * year))
        self.study("run", "s.study", "--items", "2-3")
        os.utime(self.folder / "s.study/manifest.jsonl", (4e9, 4e9))
        for record in self.records():
            os.utime(record, (0, 0))
        self.assert_resumed()

    def test_two_engines_and_two_collectors_at_a_time(self):
        engines = [self.begin("--jobs", "1") for _ in range(2)]
        while any(engine.poll() is None for engine in engines):
            collectors = [subprocess.Popen(self.command("study", "collect", "s.study"), cwd=self.folder,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(2)]
            self.assertTrue({c.wait() for c in collectors} <= {0, 1})
        self.assertEqual([engine.wait() for engine in engines], [0, 0])
        self.assert_resumed()

    def test_a_scene_that_changed_is_no_longer_the_one_of_the_study(self):
        self.write("scene.toml", SCENE + "# another\n")
        ended = self.study("run", "s.study", code=1)
        self.assertIn("scene.toml has changed since the study was planned; plan it again", ended.err)
        self.assertEqual(self.records(), [])

    def test_a_scene_that_changed_after_all_was_computed_is_said(self):
        self.study("run", "s.study")
        self.write("scene.toml", SCENE + "# another\n")
        self.assertIn("scene.toml has changed since the study was planned; plan it again", self.study("run", "s.study", code=1).err)
        self.assertIn("scene.toml has changed since the study was planned; the table shows the study as it was planned", self.study("collect", "s.study").err)


class WrongStudies(Studies):
    def errors(self, text):
        self.write("s.toml", text)
        ended = self.study("plan", "s.toml", code=2)
        self.assertFalse((self.folder / "s.study").exists())
        return ended.err

    def test_wrong_keys_are_located(self):
        for change, where, what in (
                (("water.density", "water.densty"), "s.toml:2:1", 'unknown key "densty" in water'),
                (("1030]", '"x"]'), "s.toml:2:1", "water.density"),
                (('"4000 kg/m3"', '"-4000 kg/m3"'), "s.toml:5:1", "is outside"),
                (("scene.toml", "scen.toml"), "s.toml:1:9", "scen.toml"),
                (('"12 kN"', '"12 kg"'), "s.toml:10:18", "is a mass"),
                (("samples = 6", "samples = -6"), "s.toml:12:11", "design.samples"),
                (("samples = 6", "samples = 6\ndrwas = 7"), "s.toml:13:1", 'unknown key "drwas"'),
                (("samples = 6", "samples = 1000000"), "s.toml", "points"),
                (("[variables.water]", 'figures = ["results/pul"]\n[variables.water]'), "s.toml:2:12", "results/pul")):
            said = self.errors(changed(STUDY, change))
            self.assertIn(where, said)
            self.assertIn(what, said)

    def test_errors_of_the_file_and_of_the_scene_are_said_at_once(self):
        said = self.errors("""\
scene = "scene.toml"
figures = ["results/pul"]
[variables.water]
key = "water.densty"
values = [1000, 1010]
[variables.rope]
key = "parts.rope.rope.density"
values = ["2000 kg/m3", "-4000 kg/m3"]
[variables.twine]
key = "parts.net.twine.EA"
range = ["8 kN", "12 kg"]
[design]
samples = -6
sed = 2
""")
        for answer in ("s.toml:2:12", 'did you mean "results/pull"?', "s.toml:3:1", 'unknown key "densty"', "s.toml:6:1", "is outside",
                       "s.toml:11:18", "is a mass", "s.toml:13:11", "design.samples", "s.toml:14:1", 'unknown key "sed"'):
            self.assertIn(answer, said)
        self.assertEqual(said.count(": error: "), 6, said)
        said = self.errors('scene = "scene.toml"\n[variables.water]\nkey = "water.densty"\nvalues = [1000, 1010]\n[design]\nsamples = 3\n')
        self.assertIn("there is no variable with a range to sample from", said)
        self.assertIn('unknown key "densty"', said)

    def test_an_empty_design_is_located(self):
        self.assertIn("s.toml:1:1", self.errors('scene = "scene.toml"\n'))
        self.assertIn("s.toml:2:1: error: variables: is empty", self.errors('scene = "scene.toml"\n[variables]\n'))

    def test_a_path_that_meets_no_equilibrium_is_rows_that_say_so(self):
        self.write("s.toml", 'scene = "scene.toml"\nset = ["analysis.max_iterations=2", "analysis.strategy=direct"]\n'
                             '[variables.water]\nkey = "water.density"\nvalues = [1000, 1010]\n')
        self.study("plan", "s.toml")
        self.study("run", "s.study")
        self.assertIn("2 not converged", self.study("collect", "s.study", code=3).out)
        self.assertEqual([r["status"] for r in self.rows()], ["not converged"] * 2)
        self.assertIn("iterations", self.rows()[0]["reason"])

    def test_items_that_are_not_there(self):
        self.study("plan", "s.toml")
        for items in ("0", "7", "3-99", "3-1", "x", "1-", ",", "1,,2", "-1"):
            self.study("run", "s.study", "--items", items, code=2)
        self.assertIn("plan STUDY.toml", self.study("run", "nowhere", code=2).err)
        (self.folder / "s.study/manifest.jsonl").write_text("nonsense\n")
        for action in ("run", "collect"):
            self.assertIn("manifest.jsonl:1: the manifest is damaged", self.study(action, "s.study", code=2).err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
