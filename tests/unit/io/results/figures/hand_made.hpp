// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace netloft::results {

/// A scene without a net plan, for which a test declares the roles of the parts in a gear.
class HandMade {
 public:
  /// Names of the parts that have a role in the gear.
  struct Parts {
    std::vector<std::string> panels, ropes, pieces;
    std::string headline = "headline", footrope = "footrope";
    int times = 1;
    std::vector<std::string> warps;  // of `ropes`
    double ship_speed = 0;           // [m/s]
  };

  HandMade(const std::filesystem::path& file, const Parts& parts,
           const std::vector<std::string>& overrides = {})
      : scene_({file, overrides, 1}, netloft::test::shipped_plugins()) {
    if (scene_.prepare([&](scenes::LoadedScene& loaded) { loaded.gear = name_parts(loaded, parts); }) !=
        runs::PreparedScene::State::ready)
      throw std::invalid_argument(scene_.diagnostics().render(false));
  }

  const scenes::LoadedScene& loaded() { return scene_.loaded(); }

  /// Figures at the initial positions.
  std::vector<NamedScalar> at_start() {
    Assembler& assembler = scene_.assembler();
    return find_figures(loaded(), assembler, ask_elements(loaded().scene, assembler, assembler.start()));
  }
  /// The result in equilibrium.
  Result solved() {
    const Solution solution = runs::find_equilibrium(scene_);
    EXPECT_EQ(solution.status, SolveStatus::converged) << solution.reason;
    return make_result(loaded(), scene_.assembler(), solution);
  }

 private:
  static scenes::GearInScene name_parts(const scenes::LoadedScene& loaded, const Parts& parts) {
    scenes::GearInScene gear;
    gear.times = parts.times, gear.headline = parts.headline, gear.footrope = parts.footrope;
    gear.panels = numbers(loaded, parts.panels), gear.ropes = numbers(loaded, parts.ropes),
    gear.pieces = numbers(loaded, parts.pieces);
    gear.ship_speed = parts.ship_speed;
    if (!parts.warps.empty()) gear.roles["warp"] = numbers(loaded, parts.warps);
    return gear;
  }
  static std::vector<std::uint32_t> numbers(const scenes::LoadedScene& loaded,
                                            const std::vector<std::string>& names) {
    std::vector<std::uint32_t> found;
    for (const auto& name : names)
      for (std::uint32_t p = 0; p < loaded.scene.parts.size(); ++p)
        if (loaded.scene.parts[p].name == name && !loaded.scene.parts[p].companion) found.push_back(p);
    return found;
  }

  runs::PreparedScene scene_;
};

/// A scene file of the running test.
inline std::filesystem::path written(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path = std::filesystem::temp_directory_path() /
                    (std::string("netloft-") + test->test_suite_name() + "-" + test->name() + ".toml");
  std::ofstream(path) << text;
  return path;
}

/// A figure that must be there.
inline const NamedScalar& figure(const std::vector<NamedScalar>& figures, const std::string& name) {
  const NamedScalar* found = find_scalar(figures, name);
  if (!found) throw std::invalid_argument("no figure " + name);
  return *found;
}
inline double value(const std::vector<NamedScalar>& figures, const std::string& name) {
  return figure(figures, name).value;
}

}  // namespace netloft::results
