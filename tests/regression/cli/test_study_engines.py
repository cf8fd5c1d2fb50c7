# SPDX-License-Identifier: BSD-3-Clause
"""One study by the pool of the program, by GNU parallel and by Slurm on this machine: the tables have the same bits."""
import contextlib
import os
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import local_slurm
from test_study import ITEMS, Studies

PARALLEL, SNAKEMAKE = shutil.which("parallel"), shutil.which("snakemake")


class Engines(Studies):
    def setUp(self):
        super().setUp()
        self.whole = self.whole_study()
        self.study("plan", "s.toml", "-o", "other")
        self.other = self.folder / "other"

    def script(self, engine, *words):
        said = self.study("submit", "other", "--engine", engine, *words)
        name = {"parallel": "parallel.sh", "slurm": "slurm.sh"}[engine]
        self.assertIn(f"written to other/{name}", said.out)
        text = (self.other / name).read_text()
        subprocess.run(["bash", "-n", str(self.other / name)], check=True)
        return text

    def missing(self):
        return [int(line) for line in self.study("missing", "other").out.split()]

    def assert_same_table(self):
        self.assertEqual(self.missing(), [])
        self.assertEqual(self.make_table("other"), self.whole)


@unittest.skipUnless(PARALLEL, "GNU parallel is not installed (Debian: parallel)")
class ByParallel(Engines):
    def run_script(self, **how):
        return subprocess.run(["bash", "parallel.sh"], cwd=self.other, env=self.environment(HOME=str(self.folder)), stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=120, **how)

    def test_the_table_is_the_same(self):
        self.assertIn(f"{ITEMS} items", self.script("parallel", "--jobs", "2"))
        ended = self.run_script()
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assert_same_table()
        log = (self.other / "parallel.log").read_text().splitlines()
        self.assertEqual(len(log), 1 + ITEMS)

    def test_it_goes_on_after_kills_of_the_engine_and_of_workers(self):
        self.script("parallel", "--jobs", "2")
        for _ in range(2):
            engine = subprocess.Popen(["bash", "parallel.sh"], cwd=self.other, env=self.environment(HOME=str(self.folder)), stdin=subprocess.DEVNULL,
                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            before = len(self.missing())
            while len(self.missing()) == before and engine.poll() is None:
                time.sleep(0.01)
            with contextlib.suppress(ProcessLookupError):  # a fast machine is done by now
                os.killpg(engine.pid, signal.SIGKILL)
            engine.wait()
        self.assertEqual(self.run_script().returncode, 0)
        self.assert_same_table()

    def test_a_record_that_is_garbage_is_computed_again(self):
        self.script("parallel")
        self.assertEqual(self.run_script().returncode, 0)
        next((self.other / "items").glob("*.json")).write_bytes(b"garbage")
        self.assertEqual(len(self.missing()), 1)
        self.assertEqual(self.run_script().returncode, 0)
        self.assert_same_table()


@unittest.skipIf(local_slurm.why_not(), local_slurm.why_not() or "it can")
class BySlurm(Engines):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(keeper.cleanup)
        cls.slurm = local_slurm.LocalSlurm(keeper.name + "/slurm")
        cls.addClassCleanup(cls.slurm.stop)
        why_not = cls.slurm.start()
        if why_not:
            raise unittest.SkipTest(why_not)

    def submit(self, *words):
        environment = {**self.environment(), "SLURM_CONF": self.slurm.environment["SLURM_CONF"]}
        return subprocess.run([local_slurm.find("sbatch"), *words, "slurm.sh"], cwd=self.other, env=environment,
                              capture_output=True, text=True, timeout=120)

    def test_the_table_is_the_same_and_a_cancelled_array_goes_on(self):
        self.assertIn("#SBATCH --array=1-3\n", self.script("slurm", "--chunk", "2"))
        job = self.submit("--parsable").stdout.strip()
        while len(self.missing()) == ITEMS:
            time.sleep(0.02)
        # On a fast machine, the study has ended before this.
        subprocess.run([local_slurm.find("scancel"), "--signal=KILL", "--full", job], env=self.slurm.environment, check=False)
        ended = self.submit("--wait")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assert_same_table()


class Scripts(Engines):
    def test_tasks_fill_a_minute_by_what_items_have_cost(self):
        self.assertIn("No item has been computed", self.script("slurm"))
        self.assertIn("#SBATCH --array=1-6\n", self.script("slurm"))
        self.study("run", "other", "--items", "1")
        self.assertIn("#SBATCH --array=1-1\n", self.script("slurm"))

    def test_plugins_are_handed_on(self):
        (self.folder / "it's mine").mkdir()
        script = self.script("parallel", "--plugins", "it's mine")
        line = next(line for line in script.splitlines() if line.startswith("  parallel "))
        command = shlex.split(line)[-1]  # for the shell that GNU parallel starts
        self.assertEqual(shlex.split(command)[-2:], ["--plugins", "it's mine"])
        self.assertIn("""--plugins 'it'\\''s mine'""", self.script("slurm", "--plugins", "it's mine"))

    def test_wrong_engines_are_refused(self):
        self.study("submit", "other", "--engine", "condor", code=2)
        self.study("submit", "other", code=2)
        for engine, option, of in (("slurm", "--jobs", "GNU parallel"), ("parallel", "--chunk", "Slurm")):
            self.assertIn(f"{option} is for {of}; the engine is {engine}", self.study("submit", "other", "--engine", engine, option, "2", code=2).err)
        self.study("submit", "other", "--engine", "slurm", "--chunk", "0", code=2)
        self.study("missing", "nowhere", code=2)


@unittest.skipUnless(SNAKEMAKE, "snakemake is not installed (Debian: snakemake)")
class BySnakemake(Engines):
    def test_the_rule_of_the_page_computes_the_study(self):
        page = (local_slurm.Path(os.environ["NETLOFT_SOURCE_DIR"]) / "io/studies/STUDY.md").read_text()
        rule = page.split("```python Snakefile\n")[1].split("```")[0]
        (self.folder / "Snakefile").write_text(rule.replace("speeds", "s"))
        shutil.rmtree(self.folder / "s.study")
        path = f"{os.path.dirname(os.environ['NETLOFT_PROGRAM'])}:{os.environ['PATH']}"
        ended = subprocess.run([SNAKEMAKE, "--cores", "2", "--quiet"], cwd=self.folder, env=self.environment(PATH=path, HOME=str(self.folder)),
                               capture_output=True, text=True, timeout=200)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertEqual(self.table(), self.whole)


if __name__ == "__main__":
    unittest.main(verbosity=2)
