#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Writes what import_fuzzer starts from into a folder: gears with their meshes, a zero byte between them, and a mesh.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
for gear in "$here"/../validation/femnet_files/*.don; do
  mesh=${gear%.don}.mdg
  [[ -e $mesh ]] || continue
  { cat "$gear" && printf '\0' && cat "$mesh"; } >"$1/$(basename "$gear" .don)"
done
printf 'netloft mesh 1\n[nodes]\n0 0 0\n1 0 0\n0 1 0\n[triangles a]\n0 1 2 0 0 1 0 1 1\n[bars b]\n0 1 0 1\n[twines c]\n1 2 5 3\n[set d]\n0 2\n[end]\n' >"$1/mesh"
