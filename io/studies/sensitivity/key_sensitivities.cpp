// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/key_sensitivities.hpp"

#include "io/results/figures/key_figures.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::studies {

namespace {

// Number of rows for each key figure. `netloft sensitivity` prints more.
constexpr std::size_t kRowsOfKey = 3;

std::vector<results::KeySensitivities::Row> largest_of(const Sensitivities& found) {
  std::vector<results::KeySensitivities::Row> rows;
  for (std::size_t f = 0; f < found.figures.size(); ++f) {
    const auto effects = ranked_effects(found, f);
    for (std::size_t i = 0; i < std::min(kRowsOfKey, effects.size()); ++i) {
      const SceneNumber& number = effects[i]->number;
      rows.push_back({found.figures[f].name, found.figures[f].unit, number.path, number.unit, number.value,
                      effects[i]->per_unit[f]});
    }
  }
  return rows;
}

std::string note_of(const Sensitivities& found) {
  const auto missing = std::ranges::count_if(found.effects, [](auto& e) { return !e.why_not.empty(); });
  return fmt::format(
      "numbers of the scene that were examined: {}, without derivatives: {}; `netloft sensitivity` tells "
      "why, and for which changes the others are valid",
      found.effects.size(), missing);
}

}  // namespace

void find_key_sensitivities(
    runs::PreparedScene& scene, const Solution& solution, const std::atomic<bool>* interrupt,
    const std::function<void(std::size_t done, std::size_t all, const std::string& path)>& on_number,
    results::Result& result) {
  auto& [note, rows] = result.sensitivities.emplace();
  if (const auto why_not = why_no_derivatives(solution)) {
    note = *why_not;
    return;
  }
  SensitivityRequest request{.figures = {}, .numbers = chosen_numbers(scene, {}), .interrupt = interrupt};
  request.on_number = [&](std::size_t done, const std::string& path) {
    on_number(done, request.numbers.size(), path);
  };
  for (const results::NamedScalar* figure : results::key_figures(result)) request.figures.push_back(*figure);
  const Sensitivities found = find_sensitivities(scene, solution, request);
  if (found.is_interrupted) {
    note = fmt::format("not known, because the run was interrupted: {} of {} numbers were examined",
                       found.effects.size(), request.numbers.size());
    return;
  }
  note = note_of(found);
  rows = largest_of(found);
}

}  // namespace netloft::studies
