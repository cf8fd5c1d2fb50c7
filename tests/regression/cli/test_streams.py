# SPDX-License-Identifier: BSD-3-Clause
"""Streams, signals, and pipes or folders instead of files: each gives a message and an exit code, and nothing blocks."""
import os
import resource
import signal
import subprocess
import time
import unittest

import h5py

from program import PROGRAM, SOURCE, InFreshFolder

SCENES = SOURCE / "gear-library" / "scenes"
PANEL = [str(SCENES / "dead-weight-panel.toml"), "--set", "parts.net.cells=[8,8]"]
MOTION = [str(SCENES / "dynamics" / "released-rope.toml"), "--set", "analysis.output_interval=0.02"]


class Streams(InFreshFolder):
    def into(self, stream, *words):
        return subprocess.run(self.command(*words), cwd=self.folder, stdout=stream, stderr=subprocess.PIPE, timeout=120,
                              env=self.environment(), check=False)

    def test_standard_output_that_cannot_be_written_is_an_error(self):
        commands = (["schema"], ["describe", "rope/bar"], ["list"], ["run", *PANEL, "--json"], ["--help"])
        with open("/dev/full", "w", encoding="utf-8") as full:
            for words in commands:
                with self.subTest(command=words[0]):
                    ended = self.into(full, *words)
                    self.assertEqual(ended.returncode, 1)
                    self.assertIn(b"standard output cannot be written: No space left on device", ended.stderr)

    def test_a_closed_standard_output_does_not_end_up_in_the_result(self):
        ended = subprocess.run(["sh", "-c", 'exec "$@" >&-', "sh", *self.command("run", *PANEL, "-o", "p.hdf")],
                               cwd=self.folder, stderr=subprocess.PIPE, timeout=120, env=self.environment(), check=False)
        self.assertEqual(ended.returncode, 1)
        self.assertIn(b"standard output cannot be written", ended.stderr)
        with h5py.File(self.folder / "p.hdf") as f:
            self.assertEqual(f["netloft/status"].attrs["outcome"], "converged")
        self.assertNotIn(b"written to p.hdf", (self.folder / "p.hdf").read_bytes())

    def test_a_pipe_as_input_is_refused(self):
        for name in ("pipe.toml", "pipe.hdf", "pipe.so"):
            os.mkfifo(self.folder / name)
        (self.folder / "pipe.study").mkdir()
        os.mkfifo(self.folder / "pipe.study" / "manifest.jsonl")
        for words in (["run", "pipe.toml"], ["check", "pipe.toml"], ["draw", "pipe.toml"], ["diff", "pipe.hdf", "pipe.hdf"],
                      ["test", "./pipe.so"], ["study", "plan", "pipe.toml"], ["study", "run", "pipe.study"],
                      ["study", "collect", "pipe.study"], ["hard_cases", "pipe.toml"], ["import", "femnet", "pipe.toml"]):
            with self.subTest(command=words):
                ended = self.netloft(*words)
                self.assertIn(ended.code, (2, 4))
                self.assertRegex(ended.err, r"pipe\.(toml|hdf|so|study/manifest.jsonl):? (it )?is |there is no such file|holds no suite")


class Signals(InFreshFolder):
    def run_and_send(self, number, before, *more):
        """The exit code and the output of a motion that gets a signal; `before` has set how it handles the signal."""
        name = f"{number.name}.hdf"
        run = subprocess.Popen(self.command("run", *MOTION, *more, "-o", name), cwd=self.folder, env=self.environment(),
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(number, before))
        while run.poll() is None and not (self.folder / f"{name}.part").exists():
            time.sleep(0.01)
        run.send_signal(number)
        out, _ = run.communicate(timeout=60)
        return run.returncode, out

    def test_a_hangup_and_a_quit_are_interrupts(self):
        for number in (signal.SIGHUP, signal.SIGQUIT):
            with self.subTest(signal=number.name):
                # A motion that takes longer than the signal needs to arrive on any machine.
                code, out = self.run_and_send(number, signal.SIG_DFL, "--set", "analysis.duration=1000")
                self.assertEqual(code, 130)
                self.assertIn(b"--resume goes on from there", out)

    def test_a_hangup_that_nohup_ignores_is_none(self):
        code, out = self.run_and_send(signal.SIGHUP, signal.SIG_IGN)
        self.assertEqual(code, 0, out)

    def test_a_limit_on_the_size_of_files_is_an_error(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))
        ended = self.netloft("run", *PANEL, "-o", "p.hdf", preexec_fn=limit)
        self.assertEqual(ended.code, 1)
        self.assertIn("cannot write p.hdf.part", ended.err)
        self.assertIn("File too large", ended.err)
        self.assertEqual(self.files(), {})


    @unittest.skipIf("asan" in PROGRAM, "its shadow wants terabytes of addresses")
    def test_a_limit_on_memory_is_an_error_and_no_endless_wait(self):
        for kilobytes in (100000, 150000, 200000):
            with self.subTest(kilobytes=kilobytes):
                limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (1024 * kilobytes, 1024 * kilobytes))
                ended = self.netloft("run", *PANEL, "-o", "p.hdf", preexec_fn=limit)
                self.assertEqual(ended.code, 1)
                self.assertIn("not enough memory: solving needs", ended.err)
                self.assertIn("ulimit -v", ended.err)
                self.assertEqual(self.files(), {})

    @unittest.skipIf("asan" in PROGRAM, "its shadow wants terabytes of addresses")
    def test_a_gear_that_takes_more_memory_than_there_is_is_refused_before_it_is_solved(self):
        gear = (str(SOURCE / "gear-library/scenes/four-panel.toml"), "--set", "gear.nodes=20000", "--threads", "1")
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (420 << 20, 420 << 20))
        ended = self.netloft("run", *gear, "-o", "p.hdf", preexec_fn=limit)
        self.assertEqual(ended.code, 1)
        self.assertRegex(ended.err, r"not enough memory: about \S+ GiB, .* available; a coarser mesh takes less")
        self.assertEqual(self.files(), {})

    @unittest.skipIf("asan" in PROGRAM, "its shadow wants terabytes of addresses")
    def test_enough_memory_is_enough(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_DATA, (1 << 30, 1 << 30))
        self.assertEqual(self.netloft("run", *PANEL, "-o", "p.hdf", preexec_fn=limit).code, 0)


