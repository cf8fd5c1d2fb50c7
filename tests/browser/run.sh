#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh tests of pages in a real browser; exits 77 with a sentence if something that it needs is missing
# run.sh time NODES… how long pages of gears with about as many nodes take to open NETLOFT_PROGRAM is the
# program, NETLOFT_BROWSER_FOLDER the folder for the files of the tests.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
program=${NETLOFT_PROGRAM:-$root/build/release/bin/netloft}
work=${NETLOFT_BROWSER_FOLDER:-$root/build/browser}

main() {
  need_tools
  install_packages
  if [[ ${1-} == time ]]; then
    shift
    time_to_open "$@"
  else
    check_libraries
    make_results
    run_node --test --test-reporter=spec test_page.mjs test_design.mjs test_tasks.mjs
  fi
}

# If tests in a browser are required, a missing program or file is a failure.
skip() {
  echo "pages are not tested in a browser: $1"
  [[ ${NETLOFT_BROWSER_TESTS-} != required ]] || exit 1
  exit 77
}

need_tools() {
  NETLOFT_BROWSER=$(type -P chromium || type -P chromium-browser || type -P google-chrome) || skip 'there is no chromium'
  [[ -n $(type -P node) && -n $(type -P npm) ]] || skip 'there is no node with npm'
  [[ $(node -p 'Number(process.versions.node.split(".")[0])') -ge 20 ]] || skip 'node is older than version 20'
  export NETLOFT_BROWSER
}

# Installs the packages of package.json once, beside copies of the scripts that import them.
install_packages() {
  mkdir -p "$work"
  cp "$here"/*.mjs "$here"/package.json "$here"/package-lock.json "$work"
  [[ $work/node_modules/.package-lock.json -nt $here/package-lock.json ]] && return
  (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) || skip "npm could not install what is needed: $(tail -n 1 "$work/npm.log")"
}

# Checks that the committed libraries have their checksums, and that their sources give the same files again.
check_libraries() {
  local libraries=$root/io/pictures/view/libraries again=$work/libraries
  (cd "$libraries" && sha256sum --check --quiet SHA256SUMS) || exit 1
  mkdir -p "$again"
  cp "$libraries"/{package.json,package-lock.json,entry.js,build.mjs} "$again"
  (cd "$again" && npm ci --no-audit --no-fund --ignore-scripts >npm.log 2>&1 && node build.mjs >>npm.log 2>&1) ||
    skip "npm could not build the libraries: $(tail -n 1 "$again/npm.log")"
  cmp "$libraries/SHA256SUMS" "$again/SHA256SUMS" || { echo 'libraries.js is not what its sources give' && exit 1; }
}

# solve NAME SCENE OPTIONS…: computes a result unless this program has already computed it.
solve() {
  local name=$1
  shift
  [[ $work/$name.hdf -nt $program ]] || "$program" run "$@" -o "$work/$name.hdf" >/dev/null 2>"$work/$name.log" ||
    [[ -e $work/$name.hdf ]]
}

make_results() {
  local scenes=$root/gear-library/scenes
  solve trawl "$scenes/83-112-flume-3.0kn.toml"
  solve faster "$scenes/83-112-flume-4.0kn.toml" --set gear.nodes=500
  solve slower "$scenes/83-112-flume-2.0kn.toml" --set gear.nodes=500
  solve stages "$scenes/83-112-flume-3.0kn.toml" --set gear.nodes=500 --stages
  solve broken "$scenes/83-112-flume-3.0kn.toml" --set gear.nodes=500 --solver newton --set analysis.max_iterations=4
  solve boards "$scenes/pelagic-with-doors.toml" --set gear.nodes=300
  solve codend "$scenes/codend-from-plan.toml"
  solve motion "$scenes/dynamics/elastic-pendulum.toml"
  /usr/bin/python3 "$here/hostile.py" "$work/motion.hdf" "$work/hostile.hdf"
}

run_node() { (cd "$work" && NETLOFT_PROGRAM=$program NETLOFT_SOURCE_DIR=$root node "$@"); }

time_to_open() {
  local nodes
  for nodes in "$@"; do
    solve "time-$nodes" "$root/gear-library/scenes/83-112-flume-3.0kn.toml" --set "gear.nodes=$nodes" --solver newton --set analysis.max_iterations=2
    "$program" view "$work/time-$nodes.hdf" -o "$work/time-$nodes.html" 2>/dev/null
    run_node time_to_open.mjs "$work/time-$nodes.html" "$nodes"
  done
}

main "$@"
