#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the suite of hard cases with one thread, with two, and while other processes keep the machine busy.
# Compares the stages and answers of every case, except times.
#
#   determinism.sh HARD_CASES SUITE [WORDS OF HARD_CASES…]
#
# such as --strategy auto --size small --case rope/. Prints the cases that differ; exit 1 if there are any.
set -eu
hard_cases=$1
suite=$2
shift 2
folder=$(mktemp -d)
busy=
trap 'for process in $busy; do kill "$process"; done; rm -r "$folder"' EXIT
trap 'exit 1' INT TERM HUP  # sh runs the trap of EXIT after a signal only where it has one of its own

# Exit code 3 means that some cases fail, which does not matter here.
run() {
  out=$1
  shift
  "$hard_cases" "$suite" --json "$@" >"$folder/$out.json" 2>/dev/null || [ $? -eq 3 ]
}

run alone --threads 1 "$@"
run threads --threads 2 "$@"
for _ in 1 2 3 4; do
  while :; do :; done &
  busy="$busy $!"
done
run busy --threads 1 "$@"

python3 - "$folder" <<'PYTHON'
import json
import sys

def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if "seconds" not in k}
    return [without_times(v) for v in value] if isinstance(value, list) else value

def cases(name):
    with open(f"{sys.argv[1]}/{name}.json") as file:
        return {(c["name"], c["size"], c["solver"]): without_times(c) for c in json.load(file)["cases"]}

alone, differing = cases("alone"), 0
for other in ("threads", "busy"):
    for key, case in cases(other).items():
        if case == alone[key]:
            continue
        differing += 1
        print(f"{' '.join(key)}, {other}: " + ", ".join(k for k in case if case[k] != alone[key][k]))
print(f"{len(alone)} cases, {differing} that differ")
sys.exit(differing > 0)
PYTHON
