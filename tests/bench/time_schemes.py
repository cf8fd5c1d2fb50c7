#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares time schemes: the stability limits of explicit ones, and the CPU time that each takes for an error.

    time_schemes.py NETLOFT SOURCE_FOLDER limits|factor|panel
    time_schemes.py NETLOFT SOURCE_FOLDER work [FILE.svg]

limits   longest stable step of the paper's fixed-point scheme, predicted and found, on the paper's two panels
work     CPU seconds against the error of a path, all schemes on the same three scenes
factor   simulated time over CPU time, for a trawl and a panel of 5000 nodes and for a smaller panel
panel    CPU seconds of the whole program, frames included, for the panel of 20 x 20 meshes, which takes MoorDyn 64.3 s
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import processor_time  # noqa: E402

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
SCENES = SOURCE / "gear-library" / "scenes"
FOLDER = tempfile.TemporaryDirectory()
FIXED_POINT = ["analysis.integrator=newmark", "analysis.newmark.corrector=fixed-point"]


def run(scene, *settings, check=False, options=()):
    """Returns the answer of the program, and the time series of its result file."""
    output = Path(FOLDER.name) / "out.hdf"
    output.unlink(missing_ok=True)
    words = [NETLOFT, "run", SCENES / scene, "--json", "-o", output, *options]
    for setting in settings:
        words += ["--set", setting]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if not output.exists() or (check and done.returncode):
        raise SystemExit(done.stderr + done.stdout)
    with h5py.File(output) as f:
        series = {name: data[()] for name, data in f["netloft/series"].items() if isinstance(data, h5py.Dataset)}
    return json.loads(done.stdout), series


def found_limit(scene, settings, predicted):
    """Returns, within 2 %, the longest step with which 20 steps converge after a current sets in at the equilibrium."""
    low, high = 0.25 * predicted, 4 * predicted
    while high / low > 1.02:
        h = (low * high) ** 0.5
        answer, _ = run(scene, *settings, "analysis.adaptive=false", f"analysis.step={h}",
                        f"analysis.duration={20 * h}", "analysis.newmark.corrections=200")
        low, high = (h, high) if answer["status"] == "finished" else (low, h)
    return low


def print_limits():
    print("scene                 cells   predicted [s]   found [s]")
    for scene, sizes in (("dead-weight-panel.toml", (16, 32, 64)),
                         ("verification/stretched-panel.toml", (8, 16, 32))):
        for n in sizes:
            settings = ["analysis.kind=dynamic", *FIXED_POINT, f"parts.net.cells=[{n},{n}]",
                        "analysis.start=equilibrium", "analysis.output_interval=0", "analysis.energy_budget=false",
                        "water.current={ t = [0, 1e-9], x = [0, 1], y = [0, 1] }"]  # sets it in motion
            answer, _ = run(scene, *settings, "analysis.adaptive=false", "analysis.step=1e-9",
                            "analysis.duration=1e-9")
            predicted = answer["stable_step"]
            found = found_limit(scene, settings, predicted)
            print(f"{Path(scene).stem:20} {n:6} {predicted:15.3g} {found:11.3g}", flush=True)


PATHS = {"pendulum-of-bars.toml": ("end_x", "end_z"), "released-rope.toml": ("end_x", "end_z"),
         "panel-in-current.toml": ("corner_x", "corner_z"), "hanging-panel.toml": ("corner_x", "corner_z")}
SECONDS = {"pendulum-of-bars.toml": 2, "released-rope.toml": 2, "panel-in-current.toml": 1, "hanging-panel.toml": 1}
CENTRAL = ["analysis.integrator=central-difference"]
SCHEMES = {
    "generalized-alpha": (["analysis.integrator=generalized-alpha"], [1e-1, 1e-2, 1e-3]),
    "gen.-alpha, radius 0.8": (["analysis.integrator=generalized-alpha",
                                "analysis.generalized-alpha.spectral_radius=0.8"], [1e-1, 1e-2, 1e-3]),
    "newmark": (["analysis.integrator=newmark"], [1e-1, 1e-2, 1e-3]),
    "newmark, chi -0.3": (["analysis.integrator=newmark", "analysis.newmark.chi=-0.3"], [1e-1, 1e-2, 1e-3]),
    "newmark, fixed-point": (FIXED_POINT, [1e-1]),
    "central-difference": (CENTRAL, [1e-1]),
}
GOOD = 1e-2  # error for which step lengths are compared


def path_of(series, names):
    return np.array([series[name] for name in names]).T


def path_error(path, reference):
    """Returns the largest distance between two paths at equal times, over the extent of the path."""
    return np.linalg.norm(path - reference, axis=1).max() / np.ptp(reference, axis=0).max()


def measure(scene):
    """Returns scheme, accuracy, mean step [s], CPU time [s] and error of every complete run, and messages of the others."""
    names, seconds = PATHS[scene], SECONDS[scene]
    common = ["analysis.energy_budget=false", "analysis.dense=true", "analysis.tolerance=1e-4", f"analysis.duration={seconds}"]
    answer, series = run("dynamics/" + scene, *common, *CENTRAL, check=True)
    fine = 0.25 * answer["longest_step"]  # central differences with steps far below the stability limit
    _, series = run("dynamics/" + scene, *common, *CENTRAL, "analysis.adaptive=false", f"analysis.step={fine}", check=True)
    reference, rows, failures = path_of(series, names), [], []
    for scheme, (settings, accuracies) in SCHEMES.items():
        for accuracy in accuracies:
            answer, series = run("dynamics/" + scene, *common, *settings, f"analysis.accuracy={accuracy}", "analysis.max_seconds=60")
            if answer["status"] == "finished":
                rows.append((scheme, accuracy, seconds / answer["steps"], answer["cpu_seconds"],
                             path_error(path_of(series, names), reference)))
            else:
                failures.append(f"{scheme} at {accuracy:.0e}: {answer['reason']}, in {answer['cpu_seconds']:.3g} CPU s")
    return rows, failures


