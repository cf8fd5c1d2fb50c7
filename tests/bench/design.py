#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the time from the change of a number to the new shape, as `netloft serve` sends it to programs and pages.

    design.py NETLOFT GEAR_LIBRARY [--nodes 500 2000] [--steps 40] [--step 0.05] [--threads 1]

Moves numbers of the 83-112 in the flume (half), and of a trawl with boards at sea, up and down by a part of their size, and prints a
Markdown table with times [ms], of steps of `--step` (5 %): the tangent of a number; median and 95th percentile of the time until the
shape is there, and until it is that of any run (a number that divides the plan anew is followed on the mesh that is there first); of
how many steps no equilibrium was found; of how many it jumped; and the time from the command to the first equilibrium and to that
after the first move.
"""
import argparse
import http.client
import json
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FLUME = ("83-112-flume-3.0kn.toml", ("tow.speed", "ropes.lower-bridle.length", "elements.netting.drag.measured_at"))
AT_SEA = ("gov-like-67m.toml", ("ship.speed", "ship.warp.length"))


class Design:
    """A program that serves a scene."""

    def __init__(self, program, scene, threads, folder):
        self.began = time.perf_counter()
        self.process = subprocess.Popen([program, "serve", scene, "--json", "--threads", str(threads)], cwd=folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)
        host, self.token = re.fullmatch(r"http://(.*?)/(\w+)/", json.loads(self.process.stdout.readline())["address"]).groups()
        self.connection = http.client.HTTPConnection(host, timeout=600)

    def ask(self, name, **body):
        """The answer, and the time that it took [ms]."""
        begin = time.perf_counter()
        self.connection.request("POST", f"/{self.token}/api/{name}", json.dumps(body), {"Content-Type": "application/json"})
        answer = json.loads(self.connection.getresponse().read())
        if "error" in answer:
            sys.exit(f"{name}: {answer['error']}")
        return answer, 1e3 * (time.perf_counter() - begin)

    def listen(self):
        """Begins to hear events."""
        self.events = http.client.HTTPConnection(self.connection.host, self.connection.port, timeout=600)
        self.events.request("GET", f"/{self.token}/events?after={self.ask('state')[0]['event']}")
        self.stream = self.events.getresponse()

    def solved(self):
        """The next outcome that the program reports."""
        name = b""
        while True:
            line = self.stream.readline()
            if line.startswith(b"event: "):
                name = line[7:].strip()
            if line.startswith(b"data: ") and name == b"solved":
                return json.loads(line[6:])

    def move(self, path, to):
        """The outcomes of a step, and the times from the request to the first and to the last of them [ms]."""
        begin = time.perf_counter()
        revision = self.ask("apply", path=path, to=to)[0]["revision"]
        outcomes, times = [], []
        while not outcomes or not outcomes[-1]["own_mesh"]:
            outcome = self.solved()
            if outcome["revision"] == revision:
                outcomes.append(outcome)
                times.append(1e3 * (time.perf_counter() - begin))
        return outcomes, times[0], times[-1]

    def since_start(self):
        return 1e3 * (time.perf_counter() - self.began)

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(30)


def measure(program, scene, paths, nodes, options, folder):
    """One row: a scene with a number of nodes."""
    text = Path(folder) / f"{nodes}.toml"
    text.write_text(f'include = ["{scene}"]\n[gear]\nnodes = {nodes}\n')
    design = Design(program, text.name, options.threads, folder)
    design.ask("solve")
    first = design.since_start()
    start = {n["path"]: n["value"] for n in design.ask("state")[0]["numbers"]}
    paths = [path for path in paths if path in start]
    design.listen()
    tangents, shown, final, lost, jumps, moved = [], [], [], 0, 0, None
    for i in range(options.steps):
        path = paths[i % len(paths)]
        tangents.append(design.ask("jvp", path=path)[1])
        # the value goes up, back, down and back: every move is one step from the last equilibrium
        to = start[path] * (1 + options.step * (1, 0, -1, 0)[(i // len(paths)) % 4])
        outcomes, soon, late = design.move(path, to)
        moved = moved or design.since_start()
        lost += outcomes[-1]["status"] != "converged"
        jumps += any(outcome["jump"] is not None for outcome in outcomes)
        shown.append(soon)
        final.append(late)
    design.end()
    return (statistics.median(tangents), *middle_and_end(shown), *middle_and_end(final), lost, jumps, first, moved)


def middle_and_end(times):
    """Median and 95th percentile."""
    times = sorted(times)
    return statistics.median(times), times[min(len(times) - 1, int(0.95 * len(times)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("netloft")
    parser.add_argument("library", type=Path)
    parser.add_argument("--nodes", type=int, nargs="+", default=[500, 2000])
    parser.add_argument("--steps", type=int, default=40)
    parser.add_argument("--step", type=float, default=0.05)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    program = str(Path(options.netloft).resolve())
    print("| scene | nodes | tangent | shape, median | 95 % | own mesh, median | 95 % | none | jumps | command to first equilibrium | to first move |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, paths in (FLUME, AT_SEA):
            for nodes in options.nodes if name == FLUME[0] else options.nodes[:1]:
                scene = (options.library / "scenes" / name).resolve()
                row = measure(program, scene, paths, nodes, options, folder)
                print(f"| `{name}` | {nodes} | " + " | ".join(f"{v:.0f}" for v in row) + " |", flush=True)


if __name__ == "__main__":
    main()
