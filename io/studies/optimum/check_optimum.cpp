// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/optimum/check_optimum.hpp"

#include "io/formats/text/likely_path.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/units/units.hpp"
#include "io/results/file/provenance.hpp"
#include "io/runs/tangent.hpp"
#include "io/studies/sensitivity/scene_numbers.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "io/studies/variables/scene_faults.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace netloft::studies {

namespace {

constexpr double kLittle = 1e-6;  // a change by this fraction of a range must not change the mesh topology

/// Compares a file with its scene. The member functions are the steps, in the order of execution.
class OptimumInspection {
 public:
  OptimumInspection(const OptimumFile& file, const std::filesystem::path& folder, Registry& registry,
                    formats::Diagnostics& diagnostics, const std::function<void(double)>& on_budget)
      : file_(file),
        source_(folder / file.scene, file.set),
        registry_(registry),
        diagnostics_(diagnostics),
        on_budget_(on_budget) {
    for (const OptimumVariable& v : file.variables)
      for (const FollowingKey& key : v.variable.keys) places_.emplace(key.path, key.place);
    for (const std::string& word : file.set) places_.emplace(word.substr(0, word.find('=')), file.set_place);
  }

  CheckedOptimum inspect() {
    const auto scene = open({}, file_.scene_place);
    if (!scene) return std::move(checked_);
    if (scene->loaded().analysis.kind == AnalysisKind::dynamics)
      diagnostics_.error(file_.scene_place, "the scene is a motion, but an optimum is an equilibrium",
                         "set = [\"analysis.kind=static\"]");
    if (!scene->loaded().scene.settings.empty())
      diagnostics_.error(file_.scene_place, "the scene finds a length by itself, which has no derivatives",
                         "leave out ship.warp.tension, and make the length a variable");
    if (on_budget_) on_budget_(scene->loaded().analysis.limits.seconds);
    Solution at_start;
    at_start.x = scene->assembler().start();
    at_start.residual.resize(at_start.x.size());
    known_ = figures_of(*scene, at_start);
    take_objective();
    for (const FigureLimits& row : file_.constraints) take_constraint(row);
    checked_.scene = scene;
    for (const OptimumVariable& v : file_.variables) take_variable(v);
    find_inputs(*scene);
    return std::move(checked_);
  }

 private:
  /// Opens the scene with changes. If that fails, returns nullptr and stores the faults in `scene_faults_`.
  /// `like` is a scene whose mesh topology is used, or nullptr.
  std::shared_ptr<runs::PreparedScene> try_open(const std::vector<formats::Change>& changes,
                                                const runs::PreparedScene* like = nullptr) {
    runs::CaseSource source = source_;
    formats::append(source.changes, changes);
    auto scene = std::make_shared<runs::PreparedScene>(std::move(source), registry_);
    const auto state = like ? scene->prepare_like(*like) : scene->prepare();
    scene_faults_ = scene->diagnostics();
    checked_.refused |= state == runs::PreparedScene::State::refused;
    return state == runs::PreparedScene::State::ready ? scene : nullptr;
  }

  /// Opens the scene like try_open(), and reports its faults: at the key of the file that causes a fault or,
  /// if no key causes it, at `place`.
  std::shared_ptr<runs::PreparedScene> open(const std::vector<formats::Change>& changes,
                                            const formats::Place& place) {
    const auto scene = try_open(changes);
    if (!scene || changes.empty()) hand_on_faults(scene_faults_, places_, place, diagnostics_);
    return scene;
  }

  /// The figure of this name. If there is none, reports an error and returns nullptr.
  const StudyFigure* find(const std::string& name, const formats::Place& place) {
    std::vector<std::string> names;
    for (const StudyFigure& figure : known_) {
      if (figure.name == name) return &figure;
      names.push_back(figure.name);
    }
    const auto near = formats::likely_path(name, names);
    diagnostics_.error(
        place, "the scene does not report a figure \"" + name + "\"",
        near ? "did you mean \"" + *near + "\"?" : "such as results/NAME, gear/mouth/headline_height");
    return nullptr;
  }

  void take_objective() {
    checked_.problem.maximise = file_.maximise;
    const StudyFigure* figure =
        file_.objective.empty() ? nullptr : find(file_.objective, file_.objective_place);
    checked_.figures.push_back(file_.objective);
    checked_.units.push_back(figure ? figure->unit : "");
    if (!figure || file_.unit.empty()) return;
    const formats::Quantity factor = formats::to_si(formats::format(1, figure->unit), file_.unit);
    checked_.objective_factor = factor.value;
    if (!factor.ok())
      diagnostics_.error(file_.unit_place,
                         "objective.unit: " + file_.objective + " is " +
                             formats::dimension_name(figure->unit) + " in " + figure->unit + ", which \"" +
                             file_.unit + "\" cannot express",
                         "unit = \"" + figure->unit + "\"");
  }

