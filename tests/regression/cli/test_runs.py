# SPDX-License-Identifier: BSD-3-Clause
"""Correct use: the output of a run, its exit code, and the files that it writes."""
import json
import math
import os
import resource
import shutil
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import GOOD, SOURCE, InFreshFolder, changed

SCENES = SOURCE / "gear-library" / "scenes"
PANEL = SCENES / "dead-weight-panel.toml"
CODEND = SCENES / "verification/codend-with-catch.toml"
COARSE = ["--set", "parts.net.cells=[8,8]"]
STUCK = ["--set", "analysis.max_iterations=3"]


def points(file):
    with h5py.File(file) as f:
        return f["VTKHDF/Points"][: f["VTKHDF/NumberOfPoints"][0]]


def meshes_of_netting(file):
    """Area of all triangles in panel coordinates [meshes across times meshes along]."""
    with h5py.File(file) as f:
        U, V = (f["VTKHDF/CellData/panel_corners"][:, i::2] for i in (0, 1))
    areas = np.abs((U[:, 1] - U[:, 0]) * (V[:, 2] - V[:, 0]) - (U[:, 2] - U[:, 0]) * (V[:, 1] - V[:, 0])) / 2
    return areas[np.isfinite(areas)].sum()


def outcome(file):
    with h5py.File(file) as f:
        return dict(f["netloft/status"].attrs)


