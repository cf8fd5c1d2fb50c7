#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Writes the seeds of import_fuzzer into a folder: gears and their meshes, with a zero byte between them, and
# the other seeds.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
for gear in "$here"/../validation/femnet_files/*.don; do
  mesh=${gear%.don}.mdg
  [[ -e $mesh ]] || continue
  { cat "$gear" && printf '\0' && cat "$mesh"; } >"$1/$(basename "$gear" .don)"
done
cp "$here"/../validation/femnet_files/10_polygon_panel.don "$here"/seeds/import/* "$1"
