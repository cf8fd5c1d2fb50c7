#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks the rules of the repository: folders, includes, names, links, lengths, words. Prints every breach as
# a line file:line, and exits 1 if there is any. With names of checks (check_floors), it runs only these.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
rooms=(framework plugins solvers io)
breaches=0

checks=(check_top_level check_arrows check_floors check_doors check_readmes check_first_lines check_documents check_component_names
        check_linear_algebra check_doors_of_others check_function_lengths check_words check_openings check_page_lengths check_comment_lengths check_promises
        check_one_definition)

main() {
  local check
  mapfile -d '' -t files < <(list_files)
  ((${#files[@]})) || breach 'no files found: the check looks in the wrong place'
  (($# == 0)) || checks=("$@")
  for check in "${checks[@]}"; do "$check"; done
  ((breaches == 0)) || { echo "$breaches breaches of the rules" && exit 1; }
  echo "${#files[@]} files keep the rules"
}

# Lists the files that git tracks; without git, as in an unpacked archive, the files that .gitignore does not
# exclude.
list_files() {
  git ls-files -z 2>/dev/null && return
  local pattern ignored=(-path './.?*')
  [[ ! -e .gitignore ]] || while read -r pattern; do
    case $pattern in
      /*) ignored+=(-o -path ".${pattern%/}") ;;
      *) ignored+=(-o -name "${pattern%/}") ;;
    esac
  done <.gitignore
  find . \( "${ignored[@]}" \) -prune -o -type f -printf '%P\0'
}

breach() {
  echo "$1"
  breaches=$((breaches + 1))
}

check_top_level() {
  local allowed=' CMakeLists.txt framework plugins solvers io tests gear-library README.md CMakePresets.json LICENSE CHANGELOG.md CONTRIBUTING.md SECURITY.md bootstrap cmake '
  local file name
  while read -r name; do
    [[ $name == .* || $allowed == *" $name "* ]] || breach "$name: does not belong to the top level"
  done < <(for file in "${files[@]}"; do echo "${file%%/*}"; done | sort -u)
}

# Includes must lead towards the framework, and nothing may include a plugin.
check_arrows() {
  forbid_includes framework 'plugins|solvers|io' 'the framework includes none of the other rooms'
  forbid_includes plugins 'solvers|io' 'plugins see only the framework'
  forbid_includes solvers 'plugins|io' 'solvers see only the framework'
  forbid_includes io 'plugins' 'nothing includes a plugin'
  forbid_headers framework 'toml(\+\+|plusplus)?[./]|hdf5|H5|highfive/' 'no TOML and no HDF5 in the framework'
}

# Folders of the framework and wings of io may include only those below them in the table of their README.
check_floors() {
  check_floors_of framework '^\| `[a-z]+/'
  check_floors_of io '^\| \[`[a-z]+/'
}

# check_floors_of ROOM ROW: the rows of the table are the lines of the README that begin with the expression
# ROW.
check_floors_of() {
  local room=$1 folders=() above i
  mapfile -t folders < <(grep -oE "$2" "$room/README.md" | tr -d '[|`/ ')
  ((${#folders[@]} >= 8)) || breach "$room/README.md: no table of folders found"
  for ((i = 0; i + 1 < ${#folders[@]}; ++i)); do
    [[ -d $room/${folders[i]} ]] || continue
    above=$(IFS='|' && echo "${folders[*]:i+1}")
    forbid_headers "$room/${folders[i]}" "$room/($above)/" "the README of $room has it below"
  done
}

# A wing of io may include only those headers of another wing that its README lists.
check_doors() {
  local hit file header wing
  while IFS= read -r hit; do
    file=${hit%%:*} header=${hit##*\"io/} header=${header%%\"*} wing=${header%%/*}
    [[ $file == io/$wing/* ]] || grep -qF "\`${header#*/}\`" "io/$wing/README.md" ||
      breach "$file: includes io/$header, which the README of io/$wing does not name"
  done < <(grep_in io/ '\.(hpp|cpp)$' -E '^#include "io/')
}

forbid_includes() { forbid_headers "$1" "(\.\./|netloft/)*($2)/" "$3"; }

# forbid_headers ROOM PATTERN REASON: no C or C++ file of the room includes a header whose name matches.
forbid_headers() {
  breach_lines "$3" < <(grep_in "$1/" '\.(hpp|cpp|h|c)$' -E "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($2)")
}

# grep_in FOLDER ENDING WORDS…: greps in the files below FOLDER with this ending; prints file:line:text.
grep_in() {
  local folder=$1 ending=$2 file chosen=()
  shift 2
  for file in "${files[@]}"; do
    [[ $file == "$folder"* && $file =~ $ending && -f $file ]] && chosen+=("$file")
  done
  ((${#chosen[@]} == 0)) || grep -Hn "$@" "${chosen[@]}"
}

# Rooms and folders that must have a README; include/netloft counts as one folder.
check_readmes() {
  local room file folder
  for room in "${rooms[@]}"; do
    while read -r folder; do
      [[ -f $folder/README.md || -f $folder/netloft/README.md ]] || breach "$folder: has no README.md"
    done < <(
      for file in "${files[@]}"; do
        [[ $file == "$room"/* ]] || continue
        echo "$room"
        file=${file#"$room"/}
        [[ $file != */* ]] || echo "$room/${file%%/*}"
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
  done
  while IFS= read -r file; do
    breach "$file:1: has no #pragma once"
  done < <(for file in "${files[@]}"; do [[ $file != *.hpp || ! -f $file ]] || echo "$file"; done | xargs -r grep -Lx '#pragma once')
}

# Lines of code of a room as file:line:text, without comments.
code_of() {
  local file chosen=()
  for file in "${files[@]}"; do
    [[ $file == "$1"/* && -f $file && $file =~ \.(hpp|cpp|h|c)$ ]] && chosen+=("$file")
  done
  ((${#chosen[@]} == 0)) || awk '{
    gsub(/\/\*.*\*\//, "")
    if (sub(/\/\*.*/, "")) { print FILENAME ":" FNR ":" $0; inside = 1; next }
    if (inside) { if (sub(/.*\*\//, "")) inside = 0; else next }
    sub(/\/\/.*/, "")
    print FILENAME ":" FNR ":" $0
  }' "${chosen[@]}"
}

# breach_lines REASON: reports every line of standard input, file:line:text, as a breach.
breach_lines() {
  local hit rest
  while IFS= read -r hit; do
    rest=${hit#*:}
    breach "${hit%%:*}:${rest%%:*}: $1: ${rest#*:}"
  done
}

# The framework must not name any component. The names of components are those of the folders with plugins.
check_component_names() {
  local file folder solvers=() elements=()
  while read -r folder; do
    case $folder in
      plugins/*) elements+=("${folder#plugins/}") ;;
      solvers/*) solvers+=("${folder##*/}") ;;
    esac
  done < <(for file in "${files[@]}"; do [[ $file != */plugin.cpp ]] || echo "${file%/plugin.cpp}"; done)
  ((${#solvers[@]} && ${#elements[@]})) || breach 'no plugins found: the check looks in the wrong place'
  breach_lines 'the framework names a component' < <(
    code_of framework | grep -E "\"($(IFS='|' && echo "${solvers[*]}"))[\":/]|\"($(IFS='|' && echo "${elements[*]}"))/"
  )
}

# Numerics belong to solvers and the framework, not to io. Exceptions, with the reason:
numerics_of_io=(
  io/gears/meshing/knot_graph.cpp      # least squares for the initial shape of a net: geometry, before there is a problem
  io/studies/compare/polish.cpp       # brings a reference to the round-off floor, through the boundary that solvers have
  io/program/templates/solver/my_solver.cpp io/program/templates/solver/my_solver_test.cpp  # a solver to begin with
  io/python/module/python_solver.cpp   # hands the calls of solvers in Python on to the host
)

check_linear_algebra() {
  local exempt
  printf -v exempt '^%s:|' "${numerics_of_io[@]}"
  breach_lines 'linear algebra in io' < <(
    code_of io | grep -vE "${exempt%|}" |
      grep -E 'factorise\(|[Cc]holesky|\b(amd|METIS)_|__m(128|256|512)|\b_mm(256|512)?_|[<"]Eigen/|factorisation/registers'
  )
}

# Foreign data pass through checks: only one function opens HDF5 files, which refuses links and data in other
# files, and only functions that escape control characters print texts on a terminal. Exceptions, with the
# reason:
printers=(
  io/program/session/print.cpp         # the functions
  io/program/session/terminal.cpp      # a progress line that is redrawn, and messages that are rendered in colour
  io/program/templates/.*              # tests to begin with
  io/formats/units/write_known_words.cpp  # a program of the build
)

check_doors_of_others() {
  local exempt
  printf -v exempt '^%s:|' "${printers[@]}"
  breach_lines 'HDF5 files of others are opened in io/formats/hdf5/open.cpp' < <(
    code_of io | grep -v '^io/formats/hdf5/open\.cpp:' | grep -E '\bH5(Fopen|Fis_|Pset_file_image)'
  )
  breach_lines 'print with io/program/session/print.hpp' < <(
    code_of io | grep -vE "${exempt%|}" | grep -E '\b(puts|fputs|f?printf|putchar|fputc)\(|fmt::print\(|std::c(out|err) *<<'
  )
}

# Checks relative links of every page, and names of files in backticks in a README (with a folder, or sources
# without one).
check_documents() {
  local hit file rest name
  while IFS= read -r hit; do
    file=${hit%%:*} rest=${hit#*:}
    name=${rest#*:](} name=${name%)} name=${name%%#*}
    [[ -z $name || $name == *:* ]] || exists_beside "$file" "$name" || breach "$file:${rest%%:*}: links to $name, which does not exist"
  done < <(grep_in '' '\.md$' -oE '\]\([^) ]+\)')
  while IFS= read -r hit; do
    file=${hit%%:*} rest=${hit#*:} name=${hit##*:} name=${name//\`/}
    [[ $file == */templates/* ]] || exists_beside "$file" "$name" || breach "$file:${rest%%:*}: names $name, which does not exist"
  done < <(grep_in '' '(README|CONTRIBUTING)\.md$' -oE '`([A-Za-z0-9_.-]+/)+[A-Za-z0-9_-]+\.(hpp|cpp|h|md|toml|py|sh|txt|svg)`|`[A-Za-z0-9_-]+\.(hpp|cpp|h)`')
}

# A name on a page may be relative to the folder of the page, the top folder, the public headers, or the
# scenes.
exists_beside() {
  local folder=.
  [[ $1 != */* ]] || folder=${1%/*}
  [[ -e $folder/$2 || -e $2 || -e framework/include/$2 || -e $folder/netloft/$2 || -e gear-library/scenes/$2 ]]
}

# If two types in a namespace have the same name, the linker uses the functions of one for both.
check_one_definition() {
  breach_lines 'a type of this name is there already' < <(
    for room in framework plugins solvers io; do code_of "$room"; done | awk '
      { split($0, at, ":"); text = $0; sub(/^[^:]*:[^:]*:/, "", text) }
      at[1] !~ /\.hpp$/ { next }
      text ~ /^namespace [a-z_:]+ \{/ { space = text; gsub(/^namespace | \{.*/, "", space) }
      text ~ /^(struct|class|enum class|enum) [A-Za-z_0-9]+[^;]*\{/ {
        name = text
        sub(/^(struct|class|enum class|enum) /, "", name)
        if (name ~ /^[A-Za-z_0-9]+::/) next
        sub(/[^A-Za-z_0-9].*/, "", name)
        name = space "::" name
        if (name in where && where[name] != at[1]) print at[1] ":" at[2] ":" name ", " where[name]
        where[name] = at[1]
      }'
  )
}

# Checks that the tests named by the promises of SECURITY.md exist: Suite.Name of C++, test_name of Python, "a
# wrong scene", 'in a page'.
check_promises() {
  local promises=0 hit line name found
  while IFS= read -r hit; do
    line=${hit#*:} line=${line%%:*} promises=$((promises + 1))
    [[ $hit == *'`'* ]] || breach "SECURITY.md:$line: a promise without a test"
    while IFS= read -r name; do
      case $name in
        test_*) found="def $name\\(" ;;
        *.*) found="TEST(_F|_P)?\\(${name%%.*}, ${name#*.}\\)" ;;
        *) found='' ;;
      esac
      if [[ -n $found ]]; then
        grep_in tests/ '\.(cpp|py)$' -qE "$found" || breach "SECURITY.md:$line: there is no test $name"
      else
        grep_in tests/ '\.(py|mjs)$' -qF "$name" || breach "SECURITY.md:$line: there is no test $name"
      fi
    done < <(grep -oE '`[^`]+`' <<<"${hit##* | }" | tr -d '`' || true)
  done < <(grep_in SECURITY.md '' -E '^\| [A-Z]')
  ((promises >= 10)) || breach 'SECURITY.md: promises are missing'
}

# A function that is longer than 40 lines does more than one thing, unless it is a table.
check_function_lengths() {
  if ! ctags --version 2>/dev/null | grep -q Universal; then
    echo 'lengths of functions are not checked: universal-ctags is not installed'
    return
  fi
  local file chosen=()
  for file in "${files[@]}"; do
    [[ -f $file && $file =~ ^(framework|plugins|solvers|io)/.*\.(hpp|cpp)$ ]] && chosen+=("$file")
  done
  breach_lines 'longer than 40 lines' < <(
    ctags -f - --languages=C++ --c++-kinds=f --fields=+ne "${chosen[@]}" | awk -F '\t' -v tables="${tables_of_rows[*]}" '
      { line = end = 0
        for (i = 4; i <= NF; ++i) {
          if ($i ~ /^line:/) line = substr($i, 6)
          if ($i ~ /^end:/) end = substr($i, 5)
        }
        if (end - line >= 40 && index(" " tables " ", " " $2 ":" $1 " ") == 0)
          print $2 ":" line ":" $1 "(), " end - line + 1 " lines"
      }'
  )
}

# Functions that are only a table of checks or parameters, with a few lines for each row: file:function.
tables_of_rows=(
  framework/conformance/conformance.cpp:table
  framework/conformance/law_conformance.cpp:law_table
  framework/conformance/solver_conformance.cpp:solver_table
  framework/conformance/integrator_conformance.cpp:integrator_table
  framework/conformance/strategy_conformance.cpp:strategy_table
  solvers/strategies/tension/strategies.cpp:describe
)

# Words that only this project used, and the terms of the field. Only forms that are not ordinary English are
# searched.
private_words=(
  '[Jj]ourney|a strategy, a search'
  '[Dd]etour|a fallback, an attempt'
  'const Leg&|<Leg>|[.]legs\b|\blegs_|a stage'
  '\b[Ss]haken\b|perturbed'
  '[Rr]estless|does not settle'
  '\b[Oo]wn[_ -]start|OwnStart|an initial guess'
  '\b[Pp]atien(ce|t)\b|a budget of work'
  '(\bbent|Bent)[_ ]?step|\b(is|was)_bent|a curved step'
  '\blooks_|--looks\b|"looks"|[.`]looks\b|restarts'
  '\b[Cc]ompany\b|Company|a family group'
  '\b[Ss]oftly\b|_softly|fallback at round-off'
  '\b[Bb]lindly\b|_blindly|accepted on the residual'
  '[Hh]ardly[_ ](indefinite|convex)|_hardly|nearly definite'
  '[Tt]ension_?[Cc]ones|\b(in|from|over) cones\b|the interior-point method'
  '\b([Kk]eeps?|kept|the) books\b|\bbooks?\(|\bbooked\b|statistics, counts'
  '\bto tell of\b|\btold of\b|reports'
  '\bstands? otherwise\b|has another equilibrium'
)

check_words() {
  local entry any hit text
  printf -v any '%s|' "${private_words[@]%|*}"
  while IFS= read -r hit; do
    [[ $hit != *tests/support/check_house.sh:* ]] || continue
    text=${hit#*:*:}
    for entry in "${private_words[@]}"; do
      [[ ! $text =~ ${entry%|*} ]] || breach_lines "say: ${entry##*|}" <<<"$hit"
    done
  done < <(grep_in '' '\.(hpp|cpp|h|c|md|py|sh|cmake|txt|toml|in)$' -E "${any%|}")
}

# Comments that begin with these words are usually incomplete sentences ("Of two that did not arrive the one
# to tell of").
openings_at_most=0

check_openings() {
  local hits
  mapfile -t hits < <(grep_in '' '^(framework|plugins|solvers|io)/.*\.(hpp|cpp|h|c)$' -E '^ *///? (Of|By|As|Where|What) ')
  ((${#hits[@]} > openings_at_most)) || return 0
  breach "${#hits[@]} comments begin with Of, By, As, Where or What: begin with the subject"
  breach_lines 'leaves its sentence to the reader' < <(printf '%s\n' "${hits[@]}")
}

# A README says what, why, and the three files to read first; longer texts belong in the code or on the page
# of a bench.
words_at_most=500 words_of_front_page_at_most=1000

check_page_lengths() {
  local file words most
  for file in "${files[@]}"; do
    [[ -f $file && $file =~ ^((framework|plugins|solvers|io)/.*/|(framework|plugins|solvers|io)/|)README\.md$ ]] || continue
    most=$words_at_most
    [[ $file == */* ]] || most=$words_of_front_page_at_most
    words=$(wc -w <"$file")
    ((words <= most)) || breach "$file: has $words words, and $most are allowed"
  done
}


# A comment of a class says model, symbols, units, source and range; rules belong beside the code that follows
# them.
comment_lines_at_most=30

check_comment_lengths() {
  local file chosen=()
  for file in "${files[@]}"; do
    [[ -f $file && $file =~ ^(framework|plugins|solvers|io)/.*\.(hpp|cpp|h)$ ]] && chosen+=("$file")
  done
  breach_lines "a comment of more than $comment_lines_at_most lines" < <(
    awk -v most="$comment_lines_at_most" '
      FNR == 1 { count = 0 }
      /^ *\/\/\/($|[^<])/ { ++count; next }
      { if (count > most) print FILENAME ":" FNR ":" count " lines before " $0; count = 0 }' "${chosen[@]}"
  )
}

main "$@"
