// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/installed_folder.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/print.hpp"
#include "io/studies/sweep/engine_script.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;

/// A sentence that explains the number of items in each task.

std::string why_chunk(const StudySubmitOptions& o, std::size_t chunk, double seconds) {
  if (o.chunk > 0) return fmt::format("--chunk asks for {} in each task", count_of(chunk, "item"));
  if (seconds == 0)
    return "No item has been computed, so that the time of one is not known: run `netloft study run FOLDER "
           "--items 1` first, or give --chunk N.";
  return fmt::format(
      "An item takes {:.3g} s on average; a task gets enough items for a minute, or all items.", seconds);
}

}  // namespace

int study_missing_command(const StudyOptions& o) {
  const studies::Study study = read_study(o.folder);
  std::string fault;
  for (const studies::StudyItem& item : study.items)
    if (!studies::find_record(o.folder, item, fault)) print_line(std::to_string(item.id));
  return kDone;
}

int study_submit_command(const StudySubmitOptions& o) {
  const fs::path folder = o.folder;
  const studies::Study study = read_study(folder);
  const studies::Engine engine = o.engine == "slurm" ? studies::Engine::slurm : studies::Engine::parallel;
  double seconds = 0;
  const auto program = formats::installed_folder() / "bin" / "netloft";
  studies::ScriptOptions script{program.string(), o.plugins, 1, "", o.jobs};
  script.chunk = studies::items_per_minute(study, folder, seconds);
  if (o.chunk > 0) script.chunk = std::min(static_cast<std::size_t>(o.chunk), study.items.size());
  script.why_chunk = why_chunk(o, script.chunk, seconds);
  const fs::path path = folder / studies::script_name(engine);
  formats::write_keeping(path, studies::engine_script(engine, study, script));
  const std::string start = engine == studies::Engine::slurm ? "sbatch --wait slurm.sh" : "bash parallel.sh";
  print_answer(
      o, {{"script", path.string()}, {"items_per_task", engine == studies::Engine::slurm ? script.chunk : 1}},
      fmt::format("written to {}; in that folder `{}` computes the study", path.string(), start));
  return kDone;
}

}  // namespace netloft::program
