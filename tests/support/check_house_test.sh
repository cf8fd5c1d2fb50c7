#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks that check_house.sh finds wrong includes in every wing of io and every folder of the framework,
# includes that are not listed in a README, and comments and pages that are too long. It changes a copy.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
copy=$(mktemp -d)
trap 'rm -r "$copy"' EXIT
mkdir -p "$copy/tests"
cp -r "$root/framework" "$root/io" "$copy"
cp -r "$root/tests/support" "$copy/tests"
failures=0

# expect CHECK FILE LINES: with the lines at the end of the file, the check must fail and name the file;
# without them, it must pass.
expect() {
  local check=$1 file=$copy/$2 kept said
  kept=$(mktemp -p "$copy")
  cp "$file" "$kept"
  printf '%s\n' "$3" >>"$file"
  if said=$("$copy/tests/support/check_house.sh" "$check") || [[ $said != *"$2"* ]]; then
    echo "$check does not find \"${3:0:80}\" in $2"
    failures=$((failures + 1))
  fi
  cp "$kept" "$file"
  rm "$kept"
}

"$copy/tests/support/check_house.sh" check_floors check_doors check_doors_of_others check_openings check_page_lengths check_comment_lengths >/dev/null || { echo 'the copy breaks the rules as it is' && exit 1; }
wings=(formats gears scenes runs results pictures studies program python)
for ((i = 0; i + 1 < ${#wings[@]}; ++i)); do
  file=$(cd "$copy" && find "io/${wings[i]}" -name '*.hpp' | sort | head -n 1)
  expect check_floors "$file" "#include \"io/${wings[i + 1]}/anything.hpp\""
done
expect check_floors framework/balance/scales.hpp '#include "framework/motion/time_march.hpp"'
expect check_floors framework/judging/verdict.hpp '#include "framework/motion/time_march.hpp"'
expect check_doors io/results/text/tables.hpp '#include "io/formats/hdf5/fold_that_is_nobodys.hpp"'
expect check_doors_of_others io/results/file/read_result.cpp 'static const hid_t file = H5Fopen("a.hdf", H5F_ACC_RDONLY, H5P_DEFAULT);'
expect check_doors_of_others io/program/commands/plan_command.cpp 'static const int said = std::puts("done");'
expect check_openings framework/balance/scales.hpp "$(printf '/// Of what there is the rest.\n%.0s' {1..100})"
expect check_page_lengths framework/balance/README.md "$(printf 'word %.0s' {1..500})"
expect check_comment_lengths framework/balance/scales.hpp "$(printf '/// A line.\n%.0s' {1..31})"$'\nstruct Long;'
# The first command of the README leaves a result file. Without git, .gitignore says that it is not part of
# the repository.
cp "$root/.gitignore" "$copy"
touch "$copy/flume.hdf" "$copy/stray.txt"
said=$("$copy/tests/support/check_house.sh" check_top_level) || true
[[ $said == *stray.txt* && $said != *flume.hdf* ]] || { echo "results and strays at the top: $said" && failures=$((failures + 1)); }
((failures == 0)) || exit 1
echo 'every breach was found'
