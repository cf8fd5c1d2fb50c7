#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What several ranks gain and save: one factorisation of a panel by one process and by ranks of MPI.

    ranks.py BUILD/bin/bench_ranks [--cells 316,577] [--ranks 1,2] [--foresee 4,16,64] [--repeats 3]

Prints, for each size and class of matrix, wall clock of analysis, factorisation and solution, what memory the rank that takes most
grew by, and what was foreseen for it. --foresee adds what is foreseen for more ranks, by analyses alone. Then what the ranks gain on evaluations, rank 0 alone and all of them by turns. Then a fit of
  T(n) = T(1) (s + (1 − s) / n),   T(1) of one process
to the factorisations (Amdahl 1967), and what it says of 64 ranks. A rank needs a processor: with fewer, times mean nothing.
"""
import argparse
import json
import os
import subprocess
import sys


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cells", default="316,577", help="cells along one side; 3·CELLS² unknowns")
    parser.add_argument("--ranks", default="2")
    parser.add_argument("--foresee", default="")
    parser.add_argument("--repeats", type=int, default=3)
    return parser.parse_args()


def numbers(text):
    return [int(word) for word in text.split(",") if word]


def measure(options, cells, kind, ranks, repeats, how="ranks"):
    """`how`: by MUMPS, or with the same bits. Negative `ranks`: the factorisation of one process by so many threads, without MPI."""
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    launcher = ["mpirun", *as_root, "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks > 0 else []
    ended = subprocess.run([*launcher, options.program, str(cells), kind, how if ranks > 0 else str(-ranks), str(repeats)],
                           capture_output=True, text=True, env={**os.environ, "OMP_THREAD_LIMIT": "1"})
    if ended.returncode:
        sys.exit(ended.stdout + ended.stderr)
    lines = [json.loads(line) for line in ended.stdout.splitlines()]
    facts = next(line for line in lines if "what" in line)
    facts["evaluation"] = next((line for line in lines if "with_tangent" in line), None)
    facts["grown"] = max(line["grown_bytes"] for line in lines if "grown_bytes" in line)
    return facts


def row(facts, kind, who):
    print(f"| {facts['unknowns']} | {kind} | {who} | {facts['analyse']:.2f} | {facts['factorise']:.2f} | {facts['solve']:.3f} | "
          f"{facts['grown'] / 1e6:.0f} | {facts['foreseen_bytes'] / 1e6:.0f} | {facts['error']:.0e} |", flush=True)


def evaluation_row(facts, kind, ranks):
    alone_and_shared = ["{:.4f}, {:.4f}: × {:.2f}".format(*facts[key], facts[key][0] / facts[key][1])
                        for key in ("make", "residual", "with_tangent")]
    return f"| {facts['unknowns']} | {kind} | {ranks} | " + " | ".join(alone_and_shared) + " |"


def name_of(facts):
    return facts["what"].split(",")[0]


def serial_fraction(ranks, ratio):
    """s of T(n)/T(1) = s + (1 − s) / n."""
    return (ratio - 1 / ranks) / (1 - 1 / ranks)


def fit(of_ranks, key):
    one, n = of_ranks[1][key], max(of_ranks)
    s = min(max(serial_fraction(n, of_ranks[n][key] / one), 0), 1)
    return s, one * (s + (1 - s) / 64)


def main():
    options = arguments()
    print("| unknowns | matrix | who | analysis [s] | factorisation [s] | solution [s] | grown by [MB] | foreseen [MB] | error |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    fits, foreseen, evaluations = [], [], []
    for cells in numbers(options.cells):
        for kind in ("definite", "unsymmetric"):
            alone = measure(options, cells, kind, -1, options.repeats)
            row(alone, kind, name_of(alone))
            if kind == "unsymmetric":
                row(measure(options, cells, kind, -2, options.repeats), kind, name_of(alone) + ", 2 threads")
            for how in ("ranks", "same-bits"):
                of_ranks = {1: alone}
                for ranks in numbers(options.ranks):
                    of_ranks[ranks] = measure(options, cells, kind, ranks, options.repeats, how)
                    row(of_ranks[ranks], kind, name_of(of_ranks[ranks]))
                    if how == "ranks" and of_ranks[ranks]["evaluation"]:
                        evaluations.append(evaluation_row(of_ranks[ranks]["evaluation"], kind, ranks))
                if max(of_ranks) == 1:
                    continue
                seconds, memory = fit(of_ranks, "factorise"), fit(of_ranks, "foreseen_bytes")
                fits.append(f"{alone['unknowns']} {kind}, {name_of(of_ranks[max(of_ranks)])}: s = {seconds[0]:.2f} of time, 64 ranks "
                            f"{seconds[1]:.2f} s; s = {memory[0]:.2f} of memory, 64 ranks {memory[1] / 1e6:.0f} MB")
            for ranks in numbers(options.foresee):
                for how in ("ranks", "same-bits"):
                    facts = measure(options, cells, kind, ranks, 0, how)
                    foreseen.append(f"{facts['unknowns']} {kind}: {name_of(facts)}, foreseen {facts['foreseen_bytes'] / 1e6:.0f} MB")
    print("\n".join(["", "| unknowns | matrix | ranks | made [s] | residual [s] | with its tangent [s] |", "| --- | --- | --- | --- | --- | --- |",
                     *evaluations, "", *fits, *foreseen]))


if __name__ == "__main__":
    main()
