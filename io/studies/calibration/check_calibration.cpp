// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/scene_model.hpp"

#include "io/formats/text/likely_path.hpp"
#include "io/formats/units/units.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "io/studies/variables/scene_faults.hpp"

#include <algorithm>

namespace netloft::studies {

namespace {

/// Opens all scenes of the calibration, one after another, and collects errors.
class CalibrationInspection {
 public:
  CalibrationInspection(const CalibrationFile& file, const std::filesystem::path& folder, Registry& registry,
                        formats::Diagnostics& diagnostics, const std::function<void(double)>& on_budget)
      : file_(file), folder_(folder), registry_(registry), diagnostics_(diagnostics), on_budget_(on_budget) {
    checked_.measured.resize(file.measured.size());
    checked_.units.resize(file.measured.size());
  }

  CheckedCalibration inspect() {
    for (std::size_t scene = 0; scene < file_.scenes.size(); ++scene) inspect(scene);
    return std::move(checked_);
  }

 private:
  std::vector<double> means() const {
    std::vector<double> means;
    for (const auto& v : file_.variables) means.push_back(v.prior_mean());
    return means;
  }

  /// Opens a scene at both ends of the interval of each variable. Stops at the first wrong value, because
  /// later values would usually cause the same error.
  void inspect(std::size_t scene) {
    if (!open(scene, means(), true)) return;
    for (std::size_t v = 0; v < file_.variables.size(); ++v) {
      const auto& [low, high] = *file_.variables[v].variable.interval;
      for (const double end : {low, high}) {
        auto at = means();
        at[v] = end;
        if (!open(scene, at, false)) return;
      }
    }
  }

  bool open(std::size_t scene, const std::vector<double>& parameters, bool learns) {
    const CalibrationScene& s = file_.scenes[scene];
    std::map<std::string, formats::Place> places;
    for (const auto& v : file_.variables)
      for (const auto& key : v.variable.keys) places.emplace(key.path, v.variable.place);
    for (const std::string& word : s.set) places.emplace(word.substr(0, word.find('=')), s.place);
    runs::PreparedScene prepared({folder_ / s.file, overrides_of(file_, scene, parameters), 1}, registry_);
    const runs::PreparedScene::State state = prepared.prepare();
    if (learns || state != runs::PreparedScene::State::ready)
      hand_on_faults(prepared.diagnostics(), places, s.place, diagnostics_);
    checked_.refused |= state == runs::PreparedScene::State::refused;
    if (state == runs::PreparedScene::State::ready && learns) learn(scene, prepared);
    return state == runs::PreparedScene::State::ready;
  }

  void learn(std::size_t scene, runs::PreparedScene& prepared) {
    if (prepared.loaded().analysis.kind == AnalysisKind::dynamics)
      return diagnostics_.error(file_.scenes[scene].place,
                                "the scene is a motion, but a calibration compares equilibria",
                                "set = [\"analysis.kind=static\"]");
    if (on_budget_) on_budget_(prepared.loaded().analysis.limits.seconds);
    Solution at_start;
    at_start.x = prepared.assembler().start();
    at_start.residual.resize(at_start.x.size());
    const auto figures = figures_of(prepared, at_start);
    for (std::size_t m = 0; m < file_.measured.size(); ++m)
      if (file_.measured[m].scene == scene) take_figure(m, figures);
  }

  void take_figure(std::size_t m, const std::vector<StudyFigure>& figures) {
    const MeasuredFigure& row = file_.measured[m];
    std::vector<std::string> known;
    for (const StudyFigure& figure : figures) {
      known.push_back(figure.name);
      if (figure.name == row.figure) return take_numbers(m, figure.unit);
    }
    const auto near = formats::likely_path(row.figure, known);
    diagnostics_.error(row.place, "the scene does not report a figure \"" + row.figure + "\"",
                       near ? "did you mean \"" + *near + "\"?"
                            : "such as results/NAME, gear/mouth/headline_height, held/NAME/x");
  }

  void take_numbers(std::size_t m, const std::string& unit) {
    const MeasuredFigure& row = file_.measured[m];
    checked_.units[m] = unit;
    checked_.measured[m] = {in_unit(row, row.value, unit), in_unit(row, row.deviation, unit)};
    if (!(checked_.measured[m].deviation > 0))
      diagnostics_.error(row.value_place, "the deviation of " + row.figure + " must be above zero");
  }

  double in_unit(const MeasuredFigure& row, const std::string& text, const std::string& unit) {
    const bool is_pure = formats::read_as_written(text).unit.empty();
    const formats::Quantity read = is_pure ? formats::to_si(text, "1") : formats::to_si(text, unit);
    if (read.ok()) return read.value;
    diagnostics_.error(row.value_place, row.figure + ": " + read.error, read.hint);
    return 1;
  }

  const CalibrationFile& file_;
  const std::filesystem::path& folder_;
  Registry& registry_;
  formats::Diagnostics& diagnostics_;
  const std::function<void(double)>& on_budget_;
  CheckedCalibration checked_;
};

}  // namespace

CheckedCalibration check_calibration(const CalibrationFile& file, const std::filesystem::path& folder,
                                     Registry& registry, formats::Diagnostics& diagnostics,
                                     const std::function<void(double)>& on_budget) {
  return CalibrationInspection(file, folder, registry, diagnostics, on_budget).inspect();
}

}  // namespace netloft::studies
