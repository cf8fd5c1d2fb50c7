#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# try_it.sh COMPILER INCLUDE CHECK_PLUGIN: what a third party does: one file anywhere, one compiler call, one check.
set -euo pipefail

compiler=$1 include=$2 check_plugin=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

lines=$(grep -vcE '^[[:space:]]*(//|$)' "$here/spring.cpp")
((lines <= 30)) || { echo "spring.cpp has $lines lines; an element takes no more than 30" && exit 1; }
cp "$here/spring.cpp" "$folder"
cd "$folder"
"$compiler" -std=c++20 -O2 -shared -fPIC -I"$include" spring.cpp -o spring.so
"$check_plugin" "$folder/spring.so"