class Runs(InFreshFolder):
    def run_panel(self, *words, **how):
        return self.netloft("run", str(PANEL), *COARSE, *words, **how)

    def test_a_result_lies_in_the_working_folder_and_nothing_else(self):
        ended = self.run_panel()
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(list(self.files()), ["dead-weight-panel.hdf"])
        self.assertEqual(ended.err, "")
        self.assertIn("dead-weight-panel: converged, stable equilibrium", ended.out)
        self.assertIn("written to dead-weight-panel.hdf", ended.out)
        self.assertEqual(outcome(self.folder / "dead-weight-panel.hdf")["outcome"], "converged")

    def test_corners_of_triangles_say_where_on_their_panel_they_are(self):
        self.assertEqual(self.run_panel().code, 0)
        self.assertAlmostEqual(meshes_of_netting(self.folder / "dead-weight-panel.hdf"), 40 * 40)
        # A tube, whose left and right edges are joined: 100 meshes round and 100 along. In the last of its 48
        # rows every second triangle has two corners in the one node that closes the cod-end.
        self.netloft("run", str(CODEND), "--set", "analysis.max_iterations=1", "--solver", "newton", "-o", "tube.hdf")
        self.assertAlmostEqual(meshes_of_netting(self.folder / "tube.hdf"), 100 * 100 * (1 - 1 / 48 / 2))

    def test_a_search_begins_where_another_result_has_the_gear(self):
        self.assertEqual(self.run_panel("-o", "a.hdf").code, 0)
        again = self.run_panel("--start-from", "a.hdf", "-o", "b.hdf", "--json").json()
        self.assertLessEqual(again["factorisations"], 1)
        np.testing.assert_allclose(points(self.folder / "b.hdf"), points(self.folder / "a.hdf"), atol=1e-9)
        finer = ["--set", "parts.net.cells=[16,16]", "--json"]
        fresh = self.netloft("run", str(PANEL), *finer, "-o", "c.hdf").json()
        led = self.netloft("run", str(PANEL), *finer, "--start-from", "a.hdf", "-o", "d.hdf").json()
        self.assertLess(led["factorisations"], fresh["factorisations"])
        np.testing.assert_allclose(led["energy"], fresh["energy"], rtol=1e-9)

    def test_a_value_that_is_set_twice_is_the_last_one_which_is_said(self):
        ended = self.netloft("run", str(PANEL), "--set", "parts.net.cells=[8,8]", "--set", "parts.net.cells=[4,4]", "--json")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(ended.json()["nodes"], 25)
        self.assertIn("--set parts.net.cells=[4,4] replaces --set parts.net.cells=[8,8]", ended.err)

    def test_the_way_on_from_a_coarser_mesh_may_be_another_strategy_and_falls_back_on_the_solver(self):
        # auto calls tension/only for the scene itself; load-steps does nothing without a current.
        panel = [str(PANEL)]
        answers = {}
        for then in ("", "tension/only", "load-steps"):
            strategy = "coarse-to-fine:by=direct" + (f",then={then}" if then else "")
            ended = self.netloft("run", *panel, "--strategy", strategy, "--json")
            self.assertEqual(ended.code, 0, ended.err)
            answers[then] = json.loads(ended.out)
        solved = {then: [s["name"] for s in report["stages"] if s["factorisations"]] for then, report in answers.items()}
        self.assertIn("tension only", solved["tension/only"])
        self.assertNotIn("from a coarser mesh", solved["tension/only"])
        for then in ("", "load-steps"):
            self.assertIn("from a coarser mesh", solved[then])
        for report in answers.values():
            self.assertAlmostEqual(report["energy"], answers[""]["energy"], delta=1e-6 * abs(report["energy"]))
        # If twines resist compression as they do tension, none can be slack.
        stretched = str(PANEL.parent / "verification/stretched-panel.toml")
        stiff = self.netloft("run", stretched, "--strategy", "coarse-to-fine:by=direct,then=tension/only", "--json")
        stages = {s["name"]: s["factorisations"] for s in json.loads(stiff.out)["stages"]}
        self.assertEqual(stages["tension only"], 0)
        self.assertGreater(stages["from a coarser mesh"], 0)
        wrong = self.netloft("run", *panel, "--strategy", "coarse-to-fine:then=nowhere")
        self.assertNotEqual(wrong.code, 0)
        self.assertIn('there is no plugin "nowhere"', wrong.err + wrong.out)

    def test_a_coarser_mesh_that_is_not_solved_with_half_of_the_work_leaves_the_other_half(self):
        """On the coarser mesh, a motion would come to rest after three times as much work."""
        ended = self.netloft("run", str(PANEL), "--strategy", "coarse-to-fine:by=pseudo-time", "--set", "analysis.work=10", "--json")
        self.assertEqual(ended.code, 3, ended.err)
        report = json.loads(ended.out)
        motion = [stage for stage in report["stages"] if stage["name"] == "motion"]
        self.assertEqual(len(motion), 1)
        self.assertIn("budget of work was used up", motion[0]["reason"])
        self.assertAlmostEqual(motion[0]["work"], 5, delta=1)
        self.assertNotIn("budget of work", report["reason"])

    def test_a_search_begins_nowhere_else(self):
        self.assertEqual(self.run_panel("-o", "a.hdf").code, 0)
        self.write("b.hdf", "no result")
        for words, says in (((str(SCENES / "hanging-rope.toml"), "--start-from", "a.hdf"), "a.hdf has none of the parts of hanging-rope"),
                            ((str(PANEL), "--start-from", "b.hdf"), "b.hdf"), ((str(PANEL), "--start-from", "none.hdf"), "there is no such file"),
                            ((str(SCENES / "dynamics/hanging-panel.toml"), "--start-from", "a.hdf"), "is for equilibria")):
            ended = self.netloft("run", *words, "-o", "c.hdf")
            self.assertEqual(ended.code, 2, ended.err)
            self.assertIn(says, ended.err)
            self.assertFalse((self.folder / "c.hdf").exists())

    def test_stages_are_kept_before_the_result(self):
        self.assertEqual(self.run_panel("-o", "alone.hdf").code, 0)
        self.assertEqual(self.run_panel("--stages", "-o", "stages.hdf").code, 0)
        with h5py.File(self.folder / "stages.hdf") as f:
            names = [name.decode() for name in f["netloft/stages"]]
            self.assertEqual((names[0], names[-1]), ("start", "converged"))
            offsets, n = f["VTKHDF/Steps/PointOffsets"][:], f["VTKHDF/NumberOfPoints"][0]
            states = [f["VTKHDF/Points"][at : at + n] for at in offsets]
            moved = [f["VTKHDF/PointData/displacement"][at : at + n] for at in f["VTKHDF/Steps/PointDataOffsets/displacement"]]
        alone = points(self.folder / "alone.hdf")
        self.assertGreater(len(names), 2)
        np.testing.assert_array_equal(states[-1], alone)
        np.testing.assert_array_equal(moved[0], 0)
        np.testing.assert_allclose(states[-1] - moved[-1], states[0], atol=1e-12)
        self.assertGreater(abs(states[0] - alone).max(), 0.1)
        motion = self.netloft("run", str(SCENES / "dynamics/hanging-panel.toml"), "--stages", "-o", "motion.hdf")
        self.assertEqual(motion.code, 2)
        self.assertIn("--stages is for equilibria", motion.err)
        motion = self.netloft("run", str(SCENES / "dynamics/hanging-panel.toml"), "--error", "-o", "motion.hdf")
        self.assertEqual(motion.code, 2)
        self.assertIn("--error is for equilibria", motion.err)

    def test_sensitivities_are_those_of_the_command_and_change_nothing_else(self):
        scene = [str(SCENES / "hanging-rope.toml"), "--set", "parts.rope.cells=20"]
        alone = self.netloft("run", *scene, "-o", "a.hdf", "--json").json()
        found = self.netloft("run", *scene, "-o", "b.hdf", "--json", "--sensitivities").json()
        self.assertIsNone(alone["sensitivities"])
        self.assertEqual(alone["results"], found["results"])
        np.testing.assert_array_equal(points(self.folder / "a.hdf"), points(self.folder / "b.hdf"))
        all_of_them = self.netloft("sensitivity", *scene, "--json").json()
        names = [figure["name"] for figure in all_of_them["figures"]]
        derivatives = {number["path"]: dict(zip(names, number["per_unit"])) for number in all_of_them["numbers"] if "why_not" not in number}
        self.assertGreater(len(found["sensitivities"]["rows"]), 3)
        for row in found["sensitivities"]["rows"]:
            self.assertEqual(row["derivative"], derivatives[row["path"]][row["figure"]])

    def test_sensitivities_of_a_result_are_those_of_its_scene(self):
        scene = self.folder / "rope.toml"
        scene.write_text((SCENES / "hanging-rope.toml").read_text())
        words = ["--set", "parts.rope.cells=20"]
        self.netloft("run", str(scene), *words, "-o", "a.hdf")
        of_scene = self.netloft("sensitivity", str(scene), *words, "--json").json()
        scene.write_text("nothing = [that is a scene")  # the result contains all that is needed
        ended = self.netloft("sensitivity", "a.hdf", "--json")
        self.assertEqual(ended.err, "")
        of_result = ended.json()
        self.assertEqual([n["path"] for n in of_scene["numbers"]], [n["path"] for n in of_result["numbers"]])
        for here, there in zip(of_scene["numbers"], of_result["numbers"]):
            np.testing.assert_allclose(here.get("per_unit", []), there.get("per_unit", []), rtol=1e-6, atol=1e-9)
        heavier = self.netloft("sensitivity", "a.hdf", "--set", "parts.rope.rope.density=400", "--to", "parts.rope", "--json")
        self.assertRegex(heavier.err, r"the equilibrium is up to [\d.]+ m from the shape in a\.hdf")
        by_density = next(n for n in heavier.json()["numbers"] if n["path"].endswith("density"))
        self.assertEqual(by_density["value"], 400)

    def test_sensitivities_of_a_result_need_the_files_that_it_was_made_of(self):
        scene = self.folder / "scene.toml"
        catalogue = self.folder / "mine" / "chains.toml"
        catalogue.parent.mkdir()
        catalogue.write_text('source = "a test"\nuncertainty = "none"\n[chain.thin]\ndiameter = "10 mm"\nmass = "2.1 kg/m"\n'
                             'material_density = "7850 kg/m3"\nEA = "8 MN"\n')
        scene.write_text('catalogue = ["mine"]\n[parts.line]\ntype = "rope/bar"\nlength = "10 m"\ncells = 4\nrope = "thin"\n'
                         'sketch = [[0, 0, 0], [9, 0, 0]]\n[[hold]]\non = "line.start"\n[[hold]]\non = "line.end"\n')
        self.assertEqual(self.netloft("run", "scene.toml", "-o", "a.hdf").code, 0)
        self.assertEqual(self.netloft("sensitivity", "a.hdf").code, 0)
        catalogue.write_text(catalogue.read_text().replace("2.1", "2.2"))
        ended = self.netloft("sensitivity", "a.hdf")
        self.assertEqual(ended.code, 2)
        self.assertIn("mine/chains.toml has changed since the result was written", ended.err)

    def test_sensitivities_need_an_equilibrium(self):
        for scene, words in (("dynamics/hanging-panel.toml", ()), ("pelagic-with-doors.toml", ("--set", "ship.warp.tension=6 kN"))):
            ended = self.netloft("run", str(SCENES / scene), *words, "--sensitivities", "-o", "none.hdf")
            self.assertEqual(ended.code, 2)
            self.assertRegex(ended.err, "--sensitivities: derivatives (are those of an equilibrium|change one number of the scene)")
            self.assertFalse((self.folder / "none.hdf").exists())
        ended = self.run_panel("--sensitivities", "--set", "analysis.max_iterations=2", "-o", "open.hdf")
        self.assertEqual(ended.code, 3)
        self.assertIn("there are no derivatives, because the scene ended not converged: ", ended.out)

    def test_json_says_what_a_script_needs(self):
        ended = self.run_panel("--json")
        report = ended.json()
        for key in ("status", "reason", "iterations", "factorisations", "residual", "energy", "wall_seconds", "unknowns",
                    "plan", "output", "results"):
            self.assertIn(key, report)
        self.assertEqual(report["status"], "converged")
        self.assertEqual(report["unknowns"], 3 * (81 - 9))
        self.assertEqual(report["output"], "dead-weight-panel.hdf")
        self.assertEqual(ended.err, "")
        phases = report["wall_seconds"]
        for phase in ("reading", "setup", "assembly", "analysis", "factorisation", "solve", "solver_total", "total"):
            self.assertGreaterEqual(phases[phase], 0)
        self.assertLessEqual(phases["solver_total"], phases["total"])
        self.assertRegex(report["plan"], r"priour/triangle: [^:]*\n(  .*\n)*  weight +on ")

    def test_json_and_file_agree(self):
        report = self.run_panel("--json").json()
        with h5py.File(self.folder / report["output"]) as f:
            for name, value in report["results"].items():
                self.assertEqual(f["netloft/scalars"][name][()], value)
            self.assertEqual(points(self.folder / report["output"])[:, 2].min(), report["results"]["lowest_z"])

    def test_forces_of_holds_carry_the_weight_even_where_holds_overlap(self):
        self.write("scene.toml", changed(GOOD, ('on = "net.fore"', 'on = "net.fore"\n[[hold]]\non = "net.left"\naxes = "yz"')))
        report = self.netloft("run", "scene.toml", "--json").json()
        held = sum(np.array(h["force"]) for h in report["hold_forces"])
        forces = sum(np.array(p["force"]) for p in report["part_forces"])
        scale = np.abs(forces).max()
        self.assertGreater(scale, 1)
        np.testing.assert_allclose(held + forces, 0, atol=1e-6 * scale)

    def test_output_option_and_backup(self):
        first = self.run_panel("-o", "a.hdf")
        self.assertEqual(first.code, 0, first.err)
        before = points(self.folder / "a.hdf")
        self.assertEqual(self.run_panel("-o", "a.hdf", "--set", "water.gravity=5").code, 0)
        self.assertEqual(sorted(self.files()), ["a.hdf", "a.hdf~"])
        np.testing.assert_array_equal(points(self.folder / "a.hdf~"), before)
        self.assertFalse(np.array_equal(points(self.folder / "a.hdf"), before))

    def test_not_converged(self):
        ended = self.run_panel("--json", *STUCK)
        self.assertEqual(ended.code, 3)
        report = ended.json()
        self.assertEqual(report["status"], "not converged")
        self.assertIn("the limit of 3 iterations was reached", report["reason"])
        self.assertTrue(report["at_fault"].startswith("net"), report["at_fault"])
        status = outcome(self.folder / "dead-weight-panel.hdf")
        self.assertEqual(status["outcome"], "not converged")
        self.assertEqual(status["sentence"], report["reason"])
        self.assertEqual(list(self.files()), ["dead-weight-panel.hdf"])
        spoken = self.run_panel(*STUCK)
        self.assertIn("not converged", spoken.out)
        self.assertIn("net node", spoken.out)

    def test_interrupted(self):
        words = ["run", str(PANEL), "--json", "--set", "parts.net.cells=[200,200]", "--set", "analysis.tolerance=1e-16"]
        process = subprocess.Popen(self.command(*words), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, env=self.environment())
        part = self.folder / "dead-weight-panel.hdf.part"
        begun = time.monotonic()
        while not part.exists() and time.monotonic() - begun < 60:
            time.sleep(0.02)
        line = process.stderr.readline().decode()  # the first sign of life, after a second
        event = json.loads(line)
        self.assertEqual((event["event"], event["stage"]), ("progress", 1))
        self.assertIn("left", event)
        self.assertGreater(event["residual"], event["wanted"])
        self.assertGreaterEqual(event["seconds"], 1)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        report = json.loads(out)
        self.assertEqual(report["status"], "interrupted")
        self.assertEqual(list(self.files()), ["dead-weight-panel.hdf"])
        file = self.folder / "dead-weight-panel.hdf"
        self.assertEqual(outcome(file)["outcome"], "interrupted")
        self.assertEqual(points(file).shape, (201 * 201, 3))
        self.assertTrue(np.isfinite(points(file)).all())

    def test_a_log_gets_a_line_of_progress(self):
        words = ["run", str(PANEL), "--set", "parts.net.cells=[200,200]", "--set", "analysis.tolerance=1e-16"]
        process = subprocess.Popen(self.command(*words), cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, env=self.environment())
        line = process.stderr.readline().decode()
        process.kill()
        process.communicate()
        self.assertRegex(line, r"^progress iteration=\d+ residual=[-+.e\d]+ wanted=[-+.e\d]+ stage=1 seconds=[1-9]")

    def test_a_short_run_says_nothing_on_standard_error(self):
        self.assertEqual(self.run_panel().err, "")

    def test_solver_parameters_from_the_command_line(self):
        plain, classic = self.run_panel("--json").json(), self.run_panel("--json", "--solver", "newton:method=classic").json()
        self.assertNotEqual(plain["iterations"], classic["iterations"])
        same = self.run_panel("--json", "--set", "analysis.newton.method=classic").json()
        self.assertEqual(same["iterations"], classic["iterations"])

    def test_set_takes_units_without_quotes(self):
        one = self.run_panel("--json", "--set", "parts.net.panel.bar=600 mm").json()
        self.assertEqual(one["results"], self.run_panel("--json").json()["results"])

    def test_threads_change_no_bit(self):
        for threads in ("1", "2"):
            ended = self.netloft("run", str(PANEL), "--threads", threads, "-o", threads + ".hdf")
            self.assertEqual(ended.code, 0, ended.err)
        one, two = (points(self.folder / f"{n}.hdf") for n in "12")
        self.assertEqual(one.tobytes(), two.tobytes())

    def test_three_files_give_the_bits_of_one(self):
        single = self.netloft("run", str(PANEL), "-o", "single.hdf")
        self.assertEqual(single.code, 0, single.err)
        three = self.netloft("run", str(SCENES / "dead-weight-panel" / "analysis.toml"), "-o", "three.hdf")
        self.assertEqual(three.code, 0, three.err)
        self.assertEqual(points(self.folder / "single.hdf").tobytes(), points(self.folder / "three.hdf").tobytes())
        with h5py.File(self.folder / "three.hdf") as f:
            read = [name.decode().rsplit("/", 1)[-1] for name in f["netloft/provenance/files/path"]]
        self.assertEqual(sorted(read), ["analysis.toml", "geometry.toml", "properties.toml"])

    def test_names_with_spaces_and_accents(self):
        name = "Schleppnetz größer 2.toml"
        self.write(name, GOOD)
        ended = self.netloft("run", name, "--json")
        self.assertEqual(ended.code, 0, ended.err)
        self.assertEqual(ended.json()["output"], "Schleppnetz größer 2.hdf")
        self.assertTrue((self.folder / "Schleppnetz größer 2.hdf").exists())

    def test_a_held_edge_is_where_its_hold_puts_it(self):
        self.write("scene.toml", changed(GOOD, ('on = "net.fore"', 'on = "net.fore"\nat = [[-1, 0, 0], ["1 m", 0, "50 cm"]]')))
        self.assertEqual(self.netloft("run", "scene.toml").code, 0)
        expected = np.column_stack([np.linspace(-1, 1, 5), np.zeros(5), np.linspace(0, 0.5, 5)])
        np.testing.assert_allclose(points(self.folder / "scene.hdf")[:5], expected, atol=1e-15)


