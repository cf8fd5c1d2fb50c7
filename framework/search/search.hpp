// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "framework/search/levels.hpp"
#include "framework/search/variant_problems.hpp"

#include <functional>
#include <limits>
#include <map>
#include <string>

namespace netloft {

struct SolverUse {
  const SolverType* type = nullptr;
  Values parameters;
};

struct StrategyUse {
  const StrategyType* type = nullptr;
  Values parameters;
};

/// Solver and limits of a search, and functions to call during the search.
struct SearchOptions {
  SolverUse solver;  // solver of stages that name no solver
  Limits limits;     // limits for the scene itself; `seconds` and `interrupt` apply to the whole search
  // Budget, in Newton iterations of the scene (work.hpp).
  double work = std::numeric_limits<double>::infinity();
  std::function<void(const IterationRecord&)> on_iteration;
  KeptPoint* kept = nullptr;  // receives accepted points of the original scene
  /// Called after every stage with its record and its final displacements. If the stage was on a coarser
  /// mesh, the displacements are interpolated to the original mesh.
  std::function<void(const StageRecord&, std::span<const double> u)> on_stage = {};
  /// Parameters that the user set for solvers and strategies, by their type ("newton/newton"). They override
  /// parameters that a strategy sets in a stage.
  std::map<std::string, Values> given = {};
};

/// Lets a strategy find the equilibrium of a scene from the displacements `start` of the unknowns (empty:
/// from the initial shape), and chooses among the answers of the strategy (shapes.hpp). The strategy sees a
/// netloft_search: it requests stages, each a solve of a variant by a solver within a budget, and reports
/// equilibria of the scene itself. The host counts the work of every stage, assesses it (verdict.hpp) and
/// stores its record. Without an answer, the solution is the stage of the scene itself that came closest to
/// balance, with a reason. All stages use the same memory of elements (friction); at the end, the elements of
/// `source` remember the answer. Throws SceneError or PluginRefused if a stage cannot be made.
///
/// If the scene has settings (such as the length of a rope that is to have a given tension), they are found
/// as well (settings.hpp). The answer then belongs to the scene scaled by `Solution::factors`: the caller
/// applies set_factors to its own scene and lets the elements of that scene store the answer.
Solution find_equilibrium(const VariantSource& source, const SearchOptions& options,
                          const StrategyUse& strategy, const std::vector<double>& start = {});

/// Describes the attempts of a strategy, their order and reasons, one per line, without solving anything.
/// Empty if the strategy gives no description.
std::string explain_strategy(const VariantSource& source, const SearchOptions& options,
                             const StrategyUse& strategy);

/// Says why a strategy cannot search this scene: it needs features that the scene does not have, or another
/// strategy that is named in its parameters needs them. nullopt if the strategy can search the scene.
std::optional<std::string> why_unfit(const VariantSource& source, const SearchOptions& options,
                                     const StrategyUse& strategy);

/// Parses values such as "method=classic,damping=1" for the parameters in a table. Throws
/// std::invalid_argument with a sentence.
Values parse_parameters(std::span<const netloft_parameter> table, const std::string& text);

}  // namespace netloft
