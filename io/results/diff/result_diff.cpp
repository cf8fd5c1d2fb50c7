// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/result_diff.hpp"

#include "io/results/figures/figure_names.hpp"
#include "io/results/figures/key_figures.hpp"
#include "io/results/figures/merged_scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <tuple>

namespace netloft::results {

namespace {

// Two numbers are equal if they differ by less than this fraction of the larger one.
constexpr double kRoundOff = 1e-12;

struct ComparedNumber {
  std::string unit;
  // `error`: sum of the solver error and the mesh error.
  double value = NumberDifference::kUnknown, error = NumberDifference::kUnknown;
};
using NumberMap = std::map<std::string, ComparedNumber>;

void add_vector(const std::string& name, const std::array<double, 3>& force, NumberMap& numbers) {
  for (std::size_t axis = 0; axis < 3; ++axis) numbers[name + "/" + "xyz"[axis]] = {"N", force[axis]};
}

/// All numbers of a result: "results/lowest_z", "gear/mouth/area", "held/warp/x". The forces on each part are
/// included if `with_forces`; they are not needed if the figures of the gear contain them.
NumberMap numbers_of(const Result& result, bool with_forces) {
  NumberMap numbers;
  for (const auto& s : result.scalars)
    numbers["results/" + s.name] = {s.unit, s.value, s.solver_error + s.mesh_error};
  for (const auto& f : result.figures)
    numbers["gear/" + f.name] = {f.unit, f.value, f.solver_error + f.mesh_error};
  if (std::isfinite(result.energy)) numbers["energy"] = {"J", result.energy};
  for (const auto& hold : result.hold_forces) add_vector("held/" + hold.name, hold.force, numbers);
  for (const auto& load : result.part_forces)
    if (with_forces) add_vector("forces/" + load.term + "/" + load.part, load.force, numbers);
  return numbers;
}

NumberDifference difference_of(const std::string& name, const NumberMap& before, const NumberMap& after) {
  const auto find = [&](const NumberMap& numbers) {
    const auto at = numbers.find(name);
    return at == numbers.end() ? ComparedNumber{} : at->second;
  };
  const ComparedNumber a = find(before), b = find(after);
  return {name, a.unit.empty() ? b.unit : a.unit, a.value, b.value, a.error, b.error};
}

/// Sets the round-off (`floor`) of every number to 1e-12 of the largest number with the same unit, because a
/// force may be a small difference of large forces.
void set_floors(std::vector<NumberDifference>& numbers) {
  std::map<std::string, double> largest;
  for (const auto& d : numbers)
    for (const double value : {d.before, d.after})
      if (std::isfinite(value)) largest[d.unit] = std::max(largest[d.unit], std::abs(value));
  for (auto& d : numbers) d.floor = kRoundOff * largest[d.unit];
}

std::vector<NumberDifference> compare_numbers(const Result& before, const Result& after) {
  const bool with_forces = before.figures.empty() && after.figures.empty();
  const NumberMap a = numbers_of(before, with_forces), b = numbers_of(after, with_forces);
  std::set<std::string> names;
  for (const auto* numbers : {&a, &b})
    for (const auto& [name, number] : *numbers) names.insert(name);
  std::vector<NumberDifference> all;
  for (const auto& name : names) all.push_back(difference_of(name, a, b));
  set_floors(all);
  return all;
}

/// The options of a command line that choose a method or a start: for example, "--solver newton".
std::set<std::string> options_of(const Origins& origins) {
  std::set<std::string> options;
  for (const std::string option : {"--solver", "--strategy", "--start-from"})
    for (const auto& value : values_of_option(origins, option)) options.insert(option + " " + value);
  return options;
}

std::set<std::string> only_in(const std::set<std::string>& one, const std::set<std::string>& other) {
  std::set<std::string> only;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::inserter(only, only.end()));
  return only;
}

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// Pairs the files of two results by name, and returns the pairs that differ. Files of the scenes themselves
/// are left out, because the scenes are compared key by key.
std::vector<FileDifference> compare_files(const std::vector<Origins::File>& before,
                                          const std::vector<Origins::File>& after,
                                          const std::set<std::string>& of_scenes) {
  std::vector<FileDifference> files;
  std::set<const Origins::File*> met;
  for (const auto& file : before) {
    if (of_scenes.contains(file.path)) continue;
    const auto other = std::ranges::find_if(after, [&](const Origins::File& f) {
      return !met.contains(&f) && !of_scenes.contains(f.path) && name_of(f.path) == name_of(file.path);
    });
    if (other == after.end()) {
      files.push_back({file.path, "", {}});
      continue;
    }
    met.insert(&*other);
    if (file.text != other->text)
      files.push_back({file.path, other->path,
                       find_key_changes(file.text, other->text).value_or(std::vector<KeyChange>{})});
  }
  for (const auto& file : after)
    if (!met.contains(&file) && !of_scenes.contains(file.path)) files.push_back({"", file.path, {}});
  return files;
}

std::vector<std::string> compare_plugins(const std::vector<Origins::Plugin>& before,
                                         const std::vector<Origins::Plugin>& after) {
  const auto find = [](const std::vector<Origins::Plugin>& all, const std::string& name) {
    return std::ranges::find(all, name, &Origins::Plugin::name);
  };
  std::vector<std::string> different;
  for (const auto& plugin : before) {
    const auto other = find(after, plugin.name);
    if (other == after.end())
      different.push_back(plugin.name + ", before only");
    else if (other->hash != plugin.hash)
      different.push_back(plugin.name + ", built differently");
  }
  for (const auto& plugin : after)
    if (find(before, plugin.name) == before.end()) different.push_back(plugin.name + ", after only");
  return different;
}

bool have_same_texts(const std::vector<Origins::File>& a, const std::vector<Origins::File>& b) {
  return std::ranges::equal(a, b, {}, &Origins::File::text, &Origins::File::text);
}

InputDifferences compare_inputs(const Origins& before, const Origins& after) {
  InputDifferences inputs;
  std::set<std::string> of_scenes;
  auto keys = find_key_changes(before, after, of_scenes);
  inputs.are_scenes_known = keys.has_value();
  if (keys) inputs.keys = std::move(*keys);
  const auto a = options_of(before), b = options_of(after);
  inputs.options_before = only_in(a, b);
  inputs.options_after = only_in(b, a);
  inputs.files = compare_files(before.files, after.files, of_scenes);
  inputs.plugins = compare_plugins(before.plugins, after.plugins);
  inputs.other_program = before.version != after.version;
  inputs.other_text = !have_same_texts(before.files, after.files);
  return inputs;
}

/// Whether a number describes the gear as a whole or is requested in the scene, rather than describing a
/// single part.
bool is_figure(const std::string& name) {
  return name.starts_with("results/") ||
         (name.starts_with("gear/") && !principal_name(name.substr(5)).empty());
}

/// The weight by which differences are sorted: the difference relative to the larger value. A difference
/// below the errors is taken relative to the errors instead, so that noise comes last. Values below a
/// hundredth of the largest value with this unit count as that hundredth, because the small force of a slack
/// rope may change by any factor.
double weight_of(const NumberDifference& d, double largest) {
  constexpr double kSmall = 0.01;
  if (std::isfinite(d.error()) && !d.exceeds()) return std::abs(d.difference()) / d.error();
  const double larger = std::fmax(std::abs(d.before), std::abs(d.after));
  return d.share() * std::min(1.0, larger / (kSmall * largest));
}

std::vector<std::size_t> changed_figures(const std::vector<NumberDifference>& numbers,
                                         const std::set<std::string>& keys) {
  std::vector<std::size_t> figures;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_figure(numbers[i].name) && numbers[i].is_changed()) figures.push_back(i);
  std::map<std::string, double> largest;  // by unit
  for (const std::size_t i : figures)
    for (const double value : {numbers[i].before, numbers[i].after})
      if (std::isfinite(value))
        largest[numbers[i].unit] = std::max(largest[numbers[i].unit], std::abs(value));
  const auto rank = [&](std::size_t i) {
    const auto& d = numbers[i];
    return std::tuple(d.is_exact(), !d.exceeds(), !keys.contains(d.name), -weight_of(d, largest[d.unit]));
  };
  std::ranges::stable_sort(figures, {}, rank);
  return figures;
}