class WhereTheResultCannotGo(InFreshFolder):
    def check(self, output, says, **how):
        shutil.copy(PANEL, self.folder / "scene.toml")
        before = self.files()
        ended = self.netloft("run", "scene.toml", "-o", output, "--json", **how)
        self.assertIn(ended.code, (1, 2))
        self.assertIn(says, ended.err)
        self.assertIn("status", ended.json())
        self.assertNotIn("iterations", ended.json(), "it was solved before")
        return before

    def test_missing_folder(self):
        before = self.check("nowhere/a.hdf", "the folder nowhere does not exist")
        self.assertEqual(self.files(), before)

    def test_a_folder(self):
        self.check(".", "is a folder")

    def test_a_pipe(self):
        os.mkfifo(self.folder / "a.hdf")
        self.check("a.hdf", "not a file that a result may replace")
        self.assertFalse((self.folder / "a.hdf").is_file())

    def test_folder_where_nothing_can_be_made(self):
        self.check("/proc/a.hdf", "cannot write /proc/a.hdf.part")

    @unittest.skipIf(os.geteuid() == 0, "permissions do not hold root back")
    def test_folder_without_permission(self):
        (self.folder / "mine").mkdir(mode=0o500)
        self.check("mine/a.hdf", "Permission denied")

    def test_full_disk(self):
        """With a limit on the size of files, writes fail at the same place as on a full disk."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (16384, 16384))

        shutil.copy(PANEL, self.folder / "scene.toml")
        ended = self.netloft("run", "scene.toml", "-o", "a.hdf", preexec_fn=limit)
        self.assertEqual(ended.code, 1, ended.err)
        self.assertIn("cannot write", ended.err)
        self.assertNotIn("a.hdf", self.files())


class OtherCommands(InFreshFolder):
    def test_version(self):
        ended = self.netloft("--version")
        self.assertEqual(ended.code, 0)
        self.assertRegex(ended.out, r"^netloft \d+\.\d+\.\d+\n$")

    def test_help(self):
        for words in (["--help"], ["run", "--help"]):
            ended = self.netloft(*words)
            self.assertEqual((ended.code, ended.err), (0, ""))
        self.assertIn("--solver", ended.out)

    def test_no_command(self):
        ended = self.netloft()
        self.assertEqual((ended.code, ended.err), (0, ""))
        self.assertEqual(ended.out, self.netloft("--help").out)

    def test_plan_gives_reasons_and_writes_nothing(self):
        ended = self.netloft("plan", str(PANEL))
        self.assertEqual((ended.code, ended.err, self.files()), (0, "", {}))
        for words in ("priour/triangle: 2048 elements", "not loaded:", "3168 unknowns", "symmetric", "factorisation: ", "threads: "):
            self.assertIn(words, ended.out)
        self.assertRegex(ended.out, r"memory: about \S+ GiB, \S+ GiB of it for the factorised matrix; .* available\n$")
        plan = self.netloft("plan", str(PANEL), "--json").json()
        self.assertEqual(plan["unknowns"], 3168)
        self.assertGreater(plan["memory"]["foreseen"], plan["memory"]["factor"] + plan["memory"]["stability"])
        self.assertGreater(plan["memory"]["factor"], 8 * 3168 * 30)  # of a square of 32 by 32 cells: more than 30 numbers a column
        self.assertTrue(all(term["reason"] for family in plan["families"] for term in family["terms"]))

    def test_plan_says_whether_the_ground_passes(self):
        towed = str(SOURCE / "gear-library" / "scenes" / "verification" / "towed-chain.toml")
        passes = self.netloft("plan", towed)
        self.assertEqual(passes.err, "")
        self.assertIn("ground: passes the gear with (1.5, 0) m/s; its friction is that of sliding", passes.out)
        self.assertIn("ground: is at rest", self.netloft("plan", towed, "--set", "tow.speed=0").out)

    def test_what_has_no_effect_gets_a_warning(self):
        rope = 'rope = { diameter = "20 mm", EA = "100 kN", EA_compression = 0, density = 1150'
        self.write("scene.toml", GOOD.replace(rope + " }", rope + ', damping = 5, sag = 1 }\ndrag = "hydro/morison"'))
        said = self.netloft("plan", "scene.toml")
        self.assertEqual(said.code, 0)
        self.assertIn("scene.toml:12:1: warning: rope: rope.damping has no effect: the analysis is static", said.err)
        self.assertIn('scene.toml:12:1: warning: rope: drag = "hydro/morison" has no effect: no water flows past it', said.err)
        self.assertNotIn("sag", said.err)
        self.assertIn("rope.sag has no effect: the scene has no gravity", self.netloft("plan", "scene.toml", "--set", "water.gravity=0").err)
        self.assertNotIn("drag", self.netloft("plan", "scene.toml", "--set", "water.current=[1, 0, 0]").err)
        moving = ["--set", "analysis.kind=dynamic", "--set", "analysis.solver=chord", "--set", "analysis.duration=1"]
        self.assertEqual(self.netloft("plan", "scene.toml", *moving).err, "")

    def test_friction_in_water_that_flows_over_a_ground_of_which_nothing_is_said_gets_a_warning(self):
        text = (SOURCE / "gear-library" / "scenes" / "verification" / "towed-chain.toml").read_text()
        self.write("scene.toml", text.replace('[tow]\nspeed = "1.5 m/s"\n', "").replace("[water]", "[water]\ncurrent = [1.5, 0, 0]"))
        plan = self.netloft("plan", "scene.toml")
        self.assertEqual(plan.code, 0)
        self.assertIn("bed: water flows past the gear, but the ground is at rest", plan.err)
        self.assertIn("[tow] speed", plan.err)
        said = self.netloft("plan", "scene.toml", "--set", "tow.speed=0")
        self.assertEqual((said.code, said.err), (0, ""))

    def test_what_is_where_nobody_means_it_gets_a_warning(self):
        gear = 'include = ["' + str(SOURCE / "gear-library/scenes/four-panel.toml") + '"]\n[gear]\nnodes = 200\n'
        self.write("air.toml", gear + '[points.door]\nat = ["0 m", "5 m", "30 m"]\n')
        self.assertRegex(self.netloft("run", "air.toml").out, r"warning: \S+ and \d+ more parts lie up to 3\d\.?\d* m above the surface, z = 0")
        self.write("sunk.toml", gear + '[bed]\ndepth = "3 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n')
        self.assertRegex(self.netloft("run", "sunk.toml").out, r"warning: upper-bridle and \d+ more parts lie up to 27 m below the bed")
        self.write("flies.toml", gear + '[bed]\ndepth = "60 m"\n[elements.contact]\nseabed = { stiffness = "10 kN/m2" }\n')
        self.assertRegex(self.netloft("run", "flies.toml").out, r"warning: nothing rests on the bed: \S+, the lowest part that could, is 2\d\.?\d* m above the bed")
        self.write("rope.toml", 'include = ["' + str(SOURCE / "gear-library/scenes/hanging-rope.toml") + '"]\n[parts.rope]\nlength = "0.1 m"\n')
        self.assertRegex(self.netloft("run", "rope.toml").out, r"warning: rope is stretched by \S+ %, at which ropes and twines of nets break")
        self.write("rests.toml", gear)
        self.assertNotIn("warning", self.netloft("run", "rests.toml").out)

    def test_a_current_that_nobody_means_gets_a_warning(self):
        rope = (SOURCE / "gear-library" / "scenes" / "hanging-rope.toml").as_posix()
        for current, words in [('{ z = ["0 m", "100 m"], x = [1.2, 0.4] }', "lies above the gear .* so that only its lowest value acts"),
                               ('{ z = ["-500 m", "-100 m"], x = [1.2, 0.4] }', "lies below the gear .* so that only its highest value acts"),
                               ('[1.5, 0, 0]\n[tow]\nspeed = 1.5', "repeats the speed of the tow, so that the water passes the gear at 3 m/s"),
                               ('{ z = ["0 m", "-100 m"], x = [1.2, 0.4] }', None), ('[0.5, 0, 0]\n[tow]\nspeed = 1.5', None)]:
            with self.subTest(current=current):
                self.write("scene.toml", f'include = ["{rope}"]\n[water]\ncurrent = {current}\n')
                said = self.netloft("plan", "scene.toml").err
                self.assertRegex(said, words) if words else self.assertNotIn("water.current", said)

    def test_friction_on_ground_at_rest_gets_a_warning_in_water_that_flows(self):
        self.write("scene.toml", """
