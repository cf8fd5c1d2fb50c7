# SPDX-License-Identifier: BSD-3-Clause
"""A run on several ranks: the figures of one process, one file, one voice, and an end when a rank ends."""
import json
import os
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

from program import GOOD, PROGRAM, SOURCE, InFreshFolder, changed

MODULE = Path(PROGRAM).resolve().parents[1] / "lib/netloft/mpi/mumps_mpi.so"
MPIRUN = shutil.which("mpirun")
SCENES = SOURCE / "gear-library/scenes"
PANEL = ["run", str(SCENES / "dead-weight-panel.toml"), "--set", "parts.net.cells=[8,8]", "--set", "analysis.tolerance=1e-13"]
CODEND = ["run", str(SCENES / "verification/codend-with-catch.toml"), "--set", "parts.codend.cells=[12,24]",
          "--set", "analysis.tolerance=1e-13"]
DRAGGED = ["run", str(SCENES / "verification/rope-dragged-over-seabed.toml")]
ALL = ["--ranks-from", "1", "--threads", "1"]  # coarse meshes of a strategy, too
LONG = ["run", str(SCENES / "dead-weight-panel.toml"), "--set", "parts.net.cells=[240,240]", "--set", "analysis.tolerance=1e-16", *ALL]


def why_not():
    if not MPIRUN:
        return "there is no mpirun (Debian: openmpi-bin)"
    if "Open MPI" not in subprocess.run([MPIRUN, "--version"], capture_output=True, text=True, check=False).stdout:
        return "mpirun is not that of Open MPI, whose options the test uses"
    return "" if MODULE.is_file() else f"there is no {MODULE}: built without MPI or its MUMPS (Debian: libmumps-dev)"


