#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# rebuild.sh: makes abi-MAJOR.MINOR/released.so from released.cpp and the current header. Run it once for
# every released interface, and never for one whose file exists: plugins of users were built like that file.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
number() { sed -n "s/^#define NETLOFT_ABI_$1 //p" "$root/framework/include/netloft/plugin.h"; }
file=$here/abi-$(number MAJOR).$(number MINOR)/released.so

if [[ -e $file && ${1-} != --again ]]; then
  echo "$file is there; an interface that was released is not built again (--again if it was not)"
  exit 1
fi
mkdir -p "$(dirname "$file")"
# Compiled for any x86-64, without debug information.
cd "$here" && "${CXX:-c++}" -std=c++20 -Os -fPIC -shared -fvisibility=hidden -fvisibility-inlines-hidden -ffp-contract=off \
  -fno-math-errno -fno-trapping-math -fno-ident -flto -Wl,--build-id=none -Wl,-z,defs \
  -Wl,-z,noseparate-code -Wl,--version-script="$root/cmake/plugin.map" -I"$root/framework/include" -s released.cpp -o "$file"
size=$(stat -c %s "$file")
echo "$file: $size bytes"
((size < 50000)) || { echo 'it is to stay below 50000 bytes' && exit 1; }