[water]
density = 1025
[bed]
depth = "10 m"
[parts.rope]
type = "rope/bar"
length = "20 m"
cells = 10
sketch = [[0, 0, -10], [20, 0, -10]]
rope = { diameter = "20 mm", EA = "100 kN", density = 3000 }
[parts.ground]
type = "seabed/bed"
on = "rope"
seabed = { friction = 0.5 }
[[hold]]
on = "rope.start"
""")
        flows = ["--set", "water.current=[1, 0, 0]"]
        said = "ground: water flows past the gear, but the ground is at rest"
        self.assertIn(said, self.netloft("plan", "scene.toml", *flows).err)
        for none in ([], ["--set", "tow.speed=1"], [*flows, "--set", "tow.speed=0"], [*flows, "--set", "parts.ground.seabed.friction=0"]):
            self.assertNotIn("friction", self.netloft("plan", "scene.toml", *none).err)

    def test_plan_finds_the_errors_that_a_run_finds(self):
        self.write("scene.toml", changed(GOOD, ("[water]", "[watre]")))
        plan, run = (self.netloft(command, "scene.toml") for command in ("plan", "run"))
        self.assertEqual((plan.code, plan.err), (2, run.err))

    def test_list(self):
        ended = self.netloft("list")
        self.assertEqual((ended.code, ended.err), (0, ""))
        for name in ("newton/newton", "priour/triangle", "rope/bar"):
            self.assertIn(name, ended.out)
        types = [c["type"] for c in self.netloft("list", "--json").json()["components"]]
        self.assertIn("rope/bar", types)

    def test_describe(self):
        for name in ("rope/bar", "priour/triangle"):
            text, row = self.netloft("describe", name).out, self.netloft("describe", name, "--json").json()
            for parameter in row["parameters"]:
                self.assertIn(parameter["name"], text)
                self.assertTrue(parameter["doc"] and parameter["unit"])
        self.assertIn("damping", self.netloft("describe", "newton").out)
        for table in ("water", "analysis"):
            self.assertEqual(self.netloft("describe", table, "--json").json()["type"], table)

    def test_shared_unknowns_are_named(self):
        doc = "meshes along the netting that the catch fills, from its aft end"
        self.assertIn(doc, self.netloft("describe", "catch/pressure").out)
        front = self.netloft("describe", "catch/pressure", "--json").json()["globals"]
        self.assertEqual(front, [{"name": "front", "unit": "1", "needs": "catch.volume", "doc": doc}])
        for filled, named in (("volume=7.5", ["front"]), ("meshes=50", [])):
            words = ("plan", str(CODEND), "--set", "parts.catch.catch={pressure=1614," + filled + "}")
            families = self.netloft(*words, "--json").json()["families"]
            self.assertEqual([g["name"] for f in families for g in f["globals"] if g["part"] == "catch"], named)
            self.assertEqual(doc in self.netloft(*words).out, bool(named))

    def test_describe_what_is_not_there(self):
        ended = self.netloft("describe", "rope/bra")
        self.assertEqual((ended.code, ended.out), (4, ""))
        self.assertIn("rope/bar", ended.err)

    def test_colour(self):
        self.write("scene.toml", "[watre]\n")
        for words, environment, colour in (([], {}, False), (["--color", "always"], {}, True),
                                           (["--color", "always"], {"NO_COLOR": "1"}, True),
                                           (["--color", "never"], {}, False), (["--color", "auto"], {"NO_COLOR": "1"}, False)):
            ended = self.netloft("run", "scene.toml", *words, environment=self.environment(TERM="xterm", **environment))
            self.assertEqual("\033[" in ended.err, colour, (words, environment))

    def on_a_terminal(self, environment):
        """The text on standard error if it is a terminal."""
        ours, theirs = os.openpty()
        process = subprocess.run(self.command("run", "scene.toml"), cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs,
                                 env=self.environment(TERM="xterm", **environment), timeout=60)
        shown = os.read(ours, 65536).decode()
        os.close(theirs)
        os.close(ours)
        return process.returncode, shown

    def test_colour_on_a_terminal(self):
        self.write("scene.toml", "[watre]\n")
        code, shown = self.on_a_terminal({})
        self.assertEqual(code, 2)
        self.assertIn("\033[", shown)
        self.assertNotIn("\033[", self.on_a_terminal({"NO_COLOR": "1"})[1])

    def test_a_closed_pipe_is_no_crash(self):
        process = subprocess.Popen(self.command("schema"), cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=self.environment())
        process.stdout.close()
        process.stderr.read()
        process.stderr.close()
        self.assertIn(process.wait(timeout=60), (0, 1, -signal.SIGPIPE))


class TurnedNetting(InFreshFolder):
    """A frame of 4 x 4 meshes of 1 m bars at half angle 0.4 whose twines are unstretched, and a taut rope that is free in its middle."""
    FRAME = """\
