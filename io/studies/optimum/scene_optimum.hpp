// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/plot.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/optimum/check_optimum.hpp"
#include "io/studies/optimum/point_history.hpp"

namespace netloft::studies {

/// The answer of `netloft optimise`.
struct SceneOptimum {
  OptimumFile file;
  CheckedOptimum checked;
  Optimum found;  // in the units of the variables and of the figures
  /// The best objective before variables were set to multiples of their steps; nullopt if there are no steps.
  std::optional<double> unrounded;
  std::vector<StudyFigure> before, after;  // all figures at the start and at the best point; empty if unknown
  int solves = 0;  // number of searches for an equilibrium; points of the history are not counted
  double cpu_seconds = 0;
  bool is_interrupted = false;
  std::string trouble;  // why the last failed point has no equilibrium

  /// "optimal", "interrupted", "infeasible" (no point satisfies all constraints) or "not converged".
  std::string status() const;
};

/// Finds the values of the variables at which the objective is best. Every solve starts from the equilibrium
/// at the last accepted point, moved by its derivatives (runs::Tangent). Points in `history` are not solved
/// again. At the end, variables with a step are rounded one by one: each is fixed at the nearest multiple of
/// its step or, if that fails, at the multiple on the other side; then the search for the other variables is
/// repeated. Throws formats::WriteError.
SceneOptimum optimise_scene(OptimumFile file, CheckedOptimum checked, const std::filesystem::path& folder,
                            Registry& registry, PointHistory& history, const runs::Watch& watch,
                            const std::function<void(const OptimumPoint&)>& on_point = {});

/// Arguments of `--set` that set the variables of the scene to these values.
std::vector<std::string> overrides_of(const OptimumFile& file, const std::vector<double>& parameters);

/// A scene file that includes the scene of `file`, which is in `folder`, and changes it to the best values.
/// `place` is the folder in which the new file will be stored.
std::string scene_text(const SceneOptimum& optimum, const std::filesystem::path& folder,
                       const std::filesystem::path& place);

/// The report as text, and as one JSON object.
std::string optimum_text(const SceneOptimum& optimum);
std::string optimum_json(const SceneOptimum& optimum);
/// A plot of the objective against the number of solves, relative to its value at the start.
formats::LinePlot optimum_plot(const SceneOptimum& optimum);

}  // namespace netloft::studies
