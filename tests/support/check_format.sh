#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Is every C and C++ file laid out as .clang-format says? Exit 0 yes, 1 no, 77 clang-format is not installed.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if [[ -z $(type -P clang-format) ]]; then
  echo 'skipped: clang-format is not installed'
  exit 77
fi

# Lists the files that git tracks; an unpacked archive has no git, but these folders then contain no other
# files either.
list_sources() {
  git ls-files -z -- '*.hpp' '*.cpp' '*.h' 2>/dev/null ||
    find framework plugins solvers io tests -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' \) -print0
}

mapfile -d '' -t listed < <(list_sources)
files=()
for file in "${listed[@]}"; do
  [[ ! -f $file ]] || files+=("$file")
done
((${#files[@]})) || { echo 'no C++ files found: the check looks in the wrong place' && exit 1; }

clang-format --dry-run -Werror --style=file "${files[@]}" ||
  { echo 'to mend: clang-format -i FILE' && exit 1; }
echo "${#files[@]} files are formatted"
