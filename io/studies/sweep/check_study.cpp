// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/check_study.hpp"

#include "io/formats/text/likely_path.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "io/studies/variables/scene_faults.hpp"

#include <algorithm>
#include <set>

namespace netloft::studies {

namespace {

/// The values at which a variable is checked: all listed values, or both ends of the interval.
std::vector<VariableValue> tried(const Variable& variable) {
  if (!variable.interval) return variable.values;
  return {variable.value_of(variable.interval->low), variable.value_of(variable.interval->high)};
}

/// The path of a change "path=value".
std::string path_of(const std::string& word) { return word.substr(0, word.find('=')); }

/// Opens the scene with one set of values after another, and collects errors.
class StudyInspection {
 public:
  StudyInspection(const StudyFile& file, const std::filesystem::path& folder, Registry& registry,
                  formats::Diagnostics& diagnostics)
      : file_(file),
        scene_(folder / file.scene, file.set, 1),
        registry_(registry),
        diagnostics_(diagnostics) {
    for (std::size_t v = 0; v < file.variables.size(); ++v) {
      if (!file.variables[v].is_sound) continue;
      counts_.insert(v);
      for (const FollowingKey& key : file.variables[v].variable.keys)
        places_.emplace(key.path, file.variables[v].variable.place);
    }
    for (const std::string& word : file.set) places_.emplace(path_of(word), file.set_place);
  }

  CheckedScenes inspect() {
    while (!open({}))
      if (!leave_out_blamed()) return std::move(found_);
    for (const std::size_t v : counts_) {
      const auto values = tried(file_.variables[v].variable);
      for (std::size_t i = 1; i < values.size(); ++i)
        if (!open({{v, values[i]}})) break;  // other values mostly cause the same errors
    }
    check_figures();
    return std::move(found_);
  }

 private:
  bool open(const std::map<std::size_t, VariableValue>& others) {
    runs::CaseSource source = scene_;
    for (const std::size_t v : counts_) {
      const Variable& variable = file_.variables[v].variable;
      const auto other = others.find(v);
      formats::append(source.changes,
                      variable.changes(other == others.end() ? tried(variable).front() : other->second));
    }
    runs::PreparedScene scene(source, registry_);
    const runs::PreparedScene::State state = scene.prepare();
    hand_on_faults(scene.diagnostics(), places_, file_.scene_place, diagnostics_);
    blamed_.clear();
    for (const formats::Diagnostic& fault : scene.diagnostics().sorted())
      if (fault.severity == formats::Severity::error) blamed_.insert(scene.diagnostics().where(fault.place));
    found_.refused |= state == runs::PreparedScene::State::refused;
    if (state == runs::PreparedScene::State::ready) learn(scene);
    return state == runs::PreparedScene::State::ready;
  }

  /// Leaves out, from now on, the variables that caused errors in the scene that was read last. Returns false
  /// if there are no such variables.
  bool leave_out_blamed() {
    const auto is_blamed = [&](std::size_t v) {
      const auto& keys = file_.variables[v].variable.keys;
      return std::any_of(keys.begin(), keys.end(),
                         [&](const FollowingKey& key) { return blamed_.contains("--set " + key.path); });
    };
    return std::erase_if(counts_, is_blamed) > 0;
  }

  void learn(runs::PreparedScene& scene) {
    for (const formats::SourceFile& file : scene.loaded().files) {
      const std::pair<std::string, std::string> one(file.path, file.hash);
      if (std::find(found_.files.begin(), found_.files.end(), one) == found_.files.end())
        found_.files.push_back(one);
    }
    if (scene.loaded().analysis.kind == AnalysisKind::dynamics)
      diagnostics_.error(file_.scene_place, "the scene is a motion, but a study compares equilibria",
                         "set = [\"analysis.kind=static\"]");
    if (file_.figures.empty()) return;
    Solution at_start;
    at_start.x = scene.assembler().start();
    at_start.residual.resize(at_start.x.size());
    for (const StudyFigure& figure : figures_of(scene, at_start)) known_.insert(figure.name);
  }

  void check_figures() {
    found_.figures.assign(known_.begin(), known_.end());
    for (std::size_t f = 0; f < file_.figures.size(); ++f) {
      if (known_.contains(file_.figures[f])) continue;
      const auto near = formats::likely_path(file_.figures[f], found_.figures);
      diagnostics_.error(file_.figure_places[f],
                         "the scene does not report a figure \"" + file_.figures[f] + "\"",
                         near ? "did you mean \"" + *near + "\"?"
                              : "such as results/NAME, gear/mouth/headline_height, held/NAME/x");
    }
  }

  const StudyFile& file_;
  runs::CaseSource scene_;
  Registry& registry_;
  formats::Diagnostics& diagnostics_;
  std::map<std::string, formats::Place> places_;  // places of keys in the study file
  std::set<std::string> known_;                   // names of figures that the scenes report
  std::set<std::size_t> counts_;                  // variables whose values are set in the scenes
  std::set<std::string> blamed_;                  // keys with errors in the last scene
  CheckedScenes found_;
};

}  // namespace

CheckedScenes check_scenes(const StudyFile& file, const std::filesystem::path& folder, Registry& registry,
                           formats::Diagnostics& diagnostics) {
  return StudyInspection(file, folder, registry, diagnostics).inspect();
}

}  // namespace netloft::studies
