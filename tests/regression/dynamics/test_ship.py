#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes in the path of a ship and in the lengths of its warps give messages with places.

    test_ship.py NETLOFT SOURCE_FOLDER
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

NETLOFT, LIBRARY = sys.argv[1], Path(sys.argv[2]).resolve() / "gear-library"
SCENE = f"""
include = ["{LIBRARY}/gears/83-112-with-doors.toml"]
[gear]
nodes = 60
[ship]
speed = "1.5 m/s"
path = {{ t = [0, 1, 2], speed = [1.5, 1.5, 1.0], heading = [0, 0, "3 deg"] }}
[ship.warp]
length = "240 m"
winch = {{ t = [0, 2], length = ["240 m", "238 m"] }}
[analysis]
kind = "dynamic"
duration = 0.2
output_interval = 0.1
energy_budget = false
accuracy = 1
tolerance = 1e-3
"""

class ShipInMotion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.scene = Path(self.folder.name) / "ship.toml"
        self.scene.write_text(SCENE)
        self.output = Path(self.folder.name) / "ship.hdf"

    def run_it(self, *settings):
        words = [NETLOFT, "run", self.scene, "--threads", "1", "--json", "--overwrite", "-o", self.output]
        for setting in settings:
            words += ["--set", setting]
        return subprocess.run(words, capture_output=True, text=True, check=False)

    def test_says_what_is_wrong_and_where(self):
        for setting, words in (
                ("ship.path={t=[0,1],speed=[2,1]}", "begins with another value than ship.speed"),
                ("ship.path={t=[1,2],heading=[0,1]}", "must begin at 0"),
                ("ship.path={t=[0,2,1],heading=[0,1,1]}", "does not ascend"),
                ("ship.path_port={t=[1,2],heading=[0,1]}", "must begin at 0"),
                ("ship.path_port={t=[0,1],speed=[2,1]}", "begins with another value than ship.speed"),
                ("ship={speed=1,block={gap=0},path={t=[0,1],heading=[0,1]},path_port={t=[0,1],heading=[0,1]}}", "needs a block to port"),
                ("ship.warp.winch={t=[0,1],length=[200,100]}", "begins with another value than warp.length"),
                ("ship.warp.winch={t=[0,1],length=[240,100],speed=[0,1]}", "give one of them"),
                ("ship.warp.winch={t=[0,100],speed=[-3,-3]}", "hauls more warp than there is"),
                ("ship.warp.tension=\"12 kN\"", "is given beside warp.tension"),
                ("ship.warp.winch=[{tension=12000},{speed=[0,-1]}]", "ship.warp.winch[1].t: is missing: it is the time at which this table replaces"),
                ("ship.warp.winch=[{tension=12000},{t=[5,9]}]", "is missing, and so are speed and tension"),
                ("ship.warp.winch=[{tension=12000},{t=[5,9],length=[240,200]}]", "cannot be given in a second or later table"),
                ("ship.warp.winch=[{t=[0,20],tension=[12000,13000]},{t=[19,30],speed=[0,-1]}]", "begins before the end of the previous table"),
                ("ship.warp.winch=[{tension=12000},{t=[0,9],speed=[0,-1]}]", "begins before the end of the previous table"),
                ("ship.warp.winch=[{tension=12000},{t=[5,9],speed=[0,-1],band=5}]", "belongs to a winch that holds a tension"),
                ("ship.warp.winch=[{t=[1,2],speed=[0,-1]}]", "must begin at 0"),
                ("ship.warp.winch=[5]", "ship.warp.winch[0]"),
                ("ship.warp.winch=[]", "ship.warp.winch"),
                ("ship.warp.winch={}", "is missing, and so are speed and tension"),
                ("ship.warp.winch={tension=12000,length=[240,100],t=[0,1]}", "winch.tension: is given beside length"),
                ("ship.warp.winch={tension=-1}", "is outside (0, 1e9] N"),
                ("ship.warp.winch={t=[0,1],tension=[12000]}", "ship.warp.winch.tension"),
                ("ship.warp.winch={tension=12000,max_speed=0}", "is outside (0, 50] m/s"),
                ("ship.warp.winch={tension=12000,band=0}", "ship.warp.winch.band"),
                ("ship.warp.winch={tension=12000,dead_band=-1}", "ship.warp.winch.dead_band"),
                ("ship.warp.winch={t=[0,1],length=[240,200],max_speed=1}", "belongs to a winch that holds a tension"),
                ("ship.warp={length=240,tension=12000,winch={tension=13000}}", "begins with another value than warp.tension"),
                ("ship.warp={length=240,tension=12000,tension_port=13000,winch={t=[0,9],tension=[12000,13000]}}", "is for both warps"),
                ("gear.extent=half", "the ship turns")):
            with self.subTest(setting=setting):
                ended = self.run_it(setting)
                self.assertEqual(ended.returncode, 2, ended.stderr[-500:])
                self.assertIn(words, ended.stderr)

    def test_moves_nothing_in_statics(self):
        self.scene.write_text(SCENE.replace('kind = "dynamic"', 'kind = "static"').split("duration")[0])
        ended = self.run_it()
        self.assertEqual(ended.returncode, 2)
        for word in ("ship.path", "ship.warp.winch"):
            self.assertIn(word + " has no effect, because nothing moves in a static analysis", ended.stderr)

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