class PluginsBesideScenes(InFreshFolder):
    def test_a_plugin_beside_a_scene_is_not_opened_unasked(self):
        (self.folder / "gear").mkdir()
        self.write("gear/otter.so", b"\x7fELF, or so")
        self.write("gear/scene.toml", '[parts.board]\ntype = "otter/board"\n')
        unasked = self.netloft("run", "gear/scene.toml")
        self.assertEqual(unasked.code, 4)
        self.assertIn('there is no plugin "otter"', unasked.err)
        self.assertNotIn("gear/otter.so", unasked.err)
        asked = self.netloft("run", "gear/scene.toml", "--scene-plugins")
        self.assertEqual(asked.code, 4)
        self.assertIn("gear/otter.so", asked.err)


class Limits(InFreshFolder):
    def test_an_integrator_as_solver_obeys_the_limit_of_iterations(self):
        for solver in ("central-difference", "newmark:corrector=fixed-point"):
            with self.subTest(solver=solver):
                run = self.netloft("run", *PANEL, "--solver", solver, "--set", "analysis.max_iterations=3", "--json", "--overwrite")
                self.assertEqual(run.code, 3)
                report = run.json()
                self.assertIn("the limit of 3 iterations was reached", report["reason"])
                self.assertLessEqual(report["iterations"], 3)


class Commands(InFreshFolder):
    def test_an_unknown_command_is_named(self):
        wrong = self.netloft("shema")
        self.assertEqual((wrong.code, wrong.err), (2, 'netloft: there is no command "shema"; did you mean "schema"?\n'))
        self.assertIn('there is no command "xyzzy"; `netloft --help` lists them', self.netloft("xyzzy").err)
        self.assertEqual(self.netloft("shema", "--json").json()["status"], "wrong input")

    def test_so_is_an_unknown_command_of_a_command(self):
        ended = self.netloft("study", "rum", "s.study")
        self.assertEqual(ended.code, 2)
        self.assertIn('there is no command "study rum"; did you mean "study run"?', ended.err)

    def test_an_unknown_option_is_named_with_the_one_it_may_stand_for(self):
        for words, wrong, meant in ((("run", "a.toml", "--start-fro"), "--start-fro", "--start-from"),
                                    (("run", "--stratgy", "auto", "a.toml"), "--stratgy", "--strategy"),
                                    (("run", "a.toml", "--stratgy=auto"), "--stratgy", "--strategy"),
                                    (("study", "run", "a.study", "--threds", "2"), "--threds", "--threads"),
                                    (("list", "-json"), "-json", "--json"),
                                    (("--verson",), "--verson", "--version")):
            with self.subTest(words=words):
                ended = self.netloft(*words)
                self.assertEqual((ended.code, ended.err),
                                 (2, f"netloft: there is no option {wrong}; did you mean {meant}?\n"))

    def test_an_option_that_is_like_no_other_gets_the_help_of_its_command(self):
        ended = self.netloft("study", "run", "a.study", "--xyzzy", "--json")
        self.assertEqual(ended.code, 2)
        self.assertIn("there is no option --xyzzy; `netloft study run --help` lists them", ended.err)
        self.assertEqual(ended.json()["status"], "wrong input")

    def test_an_option_of_another_command_is_named_with_that_command(self):
        for words, wrong, command, other in ((("plan", "a.toml", "--resume"), "--resume", "plan", "run"),
                                             (("run", "a.toml", "--depth", "1:2"), "--depth", "run", "scope"),
                                             (("check", "a.toml", "--resume"), "--resume", "check", "run")):
            with self.subTest(words=words):
                self.assertIn(f"there is no option {wrong} of `netloft {command}`; `netloft {other}` has it", self.netloft(*words).err)

    def test_no_command_at_all_gets_the_help(self):
        alone = self.netloft()
        self.assertEqual(alone.code, 0)
        for heading in ("Gears", "Scenes", "Results", "Studies", "Numerics", "Plugins"):
            self.assertIn(f"\n{heading}:\n", alone.out)
        self.assertNotIn("Subcommands:", alone.out)

    def test_a_strategy_that_is_named_as_solver_gets_a_hint(self):
        wrong = self.netloft("run", *PANEL, "--solver", "auto")
        self.assertEqual(wrong.code, 2)
        self.assertIn('"auto" is a strategy, not a solver', wrong.err)
        self.assertIn("--strategy auto", wrong.err)

    def test_keys_of_earlier_versions_name_their_successors(self):
        for key, successor in (("continuation=true", "strategy"), ("looks=6", "restarts=6")):
            wrong = self.netloft("run", *PANEL, "--set", f"analysis.{key}")
            self.assertEqual(wrong.code, 2)
            self.assertIn("is no longer a key of [analysis]", wrong.err)
            self.assertIn(successor, wrong.err)


if __name__ == "__main__":
    unittest.main()
