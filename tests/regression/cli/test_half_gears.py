# SPDX-License-Identifier: BSD-3-Clause
"""Half a gear may replace a whole one only if port and starboard are equal."""
import unittest

from program import SOURCE, InFreshFolder

FLUME = SOURCE / "gear-library" / "scenes" / "83-112-flume-3.0kn.toml"


class HalfGears(InFreshFolder):
    def refused(self, *settings):
        words = [word for setting in settings for word in ("--set", setting)]
        ended = self.netloft("plan", str(FLUME), *words)
        self.assertEqual(ended.code, 2, ended.out)
        self.assertIn('extent = "whole"', ended.err)
        return ended.err

    def test_refuse_a_current_across(self):
        self.assertIn("water.current: flows across the plane y = 0", self.refused('water.current=["3 kn", "1 kn", 0]'))
        self.refused('water.current={ z = [0, -50], x = [1, 1], y = [0, 0.5] }')

    def test_refuse_a_tow_askew(self):
        self.assertIn("tow.leeway: leads across the plane y = 0", self.refused("tow.speed=1", "tow.leeway=10 deg"))

    def test_refuse_a_bed_that_slopes_across(self):
        self.assertIn("seabed.slope_y is not zero", self.refused("parts.bed.seabed.slope_y=0.1"))

    def test_refuse_holds_beyond_the_plane(self):
        ended = self.netloft("plan", str(FLUME.parent / "four-panel.toml"), "--set", "hold[0].at=[0, -5, -30]")
        self.assertEqual(ended.code, 2, ended.out)
        self.assertIn("error: at the start upper-bridle and lower-bridle lie up to 5 m beyond the plane of symmetry, y = 0", ended.err)

    def test_have_elements_that_are_named_wrong(self):
        ended = self.netloft("plan", str(FLUME), "--set", "parts.bed.type=seabedd/plane")
        self.assertEqual(ended.code, 4, ended.err)
        self.assertIn('there is no plugin "seabedd"; did you mean "seabed"?', ended.err)
        at_sea = str(FLUME.parent / "83-112-at-sea-66m.toml")
        ended = self.netloft("plan", at_sea, "--set", "bodies.doors.board.lift=1")
        self.assertEqual(ended.code, 2, ended.err)
        self.assertIn("bodies.doors.type: is missing: element type", ended.err)

    def figures(self, scene, extent, size):
        ended = self.netloft("run", str(FLUME.parent / scene), "--set", f"gear.extent={extent}", "--set", f"gear.size={size}", "--set", "gear.nodes=0",
                             "--set", "analysis.tolerance=1e-10", "-o", f"{extent}.hdf", "--overwrite", "--json")
        self.assertEqual(ended.code, 0, ended.err)
        return ended.json()["gear"]["figures"]

    def test_are_half_of_the_whole_with_boards_on_the_bed(self):
        # On other meshes slack netting at the wing tips has several stable shapes, and the whole gear may
        # take another shape than the half.
        half, whole = (self.figures("83-112-at-sea-66m.toml", extent, "2 m") for extent in ("half", "whole"))
        self.assertGreater(half["ground/force"], 1000)
        same = [name for name in half if name in whole and name.split("/")[0] in ("mouth", "pairs", "towing", "ground", "rigging") and not name.endswith("_y")]
        self.assertGreater(len(same), 20)
        for name in same:
            # Drag that nodes in the plane of symmetry bear is shared by both sides in the whole gear only.
            relative = 1e-4 if name in ("mouth/water_speed", "mouth/filtered") else 1e-8
            self.assertAlmostEqual(half[name], whole[name], delta=relative * max(1, abs(half[name])), msg=name)

    def test_take_what_is_symmetric(self):
        self.assertEqual(self.netloft("plan", str(FLUME), "--set", "parts.bed.seabed.slope_x=0.1").code, 0)


if __name__ == "__main__":
    unittest.main()
