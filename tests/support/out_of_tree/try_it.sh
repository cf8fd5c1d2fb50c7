#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# try_it.sh CC CXX INCLUDE CHECK_PLUGIN: compiles a plugin from one file outside the repository and checks it.
# The plugin in C uses only plugin.h.
set -euo pipefail

cc=$1 cxx=$2 include=$3 check_plugin=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

lines=$(grep -vcE '^[[:space:]]*(//|$)' "$here/spring.cpp")
((lines <= 30)) || { echo "spring.cpp has $lines lines; an element takes no more than 30" && exit 1; }
cp "$here/spring.cpp" "$here/cord.c" "$folder"
mkdir -p "$folder/core/netloft"
cp "$include/netloft/plugin.h" "$folder/core/netloft"
cd "$folder"
"$cxx" -std=c++20 -O2 -shared -fPIC -I"$include" spring.cpp -o spring.so
"$cc" -std=c99 -pedantic -Wall -Wextra -Werror -O2 -shared -fPIC -fvisibility=hidden -Icore cord.c -lm -o cord.so
"$check_plugin" "$folder/spring.so"
"$check_plugin" "$folder/cord.so"
