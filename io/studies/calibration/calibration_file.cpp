// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/calibration_file.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/units/units.hpp"
#include "io/studies/variables/read_variable.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace netloft::studies {

namespace {

/// Reads one calibration file. The member functions are the steps, in the order of execution.
class CalibrationReader {
 public:
  CalibrationReader(const formats::Value& root, formats::Diagnostics& diagnostics)
      : root_(root, diagnostics) {}

  CalibrationFile read() {
    file_.confidence =
        root_.real("confidence", {.doc = "probability with which intervals and bands contain the true value",
                                  .range = {.lo = 0, .hi = 1, .lo_open = true, .hi_open = true},
                                  .fallback = 0.9});
    set_ = root_.texts(
        "set", {.doc = "values of all scenes, as --set takes them", .fallback = std::vector<std::string>{}});
    read_scenes();
    read_variables();
    read_measured();
    root_.finish();
    return std::move(file_);
  }

 private:
  void read_scenes() {
    formats::TableReader scenes =
        root_.table("scenes", formats::Presence::required, "scenes that were measured, a table each");
    for (const std::string& name : scenes.keys()) {
      formats::TableReader table =
          scenes.table(name, formats::Presence::required, "scene, and values that are set in it");
      CalibrationScene scene{name, table.text("scene", {.doc = "the scene, relative to this file"}),
                             table.place(), set_};
      for (auto& word : table.texts("set", {.doc = "values of this scene, as --set takes them",
                                           .fallback = std::vector<std::string>{}}))
        scene.set.push_back(std::move(word));
      file_.scenes.push_back(std::move(scene));
    }
    if (root_.has("scenes") && file_.scenes.empty())
      root_.error("scenes", "is empty: a calibration needs at least one scene that was measured",
                  "such as [scenes.slow]");
  }

  /// The scenes that a key names; all scenes if the key is missing.
  std::vector<std::size_t> scenes_in(formats::TableReader& table, const std::string& key) {
    std::vector<std::size_t> all(file_.scenes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (!table.has(key)) return all;
    all.clear();
    for (const std::string& name :
         table.texts(key, {.doc = "the scenes that have this variable", .count = {1}}))
      if (const auto scene = find_scene(table, key, name)) all.push_back(*scene);
    return all;
  }

  std::optional<std::size_t> find_scene(formats::TableReader& table, const std::string& key,
                                        const std::string& name) {
    std::vector<std::string> known;
    for (std::size_t s = 0; s < file_.scenes.size(); ++s) {
      if (file_.scenes[s].name == name) return s;
      known.push_back(file_.scenes[s].name);
    }
    const auto near = nearest(name, known);
    table.error(key, "there is no scene \"" + name + "\" in this file",
                near ? "did you mean \"" + *near + "\"?" : "");
    return std::nullopt;
  }

  void read_variables() {
    formats::TableReader variables =
        root_.table("variables", formats::Presence::required, "unknown values, a table each");
    for (const std::string& name : variables.keys()) {
      formats::TableReader table = variables.table(name, formats::Presence::required, "key and range");
      CalibrationVariable read{read_variable(name, table, VariedBy::interval), {}, {}};
      if (read.variable.interval)
        read.distribution = read_distribution(read.variable, table, {"uniform", "normal"});
      read.is_shared = !table.has("scenes");
      read.scenes = scenes_in(table, "scenes");
      refuse_shared_keys(read);
      file_.variables.push_back(std::move(read));
    }
    if (root_.has("variables") && file_.variables.empty())
      root_.error("variables", "is empty: a calibration needs at least one unknown value",
                  "such as [variables.diameter]");
  }

  void refuse_shared_keys(const CalibrationVariable& read) {
    for (const std::size_t scene : read.scenes)
      for (const FollowingKey& key : read.variable.keys) {
        const auto [owner, is_new] = owners_.emplace(std::pair(scene, key.path), read.variable.name);
        if (!is_new)
          return root_.diagnostics().error(read.variable.place,
                                           key.path + " is varied by " + owner->second + " already");
      }
  }

  void read_measured() {
    const auto rows =
        root_.tables("measured", formats::Presence::required, "what was measured, a [[measured]] each");
    for (formats::TableReader row : rows) {
      MeasuredFigure read;
      if (const auto scene =
              find_scene(row, "scene", row.text("scene", {.doc = "scene in which the figure was measured"})))
        read.scene = *scene;
      read.figure =
          row.text("figure", {.doc = "figure that was measured, such as gear/mouth/headline_height"});
      read.place = row.place("figure");
      read.value_place = row.place("value");
      read.value = quantity(row, "value", "measured value");
      read.deviation = quantity(row, "deviation", "standard deviation of the measured value");
      read.is_held_back = row.boolean(
          "held_back", {.doc = "true: the value is held back, and is only predicted", .fallback = false});
      file_.measured.push_back(std::move(read));
    }
    if (!rows.empty() && std::all_of(file_.measured.begin(), file_.measured.end(),
                                     [](const auto& m) { return m.is_held_back; }))
      root_.error("measured", "every value is held back, so that there is nothing to fit");
  }

  /// The text of a number with or without a unit, as written in the file.
  std::string quantity(formats::TableReader& row, const std::string& key, const std::string& doc) {
    const auto kind = row.kind(key);
    if (!kind || *kind == formats::Kind::text) return row.text(key, {.doc = doc});
    return formats::format(row.real(key, {.doc = doc}), "");
  }

  formats::TableReader root_;
  CalibrationFile file_;
  std::vector<std::string> set_;  // overrides for all scenes
  std::map<std::pair<std::size_t, std::string>, std::string> owners_;
};

}  // namespace

double CalibrationVariable::prior_mean() const {
  const auto& [low, high] = *variable.interval;
  return distribution.kind == Distribution::Kind::normal ? distribution.mean : (low + high) / 2;
}

double CalibrationVariable::prior_deviation() const {
  const auto& [low, high] = *variable.interval;
  return distribution.kind == Distribution::Kind::normal ? distribution.deviation
                                                         : (high - low) / std::sqrt(12.0);
}

CalibrationFile read_calibration_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::load(path, {}, diagnostics);
  if (diagnostics.errors()) return {};
  CalibrationFile file = CalibrationReader(document.root(), diagnostics).read();
  file.name = path.stem().string();
  return file;
}

}  // namespace netloft::studies
