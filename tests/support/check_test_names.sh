#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_test_names.sh CTEST BUILD: checks that names of tests fit in a line of 100 characters. The names of
# tests that are not built are unknown.
set -uo pipefail
names=$("$1" --test-dir "$2" -N | sed -n 's/^ *Test *#[0-9]*: //p')
[[ -n $names ]] || { echo "$2 has no tests" >&2 && exit 1; }
long=$(awk 'length > 100' <<<"$names")
[[ -z $long ]] || { printf 'longer than 100 characters:\n%s\n' "$long" && exit 1; }
echo "$(wc -l <<<"$names") names of tests fit a line"
