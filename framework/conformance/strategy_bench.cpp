// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/strategy_bench.hpp"

namespace netloft::conformance {

namespace {

// This chain has many masses, because coarser meshes do not help with a chain of twelve masses.
const PracticeScene kLong{.like = {.stiffness = 45500, .unknowns = 256}, .levels = 2};

}  // namespace

const std::vector<NamedScene>& scenes() {
  static const std::vector<NamedScene> all = {
      {"a linear chain", kLinear},
      {"a chain that Newton's method does not solve at once", kGripped},
      {"a chain with two meshes", kTwoMeshes},
      {"a column that buckles", kBuckling},
      {"a buckling column whose growing disturbance the host does not provide", kBucklingUnseen},
      {"a chain without an equilibrium", kRunaway},
      {"a chain in a current", kFlowing}};
  return all;
}

const std::vector<NamedScene>& easy_scenes() {
  static const std::vector<NamedScene> all = {{"a linear chain", kLinear},
                                              {"a chain in a current", kFlowing},
                                              {"a long chain with two meshes", kLong}};
  return all;
}

std::vector<NamedScene> all_scenes() {
  std::vector<NamedScene> all = scenes();
  for (const auto& [name, scene] : scenes()) {
    for (const double budget : {1.0, 3.0, 10.0, 40.0}) {
      all.push_back({name, scene});
      all.back().scene.budget = budget;
    }
    for (const int stage : {0, 1, 2}) {
      all.push_back({name, scene});
      all.back().scene.interrupted_at = stage;
    }
  }
  return all;
}

}  // namespace netloft::conformance
