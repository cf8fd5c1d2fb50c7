# SPDX-License-Identifier: BSD-3-Clause
"""Results, journals and studies that somebody else made: every command must give an answer, and must not read, write, print or run anything outside the file."""
import csv
import io
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py

from program import GOOD, SOURCE, InFreshFolder, changed

sys.path.append(str(SOURCE / "tests" / "support"))
import files_of_others as others  # noqa: E402

MOTION = [str(SOURCE / "gear-library/scenes/dynamics/released-rope.toml"), "--set", "analysis.output_interval=0.5", "--set",
          "analysis.duration=2", "--set", "parts.rope.cells=4"]
SCENE = changed(GOOD, ("[results]\n", '[results]\n"=2+3" = { of = "rope", take = "max z" }\n'))


class OfOthers(InFreshFolder):
    def setUp(self):
        super().setUp()
        self.outer = self.folder
        self.folder = self.outer / "work"
        self.folder.mkdir()
        others.lay_out(self.outer)
        self.write("scene.toml", SCENE)

    def good_result(self):
        self.assertEqual(self.netloft("run", "scene.toml", "-o", "good.hdf").code, 0)
        return (self.folder / "good.hdf").read_bytes()

    def everything(self):
        return {str(p.relative_to(self.outer)): p.read_bytes() for p in self.outer.rglob("*") if p.is_file()}

    def expect_no_formulas(self, table):
        cells = [cell for row in csv.reader(io.StringIO(table)) for cell in row]
        for cell in cells:
            self.assertTrue(not re.match(r"[=+@\t-]", cell) or re.fullmatch(r"-?[\d.e+-]+", cell), cell)
        return cells

    def answer(self, *words, writes=()):
        """The output of a command, which must end, write at most these files, and print neither foreign data nor control characters."""
        before = self.everything()
        ended = self.netloft(*words)
        after = self.everything()
        for name in set(after) - {f"work/{one}{ending}" for one in writes for ending in ("", "~")}:
            self.assertEqual(after[name], before.get(name), f"{words} wrote {name}")
        for text in (ended.out, ended.err):
            self.assertIsNone(others.CONTROL.search(text), f"{words}: {text!r}")
            self.assertFalse(others.shows_what_is_foreign(text), text)
        for name in writes:
            (self.folder / name).unlink(missing_ok=True)
        return ended


class Results(OfOthers):
    def hostile(self, good, name, change):
        others.write_result(self.folder / name, good, change)
        self.write("mesh.toml", changed(SCENE, ('panel = { across = 4, along = 4, bar = "0.6 m" }\ncells = [4, 4]\n'
                                                'sketch = [[-2, 0, 0], [2, 0, 0], [2, 0, -4], [-2, 0, -4]]',
                                                f'panel = {{ bar = "0.6 m" }}\nmesh = "{name}"')))

    def expect_refused(self, name, why, *words):
        ended = self.answer(*words)
        self.assertIn(ended.code, (1, 2), f"{words}: {ended.out}{ended.err}")
        self.assertRegex(ended.err, f"(?m)^(netloft: |{re.escape(name)}: error: ).*cannot read {re.escape(name)}: {why}", words)
        if "--json" not in words:
            self.assertEqual(ended.out, "", words)

    def test_that_lead_elsewhere_are_refused_by_every_command(self):
        good = self.good_result()
        for kind, (change, why) in others.REFUSED.items():
            name = f"{kind}.hdf"
            self.hostile(good, name, change)
            for _, *words in others.commands_on(name):
                if kind == "names-of-holds" and "mesh.toml" in words:
                    continue  # a mesh has no holds
                with self.subTest(kind=kind, command=words):
                    self.expect_refused(name, why, *words)

    def test_that_lead_elsewhere_are_refused_as_what_a_run_has_left(self):
        good = self.good_result()
        for kind, (change, why) in others.REFUSED.items():
            with self.subTest(kind=kind):
                self.hostile(good, "left.hdf.part", change)
                self.expect_refused("left.hdf.part", why, "report", "left.hdf.part")

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_load_no_filters(self):
        """For an unknown filter, HDF5 would search its folder of plugins and load each of them."""
        self.write("filter.c", '#include <stdio.h>\n__attribute__((constructor)) static void run(void) { fclose(fopen("EXECUTED", "w")); }\n')
        subprocess.run(["cc", "-shared", "-fPIC", "filter.c", "-o", "libfilter.so"], cwd=self.folder, check=True)

        def filtered(f, path, shape, dtype):
            how = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            how.set_chunk(shape)
            how.set_filter(32015, h5py.h5z.FLAG_OPTIONAL, ())
            made = h5py.h5d.create(f.id, path.encode(), h5py.h5t.IEEE_F64LE, h5py.h5s.create_simple(shape), how)
            made.write_direct_chunk((0, 0), b"\0" * 8 * shape[0] * shape[1])
        self.hostile(self.good_result(), "filter.hdf", others.replaced("VTKHDF/Points", filtered))
        ended = self.netloft("export", "filter.hdf", "o.csv", environment=self.environment(HDF5_PLUGIN_PATH=str(self.folder)))
        self.assertEqual(ended.code, 2, ended.out)
        self.assertIn("cannot read /VTKHDF/Points in filter.hdf", ended.err)
        self.assertFalse((self.folder / "EXECUTED").exists())

    def test_with_escapes_in_their_texts_do_not_speak_to_the_terminal(self):
        good = self.good_result()
        self.hostile(good, "texts.hdf", others.escapes_in_texts)
        shown = 0
        for writes, *words in others.commands_on("texts.hdf"):
            with self.subTest(command=words):
                ended = self.answer(*words, writes=writes)
                self.assertIn(ended.code, (0, 2, 3), ended.err)
                shown += "\\u001b" in ended.out
        self.assertGreaterEqual(shown, 5)
        json.loads(self.answer("report", "texts.hdf", "--json").out)

    def test_with_many_figures_are_answered(self):
        good = self.good_result()
        self.hostile(good, "many.hdf", others.many_figures)
        for _, *words in (([], "report", "many.hdf"), ([], "diff", "many.hdf", "good.hdf")):
            self.assertEqual(self.answer(*words).code, 0)

    def test_hold_no_formulas_in_their_tables(self):
        self.good_result()
        said = self.answer("report", "good.hdf", "--csv").out
        self.assertIn("'=2+3", self.expect_no_formulas(said))

    def test_have_an_index_that_is_xml_whatever_they_are_called(self):
        name = "a<b>&\"c.hdf"
        ended = self.netloft("run", *MOTION, "-o", name)
        self.assertEqual(ended.code, 0, ended.err)
        index = xml.etree.ElementTree.parse(self.folder / "a<b>&\"c.xdmf")
        self.assertEqual({item.text for item in index.iter("DataItem")}, {name})


