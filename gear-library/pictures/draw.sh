#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws the pictures of this folder again: draw.sh [NETLOFT [FOLDER]]. Results are written to a temporary
# folder.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
netloft=$(realpath "${1:-$here/../../build/release/bin/netloft}")
folder=$(realpath "${2:-$here}")
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT

# solve RESULT SCENE OPTIONS…: prints the output of the program only if it fails.
solve() {
  local result=$results/$1.hdf scene=$here/../scenes/$2.toml
  shift 2
  "$netloft" run "$scene" "$@" -o "$result" >"$results/said" 2>&1 || { cat "$results/said" >&2 && exit 1; }
}

# picture NAME RESULT OPTIONS…
picture() {
  local name=$1 result=$results/$2.hdf
  shift 2
  "$netloft" draw "$result" "$@" -o "$folder/$name.png"
}

solve 83-112 83-112-flume-3.0kn --set gear.nodes=2000
picture 83-112 83-112 --dark --field opening --width 1000
picture 83-112-front 83-112 --view front --width 800

solve start ../optima/83-112-undisturbed-water --set gear.nodes=2000 --set 'elements.floats.float.buoyancy=2.6015 kgf' --set 'points.towing-point.at[1]=29.422 m'
picture least-drag-start start --view front --field opening --dimensions --width 600
solve sewn ../optima/83-112-least-drag-plan --set gear.nodes=2000
picture least-drag-sewn sewn --view front --field opening --dimensions --width 600

solve four-panel four-panel
picture four-panel four-panel --field opening --width 800

solve boards pelagic-with-doors
picture with-boards boards --fit boards --dimensions --width 800
picture from-the-ship boards --view side --fit all --width 800

solve codend codend-from-plan
picture codend codend --width 800

solve small-trawl validation/small-trawl/half
picture small-trawl small-trawl --width 800

solve panel-in-current dynamics/panel-in-current
picture panel-in-current panel-in-current --width 600
