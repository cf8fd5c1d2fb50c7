#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_exports.sh NM FOLDER: checks that every plugin below the folder exports netloft_plugin_v1 and nothing
# else.
set -euo pipefail

nm=$1 folder=$2
breaches=0 plugins=0

while IFS= read -r -d '' plugin; do
  plugins=$((plugins + 1))
  exported=$("$nm" -D --defined-only "$plugin" | awk '{print $NF}' | sort | tr '\n' ' ')
  [[ $exported == 'netloft_plugin_v1 ' ]] || {
    echo "$plugin: exports ${exported:-nothing}"
    breaches=$((breaches + 1))
  }
done < <(find "$folder" -name '*.so' -print0)

((plugins)) || { echo "no plugin below $folder: the check looks in the wrong place" && exit 1; }
((breaches == 0)) || exit 1
echo "$plugins plugins export one symbol each"