@unittest.skipIf(why_not(), why_not() or "it can")
class OnRanks(InFreshFolder):
    def launcher(self, ranks):
        as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        return [MPIRUN, *as_root, "--oversubscribe", "-n", str(ranks)]

    def environment(self, **more):
        # In a container a rank may not read the memory of another.
        return super().environment(**{"OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMP_THREAD_LIMIT": "1", **more})

    def on_ranks(self, ranks, *words, program=PROGRAM):
        return subprocess.run([*self.launcher(ranks), program, *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=120, env=self.environment())

    def started(self, ranks, *words):
        process = subprocess.Popen([*self.launcher(ranks), PROGRAM, *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=self.environment(), start_new_session=True)
        self.addCleanup(lambda: process.poll() is None and os.killpg(process.pid, signal.SIGKILL))
        return process

    def points(self, name):
        with h5py.File(self.folder / name) as f:
            return f["VTKHDF/Points"][: f["VTKHDF/NumberOfPoints"][0]]

    def ranks_of(self, process):
        """Processes of the program below mpirun, by rank."""
        found = {}
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                if int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1]) != process.pid:
                    continue
                given = dict(v.split(b"=", 1) for v in (folder / "environ").read_bytes().split(b"\0") if b"=" in v)
                found[int(given[b"OMPI_COMM_WORLD_RANK"])] = int(folder.name)
            except (OSError, KeyError):
                continue
        return found

    def wait_for_line(self, process):
        """A line of progress: the ranks are at work."""
        while b"progress" not in (line := process.stderr.readline()):
            self.assertTrue(line, "it ended before")

    def assert_same_figures(self, scene, *words, closeness=1e-9):
        """`closeness`: of positions, over the size of the gear; 0: of the same bits. All begin where lighter water has the gear: some ten factorisations instead of hundreds."""
        self.assertEqual(self.netloft(*scene, "--set", "water.density=1000", "-o", "near.hdf").code, 0)
        scene = [*scene, "--start-from", "near.hdf"]
        self.assertEqual(self.netloft(*scene, "-o", "alone.hdf").code, 0)
        self.assertGreater(np.abs(self.points("near.hdf") - self.points("alone.hdf")).max(), 1e-4)
        alone = self.points("alone.hdf")
        for ranks in (1, 2, 4):
            name = f"{ranks}.hdf"
            ended = self.on_ranks(ranks, *scene, *ALL, *words, "-o", name, "--json")
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertLessEqual(np.abs(self.points(name) - alone).max(), closeness * np.ptp(alone, axis=0).max())
            said = json.loads(ended.stdout)  # by one rank
            self.assertGreater(said["factorisations"], 1)
            self.assertEqual((said["status"], said["stability"]), ("converged", "stable"))
            self.assertEqual(said["ranks"], ranks)
            self.assertEqual(f"on {ranks} ranks" in said["factorisation"], ranks > 1, said["factorisation"])
        self.assertEqual(sorted(self.files()), ["1.hdf", "2.hdf", "4.hdf", "alone.hdf", "near.hdf"])

    def test_a_symmetric_tangent_gives_the_figures_of_one_process(self):
        self.assert_same_figures(PANEL)

    def test_an_unsymmetric_tangent_gives_the_figures_of_one_process(self):
        self.assert_same_figures(CODEND)

    def test_an_unsymmetric_tangent_gives_the_bits_of_one_process(self):
        self.assert_same_figures(CODEND, "--same-bits", closeness=0)

    def test_friction_that_sticks_gives_the_bits_of_one_process(self):
        self.assert_same_figures(DRAGGED, "--same-bits", closeness=0)

    def test_a_symmetric_tangent_gives_the_same_bits_on_any_number_of_ranks(self):
        for name, ranks in (("two", 2), ("again", 2), ("four", 4)):
            ended = self.on_ranks(ranks, *PANEL, *ALL, "--same-bits", "-o", f"{name}.hdf")
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertEqual(np.abs(self.points(f"{name}.hdf") - self.points("two.hdf")).max(), 0)

    def test_what_is_for_several_processes_is_refused_in_one(self):
        for words in (["--ranks-from", "1"], ["--same-bits"]):
            ended = self.netloft(*PANEL, *words)
            self.assertEqual(ended.code, 2)
            self.assertIn(f"{words[0]} is for runs on several ranks", ended.err)

    def test_small_matrices_stay_in_one_process(self):
        ended = self.on_ranks(2, *PANEL, "--json")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        said = json.loads(ended.stdout)
        self.assertNotIn("ranks", said["factorisation"])
        self.assertEqual(said["ranks"], 1)

    def test_wrong_input_is_said_once_and_its_exit_code_stays(self):
        self.write("scene.toml", changed(GOOD, ("bar = ", "baar = ")))
        ended = self.on_ranks(2, "run", "scene.toml")
        self.assertEqual(ended.returncode, 2, ended.stderr)
        self.assertEqual(ended.stderr.count("baar"), 1 + ended.stderr.count("baar = "), ended.stderr)
        self.assertEqual(list(self.files()), ["scene.toml"])

    def test_what_does_not_converge_keeps_its_exit_code(self):
        self.assertEqual(self.on_ranks(2, *PANEL, *ALL, "--set", "analysis.max_iterations=3").returncode, 3)

    def test_other_commands_are_refused(self):
        for words in (["study", "plan", "s.toml"], ["plan", PANEL[1]], ["list"]):
            ended = self.on_ranks(2, *words)
            self.assertEqual(ended.returncode, 2, ended.stderr)
            self.assertEqual(ended.stderr.count(f"`{words[0]}` works in one; only `run` works in several"), 1, ended.stderr)
        self.assertEqual(self.on_ranks(1, "list").returncode, 0)

    def test_a_rank_that_is_killed_ends_the_run(self):
        process = self.started(2, *LONG, "-o", "killed.hdf")
        self.wait_for_line(process)
        os.kill(self.ranks_of(process)[1], signal.SIGKILL)
        process.communicate(timeout=30)
        self.assertNotEqual(process.returncode, 0)
        self.assert_nothing_half()

    def test_ctrl_c_writes_the_last_point_or_nothing(self):
        process = self.started(2, *LONG, "-o", "interrupted.hdf")
        self.wait_for_line(process)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        self.assertNotEqual(process.returncode, 0)
        self.assert_nothing_half()

    def assert_nothing_half(self):
        """Files that are there under the name of a result are whole."""
        for name in self.files():
            if name.endswith(".hdf"):
                with h5py.File(self.folder / name) as f:
                    self.assertNotEqual(f["netloft/status"].attrs["outcome"], "converged")

    def test_ranks_without_work_leave_the_processor_to_others(self):
        # All matrices are small, and the run takes some seconds.
        process = self.started(2, *LONG[:-4], "--set", "parts.net.cells=[160,160]", "--threads", "1")
        self.wait_for_line(process)
        helper = self.ranks_of(process)[1]
        used = [int(n) for n in Path(f"/proc/{helper}/stat").read_text().rsplit(")", 1)[1].split()[11:13]]
        time.sleep(0.5)
        later = [int(n) for n in Path(f"/proc/{helper}/stat").read_text().rsplit(")", 1)[1].split()[11:13]]
        seconds = (sum(later) - sum(used)) / os.sysconf("SC_CLK_TCK")
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        self.assertLess(seconds, 0.1)

    def test_without_its_module_it_is_refused(self):
        (self.folder / "p/bin").mkdir(parents=True)
        shutil.copy(PROGRAM, self.folder / "p/bin/netloft")
        ended = self.on_ranks(2, *PANEL, program=str(self.folder / "p/bin/netloft"))
        self.assertEqual(ended.returncode, 2, ended.stderr)
        self.assertEqual(ended.stderr.count("mumps_mpi.so"), 1, ended.stderr)
        self.assertIn("built where libmumps-dev is installed", ended.stderr)

    def test_the_launcher_of_another_mpi_is_noticed(self):
        ended = self.netloft(*PANEL, environment=self.environment(PMI_SIZE="2", PMI_RANK="0"))
        self.assertEqual(ended.code, 2, ended.err)
        self.assertIn("that of another MPI", ended.err)

    def test_the_option_is_for_ranks(self):
        ended = self.netloft(*PANEL, "--ranks-from", "10")
        self.assertEqual(ended.code, 2)
        self.assertIn("mpirun -n 4 netloft run", ended.err)


if __name__ == "__main__":
    if why_not():
        print("skipped:", why_not())
    unittest.main(verbosity=2)