class Journals(OfOthers):
    def test_whose_inputs_lead_elsewhere_are_refused(self):
        for change, why in others.IN_JOURNALS.values():
            part = self.folder / "r.hdf.part"
            (self.folder / "r.hdf.new").mkdir()  # its outputs stay a journal
            self.assertEqual(self.netloft("run", *MOTION, "-o", "r.hdf").code, 1)
            (self.folder / "r.hdf.new").rmdir()
            others.rewrite_journal(part, others.in_image(change, self.outer / "image"))
            for words in (["report", part.name], ["view", part.name, "-o", "o.html"], ["diff", part.name, part.name], ["export", part.name, "o.csv"]):
                with self.subTest(why=why, command=words):
                    ended = self.answer(*words)
                    self.assertEqual(ended.code, 2, ended.err)
                    self.assertRegex(ended.err, f"cannot read r.hdf.part.*{why}")
            part.unlink()


STUDY = """\
scene = "scene.toml"
[variables.water]
key = "water.density"
values = [1000, 1010]
[variables.twine]
key = "parts.net.twine.EA"
range = ["8 kN", "12 kN"]
[design]
samples = 4
"""


class Studies(OfOthers):
    def good_study(self):
        self.write("s.toml", STUDY)
        self.assertEqual(self.netloft("study", "plan", "s.toml").code, 0)
        self.assertEqual(self.netloft("study", "run", "s.study").code, 0)

    def copy(self, name):
        return Path(shutil.copytree(self.folder / "s.study", self.folder / name))

    def renamed(self, name, change):
        others.change_manifest(self.copy(name) / "manifest.jsonl", change)

    def expect_refused(self, folder, why):
        for words in others.actions_on(folder):
            with self.subTest(folder=folder, action=words[0]):
                ended = self.answer("study", *words)
                self.assertEqual(ended.code, 2, ended.out + ended.err)
                self.assertRegex(ended.err, rf"(?m)^netloft: {folder}/manifest\.jsonl:(\d+:)? the manifest is damaged \({why}")

    def test_whose_names_lead_elsewhere_are_refused(self):
        self.good_study()
        for folder, name in {**others.NAMES_OF_STUDIES, "absolute": str(self.outer / "pwned")}.items():
            self.renamed(f"{folder}.study", lambda head: head.update(name=name))
            self.expect_refused(f"{folder}.study", "the name of the study, ")
        self.renamed("variable.study", lambda head: head["variables"][0].update(name="../x\n=2+3"))
        self.expect_refused("variable.study", "the name of a variable, ")

    def test_whose_values_are_not_those_that_were_set_are_refused(self):
        self.good_study()
        manifest = self.copy("values.study") / "manifest.jsonl"
        text = manifest.read_text()
        manifest.write_text(text.replace('["1010",1010.0]', '["1010",1011.0]', 1))
        self.expect_refused("values.study", 'the value "1010" of water is another number')
        manifest.write_text(text.replace('["1010",1010.0]', '["1011",1011.0]', 1))
        self.expect_refused("values.study", "the values of an item are not those that it sets")
        manifest.write_text(text.replace('"seed":1', '"seed":3'))
        self.expect_refused("values.study", "it does not match its checksum")
        manifest.write_text(text.replace('"name":"twine"', '"name":"twina"'))
        self.expect_refused("values.study", "it does not match its checksum")

    def test_with_escapes_in_their_records_do_not_speak_to_the_terminal(self):
        self.good_study()
        study = self.copy("escape.study")
        records = sorted((study / "items").glob("*.json"))
        records[0].with_suffix(".failed").write_text(others.ESCAPES)
        records[0].unlink()
        for record, place in ((records[1], "reason"), (records[2], "figures")):
            text = json.loads(record.read_text().rsplit("crc32 ", 1)[0])
            if place == "figures":
                text["figures"][0]["name"] = "gear/" + others.ESCAPES
            else:
                text["points"][0].update(reason=others.ESCAPES, status="=2+3")
                text["cost"]["host"] = "@" + others.ESCAPES
            content = json.dumps(text, ensure_ascii=False).encode() + b"\n"
            record.write_bytes(others.sealed_record(content))
        ended = self.netloft("study", "collect", "escape.study")
        self.assertEqual(ended.code, 1, ended.err)
        self.assertIn("\\u001b", ended.err)
        self.assertIn("a figure cannot be called", ended.err)
        for name in ("table.csv", "costs.csv"):
            table = (study / name).read_bytes().decode()
            self.assertIsNone(others.CONTROL.search(table), name)
            self.expect_no_formulas(table)
        own = [f"escape.study/{name}" for name in ("table.csv", "table.hdf", "costs.csv", "s.html", "parallel.sh", "slurm.sh")]
        for words in others.actions_on("escape.study")[1:]:
            self.answer("study", *words, writes=own)

    def test_whose_file_is_called_like_a_command_run_none(self):
        """The name of a study file becomes the name of the study, which appears in comments of scripts and as an argument of Slurm."""
        name = "$(touch EXECUTED) `touch EXECUTED` '; touch EXECUTED; --wrap=x"
        self.write(f"{name}.toml", STUDY)
        planned = self.netloft("study", "plan", f"{name}.toml", "-o", "c.study")
        self.assertEqual(planned.code, 0, planned.err)
        tools = self.outer / "tools"
        tools.mkdir()
        # A stand-in for GNU parallel with one job: runs its last argument as a shell command, once for each
        # line of input.
        (tools / "parallel").write_text('#!/usr/bin/env bash\nfor last; do :; done\n'
                                        'while read -r item; do bash -c "${last//\\{\\}/$item}" || exit; done\n')
        (tools / "parallel").chmod(0o755)
        for engine, script in (("parallel", "parallel.sh"), ("slurm", "slurm.sh")):
            odd = str(self.folder / "$(touch EXECUTED) and 'more'")
            Path(odd).mkdir(exist_ok=True)
            ended = self.netloft("study", "submit", "c.study", "--engine", engine, "--plugins", odd)
            self.assertEqual(ended.code, 0, ended.err)
            text = (self.folder / "c.study" / script).read_text()
            self.assertEqual([line for line in text.splitlines() if "--wrap" in line and not line.startswith("# ")],
                             ["#SBATCH --job-name=__touch_EXECUTED___touch_EXECUTED_____touch_EXECUTED__--wrap_x"] if engine == "slurm" else [])
            environment = self.environment(PATH=f"{tools}:{os.environ['PATH']}", SLURM_ARRAY_TASK_ID="1")
            subprocess.run(["bash", script], cwd=self.folder / "c.study", env=environment, capture_output=True, timeout=120)
            self.assertEqual([p for p in self.outer.rglob("EXECUTED*")], [])
        self.assertEqual(self.netloft("study", "missing", "c.study").out, "")

    def test_whose_file_cannot_be_a_name_are_not_planned(self):
        self.write("x\ntouch EXECUTED; #.toml", STUDY)
        ended = self.answer("study", "plan", "x\ntouch EXECUTED; #.toml")
        self.assertEqual(ended.code, 2)
        self.assertRegex(ended.err, r"becomes the name of the study, and must not contain control characters\n  hint: rename the file")


