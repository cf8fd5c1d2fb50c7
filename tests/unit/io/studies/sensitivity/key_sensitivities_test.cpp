// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/key_sensitivities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/io/studies/sensitivity/at_rest.hpp"

namespace netloft::studies {
namespace {

using results::KeySensitivities;
using test::AtRest;

results::Result result_of(AtRest& at, const std::atomic<bool>* interrupt = nullptr) {
  auto result = results::make_result(at.scene.loaded(), at.scene.assembler(), at.solution);
  find_key_sensitivities(
      at.scene, at.solution, interrupt, [](std::size_t, std::size_t, const std::string&) {}, result);
  return result;
}

/// The three largest effects on figure `f`, among all numbers with derivatives, of a change by one per cent.
std::vector<double> largest_effects(const Sensitivities& found, std::size_t f) {
  std::vector<double> sizes;
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty() && std::isfinite(effect.per_unit[f]))
      sizes.push_back(std::abs(effect_of_percent(effect, f)));
  std::ranges::sort(sizes, std::ranges::greater{});
  sizes.resize(3);
  return sizes;
}

TEST(KeySensitivities, AreTheThreeLargestEffectsOnEachKeyFigure) {
  AtRest trawl("83-112-flume-3.0kn.toml", {"gear.nodes=100"});
  const auto result = result_of(trawl);
  const std::vector<KeySensitivities::Row>& rows = result.sensitivities.value().rows;
  const Sensitivities found = trawl.to({});
  std::size_t row = 0;
  for (const std::size_t f : chosen_figures(result, {}))
    for (const double size : largest_effects(found, f)) {
      ASSERT_LT(row, rows.size());
      EXPECT_EQ(rows[row].figure, found.figures[f].name);
      EXPECT_EQ(rows[row].figure_unit, found.figures[f].unit);
      EXPECT_NEAR(std::abs(rows[row].effect()), size, 1e-12 * size) << rows[row].path;
      ++row;
    }
  EXPECT_EQ(row, rows.size());
  EXPECT_GT(row, 9u);
}

TEST(KeySensitivities, HaveTheDerivativesOfTheirNumbers) {
  AtRest rope("hanging-rope.toml", {"analysis.tolerance=1e-12"});
  const Sensitivities found = rope.to({});
  const results::Result result = result_of(rope);
  EXPECT_FALSE(result.sensitivities.value().rows.empty());
  for (const auto& row : result.sensitivities.value().rows) {
    const auto same = [&](const NumberEffect& effect) { return effect.number.path == row.path; };
    const auto effect = std::ranges::find_if(found.effects, same);
    ASSERT_NE(effect, found.effects.end()) << row.path;
    const auto f = std::ranges::find(found.figures, row.figure, &results::NamedScalar::name);
    EXPECT_EQ(row.value, effect->number.value);
    EXPECT_EQ(row.unit, effect->number.unit);
    EXPECT_NEAR(row.derivative, effect->per_unit[static_cast<std::size_t>(f - found.figures.begin())],
                1e-9 * std::abs(row.derivative));
  }
}

TEST(KeySensitivities, AreNotThereAfterAnInterruption) {
  AtRest rope("hanging-rope.toml", {});
  const std::atomic<bool> interrupt = true;
  const auto found = result_of(rope, &interrupt).sensitivities.value();
  EXPECT_TRUE(found.rows.empty());
  EXPECT_NE(found.note.find("interrupted: 0 of "), std::string::npos) << found.note;
}

TEST(KeySensitivities, AreNotThereWithoutAnEquilibrium) {
  AtRest rope("hanging-rope.toml", {});
  rope.solution.status = SolveStatus::not_converged;
  rope.solution.reason = "it was too slow";
  const auto found = result_of(rope).sensitivities.value();
  EXPECT_TRUE(found.rows.empty());
  EXPECT_EQ(found.note, "there are no derivatives, because the scene ended not converged: it was too slow");
}

}  // namespace
}  // namespace netloft::studies
