// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/method_bench.hpp"
#include "framework/conformance/practice_search.hpp"

#include <vector>

namespace netloft::conformance {

/// A strategy with its defaults, run on searches of practice scenes.
struct StrategyBench : MethodBench {
  StrategyBench(const StrategyType& t, const ConformanceOptions& o)
      : MethodBench(t.parameters, t.strategy.parameter_bytes, o), type(t), seed(o.seed) {}

  int run(PracticeSearch& search) { return run(search, parameters.data()); }
  int run(PracticeSearch& search, const void* with) {
    return guarded(type.type, "run", NETLOFT_ERROR,
                   [&] { return type.strategy.run(with, &search.interface()); });
  }
  int explain(PracticeSearch& search, char* text, std::uint32_t size) {
    return guarded(type.type, "explain", NETLOFT_ERROR,
                   [&] { return type.strategy.explain(parameters.data(), &search.interface(), text, size); });
  }
  bool takes(const PracticeSearch& search) const { return (type.strategy.needs & ~search.traits()) == 0; }

  const StrategyType& type;
  std::uint64_t seed;
};

struct NamedScene {
  const char* name;
  PracticeScene scene;
};

inline const PracticeScene kLinear{};
// Newton's method diverges from the initial shape. It converges in stages with caps on stiffness, if each cap
// is ten times the previous one.
inline const PracticeScene kGripped{.like = {.grip = 1e4}};
inline const PracticeScene kTwoMeshes{.like = {.grip = 10}, .levels = 2};
inline const PracticeScene kBuckling{.like = {.buckling = 10, .unknowns = 13}};
inline const PracticeScene kBucklingUnseen{.like = {.buckling = 10, .unknowns = 13}, .knows_growth = false};
// A chain without equilibrium: in the symbols of practice.hpp, k² < 4 n f²/l², so that the first mass, which
// bears the loads of all n masses, cannot be in balance.
inline const PracticeScene kRunaway{.like = {.runaway = 0.05}};
inline const PracticeScene kFlowing{.like = {.swirl = 5}};

/// One scene of every kind.
const std::vector<NamedScene>& scenes();
/// Scenes that a single solve brings to equilibrium.
const std::vector<NamedScene>& easy_scenes();
/// Returns scenes(), the same scenes with a small budget of work, and the same scenes with an interrupt by
/// the user.
std::vector<NamedScene> all_scenes();

}  // namespace netloft::conformance