class Scenes(OfOthers):
    def test_do_not_speak_to_the_terminal(self):
        """Names from these files do not become names of result files either."""
        for old, new, says in (("[parts.rope]", '[parts."ro\\u009b31mpe"]', "must not contain control characters"),
                               ('"=2+3"', '"\\u001b[31m"', "must not contain control characters"),
                               ('type = "rope/bar"', 'type = "rope/\\u009b31m"', "\\\\u009b31m")):
            self.write("odd.toml", changed(SCENE, (old, new)))
            for words in (["plan", "odd.toml"], ["run", "odd.toml"], ["plan", "odd.toml", "--json"], ["run", "odd.toml", "--json"]):
                with self.subTest(new=new, command=words):
                    ended = self.answer(*words)
                    self.assertIn(ended.code, (2, 4), ended.err)
                    self.assertRegex(ended.err, says)

    def test_with_escapes_in_their_text_are_shown_without(self):
        self.write("raw.toml", SCENE.replace("[water]", "[water]\n# \x1b[31m\x9b31m\nd\x9bensty = 3"))
        self.write("raw2.toml", SCENE + '"\x1b" = 3\n')
        for name in ("raw.toml", "raw2.toml"):
            self.assertEqual(self.answer("plan", name).code, 2)


if __name__ == "__main__":
    unittest.main()
