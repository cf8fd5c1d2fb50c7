// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/terminal.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;

}  // namespace

int study_collect_command(const StudyCollectOptions& o) {
  Terminal terminal(o);
  const fs::path folder = o.folder;
  const studies::Study study = read_study(folder);
  const fs::path output = o.output.empty() ? folder : fs::path(o.output);
  if (!fs::is_directory(output)) throw UsageError{"-o " + o.output + ": there is no such folder"};
  const studies::StudyTable table = studies::collect_table(study, folder);
  formats::write_whole(output / "table.csv", studies::study_csv(table));
  formats::write_whole(output / "table.hdf", studies::study_hdf5(study, table));
  formats::write_whole(output / "costs.csv", studies::costs_csv(study, folder));
  if (const std::string changed = what_changed(study, folder); !changed.empty())
    terminal.say("netloft: " + changed + "; the table shows the study as it was planned");
  for (const std::string& sentence : table.sentences) terminal.say("netloft: " + sentence);
  const auto counts = table.count_by_status();
  std::string text = fmt::format("{}: {}", study.name, count_of(table.rows.size(), "point"));
  for (const auto& [status, count] : counts) text += fmt::format(", {} {}", count, status);
  text += fmt::format("\n  written to {}", (output / "table.csv").string() + ", table.hdf and costs.csv");
  print_answer(o,
               {{"points", table.rows.size()},
                {"by_status", counts},
                {"missing_items", table.missing_items},
                {"sentences", table.sentences}},
               text);
  if (table.missing_items) return kOther;
  return counts.size() == 1 && counts.contains("converged") ? kDone : kNotConverged;
}

}  // namespace netloft::program
