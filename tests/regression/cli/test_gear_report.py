# SPDX-License-Identifier: BSD-3-Clause
"""The report of a gear: the same in every form, and its forces are in balance."""
import unittest

import h5py

from program import SOURCE, InFreshFolder

CODEND = str(SOURCE / "gear-library/scenes/codend-from-plan.toml")
FLUME = str(SOURCE / "gear-library/scenes/83-112-flume-2.0kn.toml")


class GearReports(InFreshFolder):
    def test_json_file_and_terminal_say_the_same(self):
        words = ["run", FLUME, "--set", "gear.nodes=400", "-o", "trawl.hdf"]
        report = self.netloft(*words, "--json").json()
        gear = report["gear"]
        self.assertEqual((report["status"], gear["modelled"], gear["times"]), ("converged", "half", 2))
        with h5py.File(self.folder / "trawl.hdf") as f:
            for name, value in gear["figures"].items():
                self.assertEqual(f["netloft/gear"][name][()], value)
                self.assertEqual(f["netloft/errors/gear/solver"][name][()], gear["errors"][name]["solver"])
            self.assertEqual(f["netloft/gear"].attrs["times"], 2)
        told = self.netloft(*words).out
        self.assertRegex(told, rf"headline height +{gear['figures']['mouth/headline_height']:.6g}")
        self.assertRegex(told, r"top-wing +0\.\d{3} +0\.\d{3} +0\.\d{3}")

    def test_what_holds_the_gear_carries_its_drag_friction_and_weight(self):
        report = self.netloft("run", FLUME, "--set", "gear.nodes=400", "--json").json()
        figures, held = report["gear"]["figures"], [h["force"] for h in report["hold_forces"]]
        drag = figures["drag/all/x"]
        self.assertGreater(figures["ground/friction_x"], 0, "the belt passes aft")
        self.assertAlmostEqual(drag + figures["ground/friction_x"], -2 * sum(f[0] for f in held), delta=1e-3 * drag)
        down = figures["weight_in_water/all"] - figures["drag/all/z"] - figures["ground/force"]
        self.assertAlmostEqual(down, 2 * sum(f[2] for f in held), delta=1e-3 * drag)

    def test_a_cod_end_lies_aft_of_its_ring(self):
        report = self.netloft("run", CODEND, "--json").json()
        exact = {"length": 8.897802, "largest_radius": 1.536439}  # scenes/verification/codend-with-catch.toml
        for name, value in exact.items():
            self.assertAlmostEqual(report["results"][name], value, delta=0.01 * value)
        self.assertAlmostEqual(report["gear"]["figures"]["drag/all/x"], 7275.728, delta=0.03 * 7275.728)


if __name__ == "__main__":
    unittest.main()