def print_work(plot):
    """Prints the table of `work` as Markdown, for the README of the scenes."""
    found = {}
    print("| scene | scheme | accuracy | mean step [s] | over the fixed point's | CPU s | error |\n|---|---|---|---|---|---|---|")
    for scene in PATHS:
        found[scene], failures = measure(scene)
        paper = next((row[2] for row in found[scene] if row[0] == "newmark, fixed-point"), float("nan"))
        for scheme, accuracy, step, cpu, error in found[scene]:
            print(f"| {Path(scene).stem} | {scheme} | {accuracy:.0e} | {step:.1e} | {step / paper:.3g} | {cpu:.3g} | {error:.1e} |", flush=True)
        for failure in failures:
            print(f"| {Path(scene).stem} | {failure} | | | | | |", flush=True)
        good = max((row for row in found[scene] if row[4] <= GOOD), key=lambda row: row[2])
        print(f"{Path(scene).stem}: the longest steps within {GOOD:.0%} are those of {good[0]}, {good[2] / paper:.3g} times the fixed point's", file=sys.stderr, flush=True)
    if plot:
        draw(found, plot)


def draw(found, file):
    """Draws errors over mean steps and over CPU time, one column per scene."""
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    matplotlib.rcParams["svg.hashsalt"] = "netloft"
    figure, axes = plt.subplots(2, len(found), figsize=(4 * len(found), 7), sharey=True)
    for column, (scene, rows) in zip(axes.T, found.items()):
        for axis, value, label in zip(column, (2, 3), ("mean step [s]", "CPU time [s]")):
            for scheme in SCHEMES:
                points = sorted((row[value], row[4]) for row in rows if row[0] == scheme)
                if points:
                    axis.loglog(*zip(*points), "o-", label=scheme)
            axis.axhline(GOOD, color="grey", linewidth=0.8)
            axis.set_xlabel(label)
            axis.grid(True, alpha=0.3)
        column[0].set_title(Path(scene).stem)
    for row in axes:
        row[0].set_ylabel("error of the path")
    axes[0, -1].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None})


def print_factor():
    """Prints the table of `factor`. Errors are those against a far more accurate run."""
    panel, trawl = "dynamics/panel-in-current.toml", "dynamics/trawl-speeds-up.toml"
    for name, scene, names, settings, fine in (
            ("trawl of 5000 nodes", trawl, ("mouth_x", "mouth_y", "mouth_height"), [], ["analysis.accuracy=5e-4", "analysis.tolerance=1e-4"]),
            ("panel, 20 x 20 meshes", panel, PATHS["panel-in-current.toml"], [], ["analysis.accuracy=1e-3"]),
            ("panel, 5000 nodes", panel, PATHS["panel-in-current.toml"], ["parts.net.cells=[70,70]"], ["analysis.accuracy=1e-3"])):
        common = [*settings, "analysis.energy_budget=false"]
        _, series = run(scene, *common, *fine, check=True)
        reference = path_of(series, names)
        for accuracy in (3e-1, 1e-1, 3e-2):
            answer, series = run(scene, *common, f"analysis.accuracy={accuracy}", check=True)
            print(f"{name:22} accuracy {accuracy:6.0e}: error {path_error(path_of(series, names), reference):7.1e}, "
                  f"{answer['steps']} steps, {answer['cpu_seconds']:.3g} CPU s, "
                  f"real-time factor {answer['real_time_factor']:.3g}", flush=True)


MOORDYN = 64.3  # CPU seconds of MoorDyn for 5 s of the same panel


def print_panel():
    """Prints the least CPU time of five runs with generalized-alpha on one thread; only the accuracy of the scene is changed."""
    panel, names = "dynamics/panel-in-current.toml", PATHS["panel-in-current.toml"]
    _, series = run(panel, "analysis.accuracy=1e-4", "analysis.tolerance=1e-4", check=True, options=("--threads", "1"))
    reference = path_of(series, names)
    print("| accuracy | steps | iterations | error | CPU s | MoorDyn's over it |\n|---|---|---|---|---|---|")
    for accuracy in (3e-2, 1e-2, 9e-3, 5e-3):
        seconds = []
        for _ in range(5):
            before = processor_time.of_children()
            answer, series = run(panel, f"analysis.accuracy={accuracy}", check=True, options=("--threads", "1"))
            seconds.append(processor_time.of_children() - before)
        print(f"| {accuracy:g} | {answer['steps']} | {answer['iterations']} | {path_error(path_of(series, names), reference):.2%} "
              f"| {min(seconds):.3f} | {MOORDYN / min(seconds):.0f} |", flush=True)


if __name__ == "__main__":
    if sys.argv[3] == "limits":
        print_limits()
    elif sys.argv[3] == "panel":
        print_panel()
    elif sys.argv[3] == "work":
        print_work(sys.argv[4] if len(sys.argv) > 4 else None)
    else:
        print_factor()
