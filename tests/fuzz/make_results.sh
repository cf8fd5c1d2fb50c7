#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# make_results.sh PROGRAM FOLDER: writes small results of each kind, which result_fuzzer and part_fuzzer
# change.
set -euo pipefail
scenes=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../gear-library/scenes" && pwd)
mkdir -p "$2"
# A run that has not converged writes a result, too.
run() { "$1" run "$scenes/$2" -o "$3" "${@:4}" >/dev/null 2>&1 || [[ -s $3 ]]; }
run "$1" dead-weight-panel.toml "$2/panel.hdf" --set 'parts.net.cells=[2,2]'
run "$1" dynamics/released-rope.toml "$2/rope-in-time.hdf" --set analysis.output_interval=1 --set analysis.duration=2
# With a folder at the path of the result, the journal of a motion is kept.
mkdir -p "$2/rope-that-runs.hdf.new" && rm -f "$2/rope-that-runs.hdf.part"
run "$1" dynamics/released-rope.toml "$2/rope-that-runs.hdf" --set parts.rope.cells=2 --set analysis.output_interval=0.5 \
  --set analysis.duration=2 || [[ -s $2/rope-that-runs.hdf.part ]]
run "$1" 83-112-flume-3.0kn.toml "$2/half-gear.hdf" --set gear.nodes=100 --set analysis.max_iterations=20
