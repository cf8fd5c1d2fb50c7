// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/recorded_scene.hpp"

#include "io/formats/hdf5/read.hpp"
#include "io/program/session/session.hpp"
#include "io/results/figures/merged_scene.hpp"
#include "io/results/file/read_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace netloft::program {

namespace {

results::Result read_equilibrium(const std::string& file) {
  try {
    results::Result result = results::read_result(file);
    if (result.outcome != "converged")
      throw UsageError{
          fmt::format("{} is not the result of an equilibrium that was found, it ended \"{}\"; "
                      "give the scene file, so that the equilibrium is searched again",
                      file, result.outcome)};
    if (result.origins.files.empty())
      throw UsageError{file + " does not contain the text of its scene; give the scene file"};
    return result;
  } catch (const formats::FileError& e) {
    throw UsageError{e.what()};
  }
}

/// The last value of an option of the run, unless the command has this option itself.
void complete(std::string& chosen, const results::Origins& origins, const char* option) {
  const auto values = results::values_of_option(origins, option);
  if (chosen.empty() && !values.empty()) chosen = values.back();
}

}  // namespace

bool names_result(const MethodOptions& options) { return options.scene.ends_with(".hdf"); }

RecordedScene recorded_scene(const MethodOptions& options) {
  results::Origins origins = read_equilibrium(options.scene).origins;
  MethodOptions all = options;
  all.scene = origins.files.front().path;
  all.set = results::values_of_option(origins, "--set");
  all.set.insert(all.set.end(), options.set.begin(), options.set.end());
  complete(all.strategy, origins, "--strategy");
  complete(all.solver, origins, "--solver");
  formats::StoredTexts texts;
  for (const auto& file : origins.files)
    texts[std::filesystem::path(file.path).lexically_normal().string()] = file.text;
  runs::CaseSource source = source_of(all);
  source.scene = source.scene.with_texts(all.scene, std::move(texts));
  return {std::move(all), std::move(source), std::move(origins)};
}

void refuse_changed_files(const RecordedScene& recorded, const scenes::LoadedScene& loaded) {
  for (const auto& now : loaded.files)
    for (const auto& then : recorded.origins.files)
      if (now.path == then.path && now.hash != then.hash)
        throw UsageError{
            now.path +
            " has changed since the result was written; give the scene file instead of the result"};
}

}  // namespace netloft::program
