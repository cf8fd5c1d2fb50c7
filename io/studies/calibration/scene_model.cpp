// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/scene_model.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"

#include "io/studies/sensitivity/sensitivity.hpp"
#include "io/studies/sweep/path_run.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

constexpr int kIterations = 30;  // limit of iterations from the previous equilibrium; a new search follows

double figure_named(const std::vector<StudyFigure>& figures, const std::string& name) {
  const auto at = std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.name == name; });
  return at == figures.end() ? std::numeric_limits<double>::quiet_NaN() : at->value;
}

bool all_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

/// A solved scene, from which the next solve starts.
struct SceneModel::Solved {
  std::unique_ptr<runs::PreparedScene> prepared;
  std::vector<double> parameters;
  Solution solution;
  bool is_stable() const { return !prepared || solution.status == SolveStatus::converged; }
};

namespace {

/// Changes "path=value" that set the variables of a scene to `parameters`.
std::vector<std::string> values_of(const CalibrationFile& file, std::size_t scene,
                                   const std::vector<double>& parameters) {
  std::vector<std::string> words;
  for (std::size_t v = 0; v < file.variables.size(); ++v) {
    const CalibrationVariable& variable = file.variables[v];
    if (std::find(variable.scenes.begin(), variable.scenes.end(), scene) == variable.scenes.end()) continue;
    for (auto& word : variable.variable.overrides(variable.variable.value_of(parameters[v])))
      words.push_back(std::move(word));
  }
  return words;
}

}  // namespace

std::vector<std::string> overrides_of(const CalibrationFile& file, std::size_t scene,
                                      const std::vector<double>& parameters) {
  std::vector<std::string> words = file.scenes[scene].set;
  for (auto& word : values_of(file, scene, parameters)) words.push_back(std::move(word));
  return words;
}

SceneModel::SceneModel(const CalibrationFile& file, std::filesystem::path folder, Registry& registry,
                       runs::Watch watch, OnSolve on_solve)
    : file_(file),
      folder_(std::move(folder)),
      registry_(registry),
      watch_(std::move(watch)),
      on_solve_(std::move(on_solve)),
      last_(file.scenes.size()) {
  for (const CalibrationScene& scene : file_.scenes)
    sources_.emplace_back(folder_ / scene.file, scene.set, 1);
}

SceneModel::~SceneModel() = default;

std::vector<std::string> SceneModel::unstable() const {
  std::vector<std::string> names;
  for (std::size_t s = 0; s < last_.size(); ++s)
    if (!last_[s].is_stable()) names.push_back(file_.scenes[s].name);
  return names;
}

/// The measured figures of one scene, in the order of the file.
std::optional<std::vector<double>> SceneModel::figures(std::size_t scene,
                                                       const std::vector<double>& parameters) try {
  Solved& from = last_[scene];
  runs::CaseSource source = sources_[scene];
  formats::append(source.changes, formats::read_changes(values_of(file_, scene, parameters)));
  auto prepared = std::make_unique<runs::PreparedScene>(std::move(source), registry_);
  trouble_ = file_.scenes[scene].name + ": ";
  if (prepared->prepare() != runs::PreparedScene::State::ready)
    return trouble_ += "the scene has errors with these values", std::nullopt;
  Solution found;
  ++solves_;
  if (from.prepared && runs::have_same_topology(*prepared, *from.prepared))
    found = runs::continue_equilibrium(*prepared, prepared->assembler().displacements_to(from.solution.x),
                                       kIterations, watch_);
  if (!is_stationary(found)) found = runs::find_equilibrium(*prepared, watch_);
  if (on_solve_) on_solve_(static_cast<std::size_t>(solves_), file_.scenes[scene].name);
  if (!is_stationary(found))
    return trouble_ += std::string(name_of(found.status)) + "; " + found.reason, std::nullopt;
  const auto all = figures_of(*prepared, found);
  std::vector<double> figures;
  for (const MeasuredFigure& m : file_.measured)
    if (m.scene == scene) figures.push_back(figure_named(all, m.figure));
  if (!all_finite(figures)) return trouble_ += "a figure has no value there", std::nullopt;
  from = {std::move(prepared), parameters, std::move(found)};
  return figures;
} catch (const formats::Interrupted&) {
  return std::nullopt;
}

std::optional<std::vector<double>> SceneModel::predict(const std::vector<double>& parameters) {
  std::vector<std::vector<double>> of_scene;
  for (std::size_t s = 0; s < file_.scenes.size(); ++s) {
    if (is_interrupted()) return std::nullopt;
    auto found = figures(s, parameters);
    if (!found) return std::nullopt;
    of_scene.push_back(std::move(*found));
  }
  std::vector<double> predicted;
  std::vector<std::size_t> next(of_scene.size(), 0);
  for (const MeasuredFigure& m : file_.measured) predicted.push_back(of_scene[m.scene][next[m.scene]++]);
  return predicted;
}

std::optional<std::vector<std::vector<double>>> SceneModel::slopes(const std::vector<double>& parameters) {
  std::vector<std::vector<double>> rows(file_.measured.size(), std::vector<double>(parameters.size(), 0.0));
  for (std::size_t s = 0; s < file_.scenes.size(); ++s)
    if (is_interrupted() || !add_slopes(s, parameters, rows)) return std::nullopt;
  return rows;
}

/// Adds the derivatives of the measured figures of one scene with respect to its variables. Returns false if
/// there are no derivatives.
bool SceneModel::add_slopes(std::size_t scene, const std::vector<double>& parameters,
                            std::vector<std::vector<double>>& rows) {
  if (last_[scene].parameters != parameters && !figures(scene, parameters)) return false;
  std::vector<std::string> figures_here;
  std::vector<SceneNumber> numbers;
  std::vector<std::size_t> of_row, of_column;
  for (std::size_t m = 0; m < rows.size(); ++m)
    if (file_.measured[m].scene == scene) {
      figures_here.push_back(file_.measured[m].figure);
      of_row.push_back(m);
    }
  for (std::size_t v = 0; v < parameters.size(); ++v)
    if (std::ranges::count(file_.variables[v].scenes, scene) > 0) {
      numbers.push_back(number_of(file_.variables[v].variable, parameters[v]));
      of_column.push_back(v);
    }
  const FigureSlopes slopes =
      slopes_of(*last_[scene].prepared, last_[scene].solution, figures_here, numbers, watch_.interrupt);
  if (slopes.rows.empty()) trouble_ = file_.scenes[scene].name + ": " + slopes.why_not;
  for (std::size_t f = 0; f < slopes.rows.size(); ++f)
    for (std::size_t n = 0; n < numbers.size(); ++n) rows[of_row[f]][of_column[n]] = slopes.rows[f][n];
  return !slopes.rows.empty();
}

}  // namespace netloft::studies
