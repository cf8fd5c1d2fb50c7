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

/// A solver and the values of its parameters.
struct SolverUse {
  const SolverType* type = nullptr;
  Values parameters;
};

/// A strategy and the values of its parameters.
struct StrategyUse {
  const StrategyType* type = nullptr;
  Values parameters;
};

/// The means of a search and the limits on what it spends.
struct SearchOptions {
  SolverUse solver;  // of stages that name no other
  Limits limits;     // of the scene itself; `seconds` and `interrupt` hold for the whole search
  double work = std::numeric_limits<double>::infinity();  // budget, in the units of work.hpp
  std::function<void(const IterationRecord&)> on_iteration;
  KeptPoint* kept = nullptr;  // where accepted points of the scene as it is written are kept
  /// Called after every stage with its record and the displacements of the scene itself where it ended; those
  /// of a stage on a coarser mesh are read off it.
  std::function<void(const StageRecord&, std::span<const double> u)> on_stage = {};
  /// What the user says of solvers and strategies that stages name, by type ("newton/newton"): it holds over
  /// what the strategy asks for.
  std::map<std::string, Values> given = {};
};

/// Lets a strategy bring a scene to equilibrium, from displacements `start` of its unknowns (empty: from its
/// sketch), and chooses among its answers (shapes.hpp). The strategy sees a netloft_search: it asks for
/// stages, each a solve of a variant by a solver within a budget, and hands over equilibria of the scene
/// itself. The host counts the work of every stage, judges it (verdict.hpp) and keeps its record. Where there
/// is no answer the solution is the stage of the scene itself that came closest, and says so. All stages see
/// the same past; the elements of the source (friction) remember the answer at the end. Throws SceneError or
/// PluginRefused where a stage asks for what cannot be made.
///
/// Of a scene with settings these are found, too (settings.hpp): the answer is then of another scene, with
/// `Solution::factors`, which the caller makes of his own by set_factors, and whose elements he lets
/// remember.
Solution find_equilibrium(const VariantSource& source, const SearchOptions& options,
                          const StrategyUse& strategy, const std::vector<double>& start = {});

/// What a strategy would try in which order and why, a line each; empty where it does not say. Solves
/// nothing.
std::string explain_strategy(const VariantSource& source, const SearchOptions& options,
                             const StrategyUse& strategy);

/// "method=classic,damping=1" as values of a table of parameters. Throws std::invalid_argument with a
/// sentence.
Values parse_parameters(std::span<const netloft_parameter> table, const std::string& text);

}  // namespace netloft
