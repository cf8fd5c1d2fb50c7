#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of a frame (an output) of a motion in processor time of the whole program, the result at the end included.

    frames.py NETLOFT SOURCE_FOLDER [PAIRS]

The panel of gear-library/scenes/dynamics/panel-in-current.toml in 31 x 31 cells, 1024 nodes, moves for the same time in the same
steps with many frames and with two frames, in turn, on one thread. The cost of a frame is the difference between the least times of
both kinds of runs, divided by the difference in frames; beside it is printed the scatter of the times of one kind, divided likewise.

between steps         frames at times between the ends of two steps (dense output)
at ends, implicit     equal steps of generalized-alpha, a frame at the end of every step
at ends, explicit     steps of central differences, limited by stability and equal to the longest allowed step, a frame at the end
                      of every fourth step
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import processor_time  # noqa: E402

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
PAIRS = int(sys.argv[3]) if len(sys.argv) > 3 else 5
SCENE = SOURCE / "gear-library" / "scenes" / "dynamics" / "panel-in-current.toml"
WAYS = {
    "between steps": ({"duration": 0.1, "dense": "true"}, 1e-4),
    "at ends, implicit": ({"duration": 0.3, "adaptive": "false", "step": 1e-3}, 1e-3),
    "at ends, explicit": ({"integrator": "central-difference", "duration": 0.02, "step": 2e-5, "longest_step": 2e-5}, 8e-5),
}


def run(folder, settings, interval):
    """Returns processor time of the program [s], number of frames and number of steps."""
    words = [NETLOFT, "run", SCENE, "--json", "--threads", "1", "--overwrite", "-o", Path(folder) / "out.hdf",
             "--set", "parts.net.cells=[31,31]", "--set", f"analysis.output_interval={interval}"]
    for key, value in settings.items():
        words += ["--set", f"analysis.{key}={value}"]
    before = processor_time.of_children()
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    spent = processor_time.of_children() - before
    if done.returncode:
        raise SystemExit(done.stderr + done.stdout)
    answer = json.loads(done.stdout)
    return spent, answer["outputs"], answer["steps"]


def measure(folder, settings, interval):
    """Returns milliseconds per frame, scatter of runs of one kind per frame, number of frames and of steps."""
    with_frames, without = [], []
    for _ in range(PAIRS):
        many, frames, steps = run(folder, settings, interval)
        few, ends, same = run(folder, settings, 0)
        assert steps == same or settings.get("dense"), "both go through time in the same steps"
        with_frames.append(many), without.append(few)
    apart = max(max(times) - min(times) for times in (with_frames, without))
    return [1e3 * seconds / (frames - ends) for seconds in (min(with_frames) - min(without), apart)], frames, steps


if __name__ == "__main__":
    os.environ |= {"OMP_NUM_THREADS": "1", "OMP_THREAD_LIMIT": "1"}
    print("| frames | how many | steps | ms a frame | runs apart |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as there:
        for name, (how, every) in WAYS.items():
            (cost, apart), number, taken = measure(there, how, every)
            print(f"| {name} | {number} | {taken} | {cost:.2f} | {apart:.2f} |", flush=True)
