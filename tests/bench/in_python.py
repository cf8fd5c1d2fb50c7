#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what the package of Python costs beside the computation: its import, a solve, many solves, Ctrl-C.

    in_python.py PACKAGE [--times N] [--solves N] [--moments N]

PACKAGE is the folder that contains netloft, build/release/python. Times are processor times, the least of N; the wait after Ctrl-C is
wall time. A solve is computed in a thread of its own, so that the time of the thread that calls it is what Python adds.
"""
import argparse
import gc
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

IMPORT = "import resource as r; import sys; sys.path.insert(0, {0!r}); {1}; u = r.getrusage(r.RUSAGE_SELF); print(1e3 * (u.ru_utime + u.ru_stime))"


def import_milliseconds(package, statement):
    done = subprocess.run([sys.executable, "-c", IMPORT.format(package, statement)], check=True, capture_output=True, text=True)
    return float(done.stdout)


def solve_row(netloft, name, changes, times):
    scene = netloft.load(name).with_(changes)
    scene.solve()
    rows = []
    for i in range(times):
        everything, python = time.process_time(), time.thread_time()
        result = scene.with_({"water.density": 1025 + 1e-3 * i}).solve()
        rows.append((1e3 * (time.process_time() - everything), 1e3 * (time.thread_time() - python)))
    print(f"| {name} | {len(result.points)} | {min(row[0] for row in rows):.1f} | {min(row[1] for row in rows):.2f} |")


def memory_in_kib():
    return int(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmRSS")))


def memory_row(netloft, solves):
    rope = netloft.load("hanging-rope.toml")

    def use(number):
        for i in range(number):
            result = rope.with_({"water.density": 1025 + 1e-3 * (i % 100)}).solve()
            assert result.points.shape[1] == 3 and len(result.report) > 0
        gc.collect()
        return memory_in_kib()

    before = use(max(1, solves // 10))
    after = use(solves)
    print(f"\nresident memory after {max(1, solves // 10)} solves {before} KiB, after {solves} more {after} KiB: ratio {after / before:.4f}")


def interruption_row(netloft, nodes, moments):
    """Ctrl-C at moments that are spread over the first ten seconds of a solve: from the signal to the exception."""
    scene = netloft.load("83-112-flume-3.0kn.toml").with_({"gear.nodes": nodes})
    waits, without = [], 0
    for i in range(moments):
        sent = []
        timer = threading.Timer(10 * (i + 0.5) / moments, lambda: (sent.append(time.perf_counter()), os.kill(os.getpid(), signal.SIGINT)))
        timer.start()
        try:
            while True:
                netloft.Scene(scene.file).with_({"gear.nodes": nodes}).solve()
        except KeyboardInterrupt as interrupted:
            waits.append(1e3 * (time.perf_counter() - sent[0]))
            without += getattr(interrupted, "result", None) is None
    waits.sort()
    print(f"\nCtrl-C at {moments} moments of solves with {nodes} nodes: after {waits[len(waits) // 2]:.0f} ms in the median, {waits[-1]:.0f} ms at most; "
          f"{without} while the scene was read, when there is no shape yet")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", type=Path)
    parser.add_argument("--times", type=int, default=10)
    parser.add_argument("--solves", type=int, default=10000)
    parser.add_argument("--moments", type=int, default=10)
    options = parser.parse_args()
    package = str(options.package.resolve())
    sys.path.insert(0, package)
    import netloft

    print("| import | processor time [ms] |\n|---|---|")
    for statement in ("pass", "import numpy", "import netloft"):
        print(f"| {statement} | {min(import_milliseconds(package, statement) for _ in range(options.times)):.0f} |")
    print("\n| scene | nodes | solve [ms] | of it in Python [ms] |\n|---|---|---|---|")
    for name, changes in (("hanging-rope.toml", {}), ("dead-weight-panel.toml", {}), ("83-112-flume-3.0kn.toml", {"gear.nodes": 500}),
                          ("83-112-flume-3.0kn.toml", {"gear.nodes": 2000})):
        solve_row(netloft, name, changes, options.times)
    memory_row(netloft, options.solves)
    for nodes in (2000, 20000):
        interruption_row(netloft, nodes, options.moments)


if __name__ == "__main__":
    main()