/// The names of the key figures of both results, spelled as in NumberDifference.
std::set<std::string> names_of_key_figures(const Result& before, const Result& after) {
  std::set<std::string> names;
  for (const Result* result : {&before, &after}) {
    for (const auto* figure : key_figures(*result))
      names.insert((find_scalar(result->figures, figure->name) == figure ? "gear/" : "results/") +
                   figure->name);
  }
  return names;
}

}  // namespace

double NumberDifference::percent() const {
  return before != 0 ? 100 * difference() / std::abs(before) : NumberDifference::kUnknown;
}

double NumberDifference::share() const {
  const double larger = std::fmax(std::abs(before), std::abs(after));
  return larger > 0 && std::isfinite(difference()) ? std::abs(difference()) / larger : 1;
}

bool NumberDifference::is_exact() const {
  constexpr double kExact = 1e-9;  // a relative error below this is rounding
  return error() <= kExact * std::fmax(std::abs(before), std::abs(after));
}

bool NumberDifference::is_changed() const {
  if (std::isnan(before) && std::isnan(after)) return false;
  return !(std::abs(difference()) <=
           std::max(floor, kRoundOff * std::max(std::abs(before), std::abs(after))));
}

bool NumberDifference::exceeds() const { return is_changed() && std::abs(difference()) > error(); }

bool InputDifferences::none() const {
  return keys.empty() && options_before.empty() && options_after.empty() && files.empty() &&
         plugins.empty() && !other_program;
}

ResultDiff compare_results(Result before, Result after) {
  ResultDiff diff;
  diff.numbers = compare_numbers(before, after);
  diff.figures = changed_figures(diff.numbers, names_of_key_figures(before, after));
  diff.inputs = compare_inputs(before.origins, after.origins);
  diff.before = std::move(before);
  diff.after = std::move(after);
  return diff;
}

}  // namespace netloft::results
