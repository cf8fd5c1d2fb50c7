// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/scene_source.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <stdexcept>

namespace netloft::test {

/// A scene of the gear library, solved as its file says.
struct SolvedFile {
  scenes::LoadedScene loaded;
  Solved solved;

  const scenes::PartGeometry& part(const std::string& name) const {
    for (const auto& p : loaded.parts)
      if (p.name == name) return p;
    throw std::invalid_argument("no part \"" + name + "\"");
  }
  /// The one node of a set, such as "end" of "rope".
  std::uint32_t node(const std::string& part_name, const std::string& set) const {
    const scenes::PartGeometry& p = part(part_name);
    return p.nodes.at(p.sets.at(set).at(0));
  }
};

inline SolvedFile solve_file(const std::string& name, const std::vector<std::string>& overrides = {}) {
  formats::Diagnostics diagnostics;
  bool refused = false;
  scenes::LoadedScene loaded =
      scenes::SceneSource(test::source_folder() + "/gear-library/scenes/" + name)
          .instance(formats::read_changes(overrides), shipped_plugins(), diagnostics, refused);
  if (diagnostics.errors()) throw std::invalid_argument(diagnostics.render(false));
  Solving how;
  how.solver_parameters = loaded.analysis.solver_parameters;
  how.limits = loaded.analysis.limits;
  how.solver = loaded.analysis.solver;
  Solved solved = solve(loaded.scene, how);
  return {std::move(loaded), std::move(solved)};
}

}  // namespace netloft::test
