#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures errors of motions against the requested `accuracy`, and counts motions that end right, wrong or lost, by time scheme.

    motions.py NETLOFT SOURCE_FOLDER [--scenes snap,chain] [--schemes "newmark|arkode"] [--accuracies 1e-1,1e-2,1e-3,1e-4]
               [--seconds 120]

Prints two tables as Markdown. Errors are those of the worst node at any output, and of one typical node (the ball, an end, a
corner), over the extent of all paths, against a reference run of the energy-momentum scheme at a tenth of the finest accuracy;
`reference` is the difference of generalized-alpha from the reference at the same accuracy. The order is the slope of the second
error. Every motion is checked (`check = true`), so that the program reports an error of its path: `*` marks motions whose reported
error is larger than requested. `made` is the energy that the scheme created, over the energy that was put in.

A motion whose reported error is as small as requested has ended right if no node deviates by more at any output, over the longest
element, and wrong if a node does. Schemes that report that they leave out material damping are compared with a reference without it.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import h5py
import numpy as np

SCHEMES = {
    "generalized-alpha": [], "gen.-alpha, radius 0.8": ["analysis.generalized-alpha.spectral_radius=0.8"],
    "newmark": [], "central-difference": [], "energy-momentum": [], "arkode": [],
}
UNDAMPED = {"central-difference"}  # explicit: it leaves out material damping, and reports it
WATCHED = {"snap": 4, "chain": 16, "heave": 10, "gust": -1, "bars": -1, "panel": -1}  # the typical node of a scene


def run(asked, scene, scheme, accuracy, folder, more=()):
    """Returns the answer as JSON, or the message of a run that failed, and the positions of nodes by output."""
    out = Path(folder) / "out.hdf"
    name = "generalized-alpha" if scheme.startswith("gen") else scheme
    words = [asked.netloft, "run", scene, "--json", "--threads", "1", "--overwrite", "-o", out]
    for setting in [f"analysis.integrator={name}", f"analysis.accuracy={accuracy}", f"analysis.max_seconds={asked.seconds}",
                    *SCHEMES[scheme], *more]:
        words += ["--set", setting]
    ended = subprocess.run(words, capture_output=True, text=True, check=False)
    try:
        answer = json.loads(ended.stdout)
    except json.JSONDecodeError:
        return {"status": "refused", "reason": (ended.stderr.strip() or "no words").splitlines()[0]}, None
    if "steps" not in answer:
        return {"status": "refused", "reason": answer["reason"]}, None
    answer["exit_code"] = ended.returncode
    if answer["status"] != "finished":
        return answer, None
    with h5py.File(answer["output"]) as f:
        points, count = f["VTKHDF/Points"][()], f["VTKHDF/NumberOfPoints"][0]
        return answer, np.array([points[first:first + count] for first in f["VTKHDF/Steps/PointOffsets"][()]])


def extent(paths):
    return np.linalg.norm(paths.max(axis=0) - paths.min(axis=0), axis=-1).max()


def error(paths, reference, node):
    """Returns the error of the worst node and that of the typical node [m]."""
    all_nodes = np.linalg.norm(paths - reference, axis=-1)
    return all_nodes.max(), all_nodes[:, node].max()


def made(answer):
    """Returns the energy that the scheme created over the energy that was put in [1], or None if it is not known."""
    loss = answer.get("numerical_loss")
    return max(0.0, -loss["lost"]) / loss["given"] if loss and loss["given"] else None


def row(asked, file, scheme, accuracies, folder, reference, count):
    """Returns the cells of a scheme in one scene, and adds how its motions ended to `count`."""
    errors, most, cells, cpu, size = [], 0.0, [], 0.0, extent(reference)
    for accuracy in accuracies:
        answer, paths = run(asked, file, scheme, accuracy, folder, ["analysis.check=true"])
        cpu = answer.get("cpu_seconds", 0)
        if answer["status"] == "refused":
            return "not built |"
        if paths is None:
            cells.append("lost")
            count["said lost"] += 1
            continue
        worst, watched = error(paths, reference, WATCHED[file.stem])
        errors.append((float(accuracy), watched / size))
        most = max(most, made(answer) or 0)
        claims = answer["accuracy"]["path"]["reached"]
        assert claims == (answer["exit_code"] == 0)
        is_right = worst <= float(accuracy) * answer["accuracy"]["longest_element"]
        count["said inaccurate" if not claims else "finished right" if is_right else "finished wrong"] += 1
        cells.append(f"{worst / size:.0e}, {watched / size:.0e}{'' if claims else ' *'}{' **wrong**' if claims and not is_right else ''}")
    order = f"{np.polyfit(*np.log10(np.array(errors)).T, 1)[0]:.2f}" if len(errors) > 1 else "-"
    return " | ".join(cells) + f" | {order} | {most:.0e} | {cpu:.2g} |"


OUTCOMES = ("finished right", "finished wrong", "said inaccurate", "said lost")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("netloft")
    words.add_argument("source", type=Path)
    words.add_argument("--scenes", default=",".join(WATCHED))
    words.add_argument("--schemes", default="|".join(SCHEMES))
    words.add_argument("--accuracies", default="1e-1,1e-2,1e-3,1e-4")
    words.add_argument("--seconds", type=float, default=120, help="limit of processor time for a run")
    asked = words.parse_args()
    accuracies = asked.accuracies.split(",")
    schemes = asked.schemes.split("|")
    counts = {scheme: dict.fromkeys(OUTCOMES, 0) for scheme in schemes}
    print("| scene | scheme | " + " | ".join(accuracies) + " | order | made | CPU s at the finest |")
    print("|---|---|" + "---|" * (len(accuracies) + 3))
    with tempfile.TemporaryDirectory() as folder:
        for scene in asked.scenes.split(","):
            file = asked.source / "tests" / "bench" / "motions" / (scene + ".toml")
            finest = f"{0.1 * float(accuracies[-1]):.0e}"
            answer, reference = run(asked, file, "energy-momentum", finest, folder)
            if reference is None:
                print(f"| {scene} | reference: {answer['reason']} |", flush=True)
                continue
            other = run(asked, file, "generalized-alpha", finest, folder)[1]
            apart = "lost" if other is None else "{:.0e}, {:.0e}".format(*(e / extent(reference) for e in error(other, reference, WATCHED[scene])))
            print(f"| {scene} | reference, {answer['steps']} steps | {apart} |", flush=True)
            undamped = None
            for scheme in schemes:
                like = reference
                if scheme in UNDAMPED:
                    if undamped is None:
                        undamped = run(asked, file, "energy-momentum", finest, folder, ["analysis.material_damping=false"])[1]
                    like = undamped
                print(f"| {scene} | {scheme} | " + row(asked, file, scheme, accuracies, folder, like, counts[scheme]), flush=True)
    print("\n| scheme | " + " | ".join(OUTCOMES) + " |\n|---" * 1 + "|---" * len(OUTCOMES) + "|")
    for scheme, count in counts.items():
        print(f"| {scheme} | " + " | ".join(str(count[outcome]) for outcome in OUTCOMES) + " |")


if __name__ == "__main__":
    main()
