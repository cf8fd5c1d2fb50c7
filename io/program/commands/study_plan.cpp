// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/session.hpp"
#include "io/studies/sweep/check_study.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The folder of a study: the folder given by -o, or a folder in the current folder with the name of the
/// study file.
fs::path folder_for(const StudyPlanOptions& o) {
  return fs::path(o.output.empty() ? fs::path(o.file).stem().string() + ".study" : o.output);
}

/// A path relative to the folder of the study, so that the folder and the file can be moved together.
std::string seen_from(const fs::path& folder, const fs::path& path) {
  const fs::path from = fs::weakly_canonical(fs::absolute(folder)),
                 to = fs::weakly_canonical(fs::absolute(path));
  return to.lexically_relative(from).generic_string();
}

void check_size(const studies::StudyFile& file, formats::Diagnostics& diagnostics) {
  if (const double points = studies::count_points(file); points > studies::kMostPoints)
    diagnostics.error({0, 0, 0},
                      fmt::format("the design has {:.3g} points, but a study can have at most {:.3g}", points,
                                  studies::kMostPoints),
                      "give fewer values or samples, or combine = \"list\"");
}

/// Makes the folder. The manifest is written last, so that a folder with a manifest is complete.
void write_study(const fs::path& folder, const studies::Study& study) {
  std::error_code error;
  fs::create_directories(folder / "items", error);
  if (error) throw formats::WriteError((folder / "items").string() + " cannot be made: " + error.message());
  formats::write_whole(studies::manifest_path(folder), studies::manifest_text(study));
}

std::size_t count_computed(const studies::Study& study, const fs::path& folder) {
  std::string unused;
  return static_cast<std::size_t>(
      std::count_if(study.items.begin(), study.items.end(), [&](const studies::StudyItem& item) {
        return studies::find_record(folder, item, unused).has_value();
      }));
}

void report_plan(const CommonOptions& o, const studies::Study& study, const fs::path& folder) {
  const std::size_t before = count_computed(study, folder);
  const Json json = {{"folder", folder.string()},
                     {"items", study.items.size()},
                     {"points", study.point_count()},
                     {"computed_before", before}};
  std::string text = fmt::format("{}: {}, {} in all\n", study.name, count_of(study.items.size(), "item"),
                                 count_of(study.point_count(), "point"));
  for (const studies::StudyColumn& c : study.columns)
    text += fmt::format("  {}{}\n", c.variable.name, c.is_in_path ? ", along the path of every item" : "");
  if (before) text += fmt::format("  {} computed before\n", count_of(before, "item"));
  text +=
      fmt::format("  written to {}; `netloft study run {}` computes them", folder.string(), folder.string());
  print_answer(o, json, text);
}

}  // namespace

int study_plan_command(const StudyPlanOptions& o) {
  Terminal terminal(o);
  formats::Diagnostics diagnostics;
  const studies::StudyFile file = studies::read_study_file(o.file, diagnostics);
  Registry registry;
  find_plugins(o, registry);
  studies::CheckedScenes scenes;
  const fs::path at = fs::path(o.file).parent_path();
  if (!diagnostics.errors()) check_size(file, diagnostics);
  if (!file.scene.empty()) scenes = studies::check_scenes(file, at, registry, diagnostics);
  if (diagnostics.errors())
    return report_unready(
        diagnostics,
        scenes.refused ? runs::PreparedScene::State::refused : runs::PreparedScene::State::wrong_input,
        terminal);
  if (diagnostics.warnings()) terminal.say(diagnostics);
  const fs::path folder = folder_for(o);
  for (auto& [path, hash] : scenes.files) path = seen_from(folder, path);
  const studies::Study study =
      studies::make_study(file, seen_from(folder, at / file.scene), std::move(scenes.files));
  write_study(folder, study);
  report_plan(o, study, folder);
  return kDone;
}

}  // namespace netloft::program
