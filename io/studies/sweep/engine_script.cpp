// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/engine_script.hpp"

#include "io/studies/sweep/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace netloft::studies {

namespace {

// Engines take about a second to start a task, which is little against a task of a minute.
constexpr double kLeastSeconds = 60;

/// Quotes a word for bash.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Returns a word for a comment that Slurm reads. Slurm splits comments at blanks and does not know quotes of
/// the shell.
std::string plain_word(std::string word) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
  };
  std::replace_if(
      word.begin(), word.end(), [&](char c) { return !is_plain(c); }, '_');
  return word;
}

std::string flags(const ScriptOptions& options) {
  std::string text;
  for (const std::string& folder : options.plugins) text += " --plugins " + quoted(folder);
  return text;
}

constexpr const char* kParallel = R"sh(#!/usr/bin/env bash
# Study {name}: {items} items, {points} points, by GNU parallel on the cores of this machine.
#   bash parallel.sh                          computes what has no result yet; again to go on after a kill or a failure
#   bash parallel.sh --sshloginfile hosts     on other machines, too, which see this folder under the same name
# What is done is known by the records in items/, not by parallel.log, which says when and where each item ran.
set -uo pipefail
cd "$(dirname "${{BASH_SOURCE[0]}}")"
netloft={program}
"$netloft" study missing . |
  parallel --jobs {jobs} --workdir "$PWD" --joblog parallel.log --halt never "$@" {command}
"$netloft" study collect .
)sh";

constexpr const char* kSlurm = R"sh(#!/usr/bin/env bash
# Study {name}: {items} items, {points} points, as a job array of Slurm: {tasks} tasks of {chunk} items.
# {why_chunk}
#   sbatch --wait slurm.sh; netloft study collect .          in this folder; again to go on after a kill or a failure
# What is done is known by the records in items/: tasks whose items are done end at once.
#SBATCH --job-name={job}
#SBATCH --array=1-{tasks}
#SBATCH --cpus-per-task=1
#SBATCH --output=slurm-%A_%a.log
set -uo pipefail
cd "${{SLURM_SUBMIT_DIR:-.}}"
first=$(((SLURM_ARRAY_TASK_ID - 1) * {chunk} + 1)) last=$((SLURM_ARRAY_TASK_ID * {chunk}))
exec {program} study run . --items "$first-$((last < {items} ? last : {items}))" --jobs 1{flags}
)sh";

}  // namespace

std::string script_name(Engine engine) { return engine == Engine::slurm ? "slurm.sh" : "parallel.sh"; }

std::string engine_script(Engine engine, const Study& study, const ScriptOptions& options) {
  const std::size_t items = study.items.size(), tasks = (items + options.chunk - 1) / options.chunk;
  const std::string jobs = options.jobs > 0 ? std::to_string(options.jobs) : "100%";
  return fmt::format(
      fmt::runtime(engine == Engine::slurm ? kSlurm : kParallel), fmt::arg("name", study.name),
      fmt::arg("items", items), fmt::arg("points", study.point_count()),
      fmt::arg("program", quoted(options.program)), fmt::arg("jobs", jobs), fmt::arg("tasks", tasks),
      fmt::arg("chunk", options.chunk), fmt::arg("why_chunk", options.why_chunk),
      fmt::arg("flags", flags(options)), fmt::arg("job", plain_word(study.name)),
      fmt::arg("command", quoted(quoted(options.program) + " study run . --items {}" + flags(options))));
}

std::size_t items_per_minute(const Study& study, const std::filesystem::path& folder,
                             double& seconds_per_item) {
  double sum = 0;
  std::size_t known = 0;
  std::string unused;
  for (const StudyItem& item : study.items)
    if (const auto record = find_record(folder, item, unused)) {
      sum += record->cost.wall_seconds;
      ++known;
    }
  seconds_per_item = known ? sum / static_cast<double>(known) : 0;
  if (!(seconds_per_item > 0)) return 1;
  const double wanted = std::ceil(kLeastSeconds / seconds_per_item);
  return std::min(study.items.size(), static_cast<std::size_t>(std::min(wanted, 1e9)));
}

}  // namespace netloft::studies
