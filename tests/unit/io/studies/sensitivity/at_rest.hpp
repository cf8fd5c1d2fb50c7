// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {

/// A scene of the library in equilibrium.
struct AtRest {
  AtRest(const std::string& file, const std::vector<std::string>& changes)
      : scene({source_folder() + "/gear-library/scenes/" + file, changes, 1}, shipped_plugins()) {
    EXPECT_EQ(scene.prepare(), runs::PreparedScene::State::ready) << scene.diagnostics().render(false);
    solution = runs::find_equilibrium(scene);
    EXPECT_EQ(solution.status, SolveStatus::converged) << solution.reason;
  }
  std::vector<studies::SceneNumber> numbers(const std::vector<std::string>& paths) {
    return studies::chosen_numbers(scene, paths);
  }
  studies::Sensitivities to(const std::vector<std::string>& paths, bool with_long_step = false) {
    const auto result = results::make_result(scene.loaded(), scene.assembler(), solution);
    return studies::find_sensitivities(scene, solution,
                                       {.figures = studies::all_figures(result),
                                        .numbers = numbers(paths),
                                        .with_long_step = with_long_step});
  }
  double figure(const std::string& name) {
    const auto result = results::make_result(scene.loaded(), scene.assembler(), solution);
    const auto* in_results = results::find_scalar(result.scalars, name);
    return (in_results ? in_results : results::find_scalar(result.figures, name))->value;
  }

  runs::PreparedScene scene;
  Solution solution;
};

}  // namespace netloft::test
