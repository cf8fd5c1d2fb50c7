#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time schemes side by side: where explicit ones lose their stability, and what an error costs with each.

    time_schemes.py NETLOFT SOURCE_FOLDER limits|factor
    time_schemes.py NETLOFT SOURCE_FOLDER work [FILE.svg]

limits   predicted and found longest step of the paper's fixed point, on the paper's two panels
work     CPU seconds against the error of a path, all schemes on the same three scenes
factor   the panel of 20 x 20 meshes, and a gear of 5000 nodes: time that passes over time that it takes
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

NETLOFT, SOURCE = sys.argv[1], Path(sys.argv[2])
SCENES = SOURCE / "gear-library" / "scenes"
FOLDER = tempfile.TemporaryDirectory()
FIXED_POINT = ["analysis.integrator=newmark", "analysis.newmark.corrector=fixed-point"]


def run(scene, *settings, check=False):
    """The answer of the program, and the series of its file."""
    output = Path(FOLDER.name) / "out.hdf"
    output.unlink(missing_ok=True)
    words = [NETLOFT, "run", SCENES / scene, "--json", "-o", output]
    for setting in settings:
        words += ["--set", setting]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if not output.exists() or (check and done.returncode):
        raise SystemExit(done.stderr + done.stdout)
    with h5py.File(output) as f:
        series = {name: data[()] for name, data in f["netloft/series"].items() if isinstance(data, h5py.Dataset)}
    return json.loads(done.stdout), series


def found_limit(scene, settings, predicted):
    """Longest step with which 20 steps settle, from the equilibrium and in a current that sets in, within 2 %."""
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


PATHS = {"released-rope.toml": ("end_x", "end_z"), "panel-in-current.toml": ("corner_x", "corner_z"),
         "hanging-panel.toml": ("corner_x", "corner_z")}
SCHEMES = {
    "generalized-alpha": (["analysis.integrator=generalized-alpha"], [1e-1, 1e-2, 1e-3]),
    "newmark": (["analysis.integrator=newmark"], [1e-1, 1e-2, 1e-3]),
    "newmark, chi -0.3": (["analysis.integrator=newmark", "analysis.newmark.chi=-0.3"], [1e-1, 1e-2, 1e-3]),
    "newmark, fixed-point": (FIXED_POINT, [1e-1]),
    "central-difference": (["analysis.integrator=central-difference"], [1e-1]),
}


def path_of(series, names):
    return np.array([series[name] for name in names]).T


def path_error(path, reference):
    """Largest distance between two paths at equal times, over the extent of the way."""
    return np.linalg.norm(path - reference, axis=1).max() / np.ptp(reference, axis=0).max()


def print_work(plot):
    rows = []
    print("scene              scheme                 accuracy    steps   longest [s]    CPU s    error")
    for scene, names in PATHS.items():
        common = ["analysis.energy_budget=false", "analysis.duration=1"]
        _, series = run("dynamics/" + scene, *common, "analysis.integrator=generalized-alpha",
                        "analysis.accuracy=1e-4", check=True)
        reference = path_of(series, names)
        for scheme, (settings, accuracies) in SCHEMES.items():
            for accuracy in accuracies:
                answer, series = run("dynamics/" + scene, *common, *settings, f"analysis.accuracy={accuracy}",
                                     "analysis.max_seconds=30")
                head = f"{Path(scene).stem:18} {scheme:22} {accuracy:8.0e}"
                if answer["status"] != "finished":
                    print(head, " ", answer["reason"], f"in {answer['cpu_seconds']:.3g} CPU s", flush=True)
                    continue
                error = path_error(path_of(series, names), reference)
                rows.append((scene, scheme, answer["cpu_seconds"], error))
                print(head, f"{answer['steps']:8} {answer['longest_step']:13.2e} {answer['cpu_seconds']:8.3g} "
                      f"{error:8.1e}", flush=True)
    if plot:
        draw(rows, plot)


def draw(rows, file):
    import matplotlib
    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, len(PATHS), figsize=(12, 4), sharey=True)
    for axis, scene in zip(axes, PATHS):
        for scheme in SCHEMES:
            points = sorted((cpu, error) for s, name, cpu, error in rows if s == scene and name == scheme)
            if points:
                axis.loglog(*zip(*points), "o-", label=scheme)
        axis.set_title(Path(scene).stem)
        axis.set_xlabel("CPU s")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].set_ylabel("error of the path")
    axes[-1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file)


def print_factor():
    """Errors against a run that is far more accurate."""
    scene, names = "dynamics/panel-in-current.toml", PATHS["panel-in-current.toml"]
    for name, settings in {"20 x 20 meshes": [], "5000 nodes": ["parts.net.cells=[70,70]"]}.items():
        common = [*settings, "analysis.energy_budget=false"]
        _, series = run(scene, *common, "analysis.accuracy=1e-3", check=True)
        reference = path_of(series, names)
        for accuracy in (1, 3e-1, 1e-1, 3e-2, 1e-2):
            answer, series = run(scene, *common, f"analysis.accuracy={accuracy}", check=True)
            print(f"{name:16} accuracy {accuracy:6.0e}: error {path_error(path_of(series, names), reference):7.1e}, "
                  f"{answer['steps']} steps, {answer['cpu_seconds']:.3g} CPU s, "
                  f"real-time factor {answer['real_time_factor']:.3g}", flush=True)


if __name__ == "__main__":
    if sys.argv[3] == "limits":
        print_limits()
    elif sys.argv[3] == "work":
        print_work(sys.argv[4] if len(sys.argv) > 4 else None)
    else:
        print_factor()