  void take_constraint(const FigureLimits& row) {
    const StudyFigure* figure = row.figure.empty() ? nullptr : find(row.figure, row.place);
    Bounds bounds;
    if (figure && !row.at_least.empty()) bounds.low = in_unit(row, row.at_least, figure->unit, row.low_place);
    if (figure && !row.at_most.empty()) bounds.high = in_unit(row, row.at_most, figure->unit, row.high_place);
    if (bounds.low > bounds.high)
      diagnostics_.error(row.low_place,
                         row.figure + ": at_least " + row.at_least + " is more than at_most " + row.at_most);
    checked_.figures.push_back(row.figure);
    checked_.units.push_back(figure ? figure->unit : "");
    checked_.problem.constraints.push_back(bounds);
  }

  double in_unit(const FigureLimits& row, const std::string& text, const std::string& unit,
                 const formats::Place& place) {
    const bool is_pure = formats::read_as_written(text).unit.empty();
    const formats::Quantity read = formats::to_si(text, is_pure ? "1" : unit);
    if (!read.ok()) diagnostics_.error(place, row.figure + ": " + read.error, read.hint);
    return read.value;
  }

  void take_variable(const OptimumVariable& v) {
    const auto [low, high] = *v.variable.interval;
    const std::optional<double> start = v.start ? v.start : start_in_scene(v.variable);
    checked_.problem.parameters.push_back({low, high});
    checked_.problem.start.push_back(start.value_or(low));
    if (!start) return;
    if (!v.variable.interval->contains(*start))
      return diagnostics_.error(v.variable.place,
                                v.variable.name + " is " + formats::format(*start, v.variable.unit) +
                                    " in the scene, outside its range, " +
                                    formats::format(low, v.variable.unit) + " to " +
                                    formats::format(high, v.variable.unit),
                                "widen the range, or say where the search begins: start = \"" +
                                    formats::format(low, v.variable.unit) + "\"");
    const auto at = [&](double number) { return v.variable.changes(v.variable.value_of(number)); };
    const auto here = open(at(*start), v.variable.place);
    if (!here) return;
    const double step = kLittle * (high - low) * (*start < (low + high) / 2 ? 1 : -1);
    const auto beside = try_open(at(*start + step), here.get());
    if (beside && runs::have_same_topology(*here, *beside)) {
      if (open(at(low), v.variable.place)) open(at(high), v.variable.place);
      return;
    }
    diagnostics_.error(v.variable.place,
                       v.variable.name + " is not continuous: " +
                           (beside ? "the mesh changes with it" : first_fault(scene_faults_)),
                       "only a study can vary it: netloft study");
  }

  /// The number that the scene states for a variable; nullopt after an error.
  std::optional<double> start_in_scene(const Variable& variable) {
    const FollowingKey& key = variable.keys.front();
    try {
      const auto found = chosen_numbers(*checked_.scene, {key.path});
      if (found.size() > 1) throw std::invalid_argument(key.path + " is a table; name one of its numbers");
      const SceneNumber& number = found.front();
      const auto value = number_in_unit(formats::format(number.value, number.unit), variable.unit);
      if (value) return (*value - key.offset) / key.factor;
      diagnostics_.error(
          key.place,
          key.path + " is " + formats::format(number.value, number.unit) +
              " in the scene, but the range of the variable has " +
              (variable.unit.empty() ? "no unit" : "the unit " + variable.unit),
          number.unit.empty() ? "write the range without a unit" : "write the range in " + number.unit);
    } catch (const std::invalid_argument& fault) {
      diagnostics_.error(key.place, variable.name + ": " + fault.what(),
                         "or give it a start, such as start = \"" +
                             formats::format(variable.interval->low, variable.unit) + "\"");
    }
    return std::nullopt;
  }

  void find_inputs(const runs::PreparedScene& scene) {
    std::string all = results::program_version();
    for (const formats::SourceFile& one : scene.loaded().files) all += "\n" + one.hash;
    for (const std::string& word : file_.set) all += "\n" + word;
    for (const OptimumVariable& v : file_.variables)
      for (const std::string& word : v.variable.overrides(v.variable.value_of(1))) all += "\n" + word;
    checked_.inputs = formats::fnv1a64(all);
  }

  const OptimumFile& file_;
  runs::CaseSource source_;
  Registry& registry_;
  formats::Diagnostics& diagnostics_;
  const std::function<void(double)>& on_budget_;
  std::map<std::string, formats::Place> places_;  // places of keys in the file
  formats::Diagnostics scene_faults_;             // faults of the scene that was opened last
  std::vector<StudyFigure> known_;                // figures that the scene reports
  CheckedOptimum checked_;
};

}  // namespace

CheckedOptimum check_optimum(const OptimumFile& file, const std::filesystem::path& folder, Registry& registry,
                             formats::Diagnostics& diagnostics,
                             const std::function<void(double)>& on_budget) {
  return OptimumInspection(file, folder, registry, diagnostics, on_budget).inspect();
}

}  // namespace netloft::studies