[water]
gravity = 0
[parts.net]
type = "priour/triangle"
panel = { across = 4, along = 4, bar = 1, netting = "NETTING" }
cells = [1, 1]
sketch = [[0, 0, 0], [WIDTH, 0, 0], [WIDTH, 0, -HEIGHT], [0, 0, -HEIGHT]]
twine = { diameter = 0.01, EA = 1e4, density = 1025, opening_stiffness = 1 }
[parts.rope]
type = "rope/bar"
length = 1
cells = 2
sketch = [[0, 0, 0], [0, 1.1, 0]]
rope = { diameter = 0.01, EA = 10, density = 1025 }
[[join]]
points = ["net.fore-left", "rope.start"]
[[hold]]
on = "net"
[[hold]]
on = "rope.end"
"""

    def energy(self, netting, stiffness="1"):
        frame = self.FRAME.replace("NETTING", netting).replace("WIDTH", str(8 * math.sin(0.4))).replace("HEIGHT", str(8 * math.cos(0.4)))
        self.write("frame.toml", frame.replace("opening_stiffness = 1", f"opening_stiffness = {stiffness}"))
        run = self.netloft("run", "frame.toml", "--json", "--overwrite")
        self.assertEqual(run.code, 0, run.err)
        return run.json()["energy"], run.err

    def test_meshes_that_resist_opening_feel_that_they_are_turned(self):
        """H (angle from the run of the knots)^2 at each of 2 x 4 x 4 knots: 0.4 along the netting, pi/2 - 0.4 across."""
        diamond, t90 = self.energy("diamond")[0], self.energy("t90")[0]
        self.assertAlmostEqual(t90 - diamond, 32 * ((math.pi / 2 - 0.4) ** 2 - 0.4 ** 2), delta=1e-9)
        self.assertAlmostEqual(diamond - self.energy("diamond", "0")[0], 32 * 0.4 ** 2, delta=1e-9)

    def test_meshes_that_resist_nothing_get_a_warning(self):
        energy, said = self.energy("t90", "0")
        self.assertIn("frame.toml:5:53: warning: net: t90 netting whose meshes resist no opening hangs as diamond netting does", said)
        self.assertEqual(energy, self.energy("diamond", "0")[0])
        self.assertEqual(self.energy("t90")[1], "")


if __name__ == "__main__":
    unittest.main()
