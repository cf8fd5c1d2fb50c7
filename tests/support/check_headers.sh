#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_headers.sh CC CXX INCLUDE: checks that every public header compiles alone, headers of the C interface
# as C99 and as C++, and that plugin.h is small, that no two traits share a bit and no two extensions an
# identifier.
set -euo pipefail

cc=$1 cxx=$2 include=$3
export cc cxx include
breaches=0
breach() {
  echo "$1"
  breaches=$((breaches + 1))
}

compile_alone() {
  local source="#include <$1>"
  [[ $1 != *.h ]] || "$cc" -std=c99 -pedantic -Wall -Wextra -Werror -fsyntax-only -I"$include" -xc - <<<"$source" || return 255
  "$cxx" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$include" -xc++ - <<<"$source" || return 255
}
export -f compile_alone

headers=$(cd "$include" && find netloft -name '*.h' -o -name '*.hpp' | sort)
[[ $(grep -c '^netloft/ext/.*\.h$' <<<"$headers") -ge 10 ]] || breach "no extensions below $include: the check looks in the wrong place"
xargs -P 2 -I{} bash -c 'compile_alone {}' <<<"$headers" || breach 'a public header does not compile alone'

core=$(wc -l <"$include/netloft/plugin.h")
((core <= 250)) || breach "netloft/plugin.h has $core lines, 250 are allowed: what few plugins use belongs to an extension"
if grep -qE '#include <netloft/' "$include/netloft/plugin.h"; then breach 'netloft/plugin.h includes an extension'; fi

shared=$(cd "$include/netloft" && grep -hoE '\b1u? << [0-9]+' plugin.h ext/*.h | tr -d u | sort | uniq -d)
[[ -z $shared ]] || breach "two traits share a bit: $shared"
shared=$(grep -hoE '"netloft\.[a-z_]+/[0-9]+"$' "$include"/netloft/ext/*.h | sort | uniq -d)
[[ -z $shared ]] || breach "two extensions share an identifier: $shared"

((breaches == 0)) || exit 1
echo "$(wc -l <<<"$headers") headers compile alone"
