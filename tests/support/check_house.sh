#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Does the tree keep its floor plan? Says every breach, one a line as file:line, and exits 1 if there is any.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
rooms=(framework plugins solvers io)
breaches=0

main() {
  mapfile -d '' -t files < <(list_files)
  ((${#files[@]})) || breach 'no files found: the check looks in the wrong place'
  check_top_level
  check_arrows
  check_readmes
  check_first_lines
  ((breaches == 0)) || { echo "$breaches breaches of the floor plan" && exit 1; }
  echo "${#files[@]} files keep to the floor plan"
}

# Git knows what is ours; an unpacked archive has no git, and then only build output has to be left out.
list_files() {
  git ls-files -z 2>/dev/null || find . -path ./build -prune -o -path './.?*' -prune -o -type f -printf '%P\0'
}

breach() {
  echo "$1"
  breaches=$((breaches + 1))
}

check_top_level() {
  local allowed=' CMakeLists.txt framework plugins solvers io tests gear-library README.md CMakePresets.json LICENSE CHANGELOG.md CONTRIBUTING.md bootstrap cmake '
  local file name
  while read -r name; do
    [[ $name == .* || $allowed == *" $name "* ]] || breach "$name: does not belong to the top level"
  done < <(for file in "${files[@]}"; do echo "${file%%/*}"; done | sort -u)
}

# Arrows point to the framework, and nothing includes a plugin.
check_arrows() {
  forbid_includes framework 'plugins|solvers|io' 'the framework includes none of the other rooms'
  forbid_includes plugins 'solvers|io' 'plugins see only the framework'
  forbid_includes solvers 'plugins|io' 'solvers see only the framework'
  forbid_includes io 'plugins' 'nothing includes a plugin'
  forbid_headers framework 'toml(\+\+|plusplus)?[./]|hdf5|H5|highfive/' 'no TOML and no HDF5 in the framework'
}

forbid_includes() { forbid_headers "$1" "(\.\./|netloft/)*($2)/" "$3"; }

# forbid_headers ROOM PATTERN REASON: no C or C++ file of the room includes a header that begins so.
forbid_headers() {
  local file hit
  for file in "${files[@]}"; do
    [[ $file == "$1"/* && -f $file && $file =~ \.(hpp|cpp|h|c)$ ]] || continue
    while IFS= read -r hit; do
      breach "$file:${hit%%:*}: $3: ${hit#*:}"
    done < <(grep -nE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($2)" "$file")
  done
}

# The rooms and the folders in them; include/netloft counts as one folder.
check_readmes() {
  local room file folder
  for room in "${rooms[@]}"; do
    while read -r folder; do
      [[ -f $folder/README.md || -f $folder/netloft/README.md ]] || breach "$folder: has no README.md"
    done < <(
      for file in "${files[@]}"; do
        [[ $file != "$room"/* ]] || echo "$room"
        [[ $file != "$room"/*/* ]] || echo "$room/$(cut -d/ -f2 <<<"$file")"
      done | sort -u
    )
  done
}

check_first_lines() {
  local file first
  for file in "${files[@]}"; do
    [[ -f $file && $file =~ \.(hpp|cpp|h)$ ]] || continue
    IFS= read -r first <"$file" || true
    [[ $first == *'SPDX-License-Identifier: BSD-3-Clause'* ]] || breach "$file:1: does not start with the SPDX tag"
    [[ $file != *.hpp ]] || grep -qx '#pragma once' "$file" || breach "$file:1: has no #pragma once"
  done
}

main "$@"
