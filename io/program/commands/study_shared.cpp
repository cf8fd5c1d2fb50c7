// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/study_shared.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/formats/toml/document.hpp"
#include "io/program/session/print.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

namespace netloft::program {

studies::Study read_study(const std::filesystem::path& folder) {
  try {
    return studies::read_manifest(studies::manifest_path(folder));
  } catch (const studies::StudyError& e) {
    throw UsageError{e.what()};
  }
}

std::string what_changed(const studies::Study& study, const std::filesystem::path& folder) {
  for (const auto& [path, hash] : study.files)
    if (const auto text = formats::read_whole(folder / path); text && formats::fnv1a64(*text) != hash)
      return path + " has changed since the study was planned";
  return {};
}

void print_answer(const CommonOptions& options, const nlohmann::ordered_json& json, const std::string& text) {
  using Json = nlohmann::ordered_json;
  print_line(options.json ? json.dump(2, ' ', false, Json::error_handler_t::replace) : text);
}

std::string count_of(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

void write_bars(const std::string& file, const formats::BarChart& bars, const char* flag) {
  constexpr std::size_t kMostGroups = 12;  // groups of bars that fit on a printed page
  if (bars.groups.empty()) throw UsageError{"-o " + file + ": there is nothing to draw"};
  if (bars.groups.size() > kMostGroups)
    throw UsageError{fmt::format("-o {}: {} figures do not fit on one picture, {} do; name them with {}",
                                 file, bars.groups.size(), kMostGroups, flag)};
  formats::write_keeping(file, formats::draw_svg(bars));
}

}  // namespace netloft::program
