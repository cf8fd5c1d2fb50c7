#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of this folder again: draw.sh [NETLOFT]. Results go to a folder of their own and are thrown away.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
netloft=$(realpath "${1:-$here/../../build/release/bin/netloft}")
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT

# picture NAME SCENE RUN-OPTIONS… -- DRAW-OPTIONS…
picture() {
  local name=$1 scene=$2 options=()
  shift 2
  while [[ $1 != -- ]]; do options+=("$1") && shift; done
  shift
  "$netloft" run "$here/../scenes/$scene.toml" "${options[@]}" -o "$results/$name.hdf" >/dev/null 2>&1
  "$netloft" draw "$results/$name.hdf" "$@" -o "$here/$name.png"
}

picture 83-112 83-112-flume-3.0kn --set gear.nodes=2000 -- --dark --field opening --width 1000
picture 83-112-front 83-112-flume-3.0kn --set gear.nodes=2000 -- --view front --width 800
picture four-panel four-panel -- --field opening --width 800
picture codend codend-from-plan -- --width 800
picture small-trawl validation/small-trawl/half -- --width 800
picture panel-in-current dynamics/panel-in-current -- --width 600
