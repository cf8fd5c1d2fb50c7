#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the cost of a study of thousands of points, and compares the tables that different engines make of it.

    large_study.py NETLOFT STUDY.toml [--samples 50] [--nodes 300] [--set KEY=VALUE] [--jobs 2] [--engines pool,parallel,slurm] [--points-of 2]

Prints, for every engine, points, wall time, the sum of processor time over the jobs, the load of the machine before the run, and
whether table.csv and table.hdf are the same bits as those of the first engine. With --points-of N, the first N samples are solved
again with every point solved separately, and the factorisations are compared with those along paths.
"""
import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS / "regression/cli"), str(TESTS / "support")]
import local_slurm  # noqa: E402
import processor_time  # noqa: E402


def call(*words, code=(0,), **how):
    ended = subprocess.run(words, capture_output=True, text=True, **how)
    if ended.returncode not in code:
        sys.exit(f"{' '.join(map(str, words))}\nended with {ended.returncode}\n{ended.stdout}{ended.stderr}")
    return ended.stdout


def write_study(options, folder, samples, alone=False):
    """Writes a copy of the study file with another number of samples and of nodes."""
    text = options.study.read_text()
    scene = (options.study.parent / re.search(r'^scene = "(.*)"', text, re.MULTILINE)[1]).resolve()
    sets = ", ".join(f'"{word}"' for word in [f"gear.nodes={options.nodes}", *options.set] if options.nodes)
    text = re.sub(r"^scene = .*", f'scene = "{scene}"' + ("\npath = []" if alone else ""), text, flags=re.MULTILINE)
    text = re.sub(r"^set = .*", f"set = [{sets}]", text, flags=re.MULTILINE) if sets else text
    text = re.sub(r"^samples = .*", f'samples = {samples}\nsampling = "sobol"', text, flags=re.MULTILINE)
    folder.mkdir()
    (folder / "s.toml").write_text(text)
    call(options.netloft, "study", "plan", "s.toml", cwd=folder)


def by_pool(options, folder):
    call(options.netloft, "study", "run", "s.study", "--jobs", str(options.jobs), cwd=folder)


def by_parallel(options, folder):
    call(options.netloft, "study", "submit", "s.study", "--engine", "parallel", "--jobs", str(options.jobs), cwd=folder)
    call("bash", "parallel.sh", cwd=folder / "s.study", code=(0, 3), stdin=subprocess.DEVNULL,
         env={**os.environ, "HOME": str(folder)})  # 3: some points have no stable equilibrium


def by_slurm(options, folder):
    """Runs the study by Slurm. The time of Slurm's daemons counts, because they belong to the engine."""
    slurm = local_slurm.LocalSlurm(str(folder / "slurm"))
    try:
        if why_not := slurm.start():
            return why_not
        chunk = max(1, options.samples // (4 * options.jobs))
        call(options.netloft, "study", "submit", "s.study", "--engine", "slurm", "--chunk", str(chunk), cwd=folder)
        call(local_slurm.find("sbatch"), "slurm.sh", cwd=folder / "s.study",
             env={**os.environ, "SLURM_CONF": slurm.environment["SLURM_CONF"]})
        while call(options.netloft, "study", "missing", "s.study", cwd=folder, code=(0, 1, 3)).strip():
            time.sleep(0.5)  # sbatch --wait would look only every half minute
    finally:
        slurm.stop()
    return ""


ENGINES = {"pool": by_pool, "parallel": by_parallel, "slurm": by_slurm}


def rows_of(folder):
    with open(folder / "s.study/table.csv", newline="") as f:
        return list(csv.DictReader(f))


def cost_of(folder):
    """Returns the processor time of all items, as the items report it [s]."""
    with open(folder / "s.study/costs.csv", newline="") as f:
        return sum(float(row["cpu [s]"]) for row in csv.DictReader(f))


def compute(options, folder, engine):
    load, cpu, wall = os.getloadavg()[0], processor_time.of_children(), time.monotonic()
    if why_not := ENGINES[engine](options, folder):
        return print(f"{engine:<9} {why_not}")
    wall = time.monotonic() - wall
    cpu = processor_time.of_children() - cpu
    call(options.netloft, "study", "collect", "s.study", cwd=folder, code=(0, 1, 3))
    items = cost_of(folder)
    sum_of_cpu = max(cpu, items)  # processes that Slurm starts are not children of this one
    converged = sum(row["status"] == "converged" for row in rows_of(folder))
    print(f"{engine:<9} {len(rows_of(folder)):>6} {converged:>9} {wall:>8.1f} {sum_of_cpu:>8.1f} {items:>9.1f} "
          f"{wall * options.jobs / sum_of_cpu:>10.2f} {load:>6.1f}", end="", flush=True)
    return [(folder / "s.study" / name).read_bytes() for name in ("table.csv", "table.hdf")]


def compare_engines(options, folder):
    print(f"{'engine':<9} {'points':>6} {'converged':>9} {'wall [s]':>8} {'CPU [s]':>8} {'items [s]':>9} {'wall·jobs/CPU':>10} {'load':>6}  table")
    first = None
    for engine in options.engines.split(","):
        write_study(options, folder / engine, options.samples)
        table = compute(options, folder / engine, engine)
        if table:
            first = first or table
            print("  the same" if table == first else "  ANOTHER", flush=True)
            if table != first:
                sys.exit(1)


def factorisations_by_draw(rows):
    sums = {}
    for row in rows:
        sums[row["sample"]] = sums.get(row["sample"], 0) + int(row["factorisations"])
    return sums.values()


def compare_points(options, folder):
    """Compares the factorisations of the same samples along paths and with every point solved separately."""
    counts = {}
    for name, alone in (("path", False), ("points", True)):
        write_study(options, folder / name, options.points_of, alone)
        by_pool(options, folder / name)
        call(options.netloft, "study", "collect", "s.study", cwd=folder / name, code=(0, 1, 3))
        rows = rows_of(folder / name)
        of_samples = factorisations_by_draw(rows)
        counts[name] = sum(of_samples)
        print(f"{name:<9} {len(rows):>6} points, {counts[name]:>7} factorisations, {cost_of(folder / name):.1f} s of CPU, "
              f"{sum(row['status'] != 'converged' for row in rows)} without a stable equilibrium, "
              f"{min(of_samples)} to {max(of_samples)} for a sample")
    print(f"points over path: {counts['points'] / counts['path']:.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("study", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=50)
    parser.add_argument("--nodes", type=int, default=0, help="of the gear; 0: as the study says")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--engines", default="pool,parallel,slurm")
    parser.add_argument("--points-of", type=int, default=0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        compare_engines(options, pathlib.Path(name))
        if options.points_of:
            compare_points(options, pathlib.Path(name))


if __name__ == "__main__":
    main()
