// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/result_diff.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

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

/// All numbers of a result: "results/lowest_z", "gear/mouth/area", "held/warp/x". If `with_forces`, the
/// forces on each part are included; callers leave them out if the figures of the gear state them.
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
  return {name, a.unit.empty() ? b.unit : a.unit, a.value, b.value, a.error + b.error};
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

/// The options of a command line that change its scene: "--set path=value", "--solver name".
std::set<std::string> options_of(const std::vector<std::string>& command) {
  std::set<std::string> options;
  for (std::size_t i = 0; i < command.size(); ++i)
    for (const std::string option : {"--set", "--solver"}) {
      if (command[i] == option && i + 1 < command.size()) options.insert(option + " " + command[i + 1]);
      if (command[i].starts_with(option + "="))
        options.insert(option + " " + command[i].substr(option.size() + 1));
    }
  return options;
}

std::set<std::string> only_in(const std::set<std::string>& one, const std::set<std::string>& other) {
  std::set<std::string> only;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::inserter(only, only.end()));
  return only;
}

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// Pairs the files of two results: the scene of one with that of the other, and every other file with a file
/// of the same name. -1 marks a file without a partner.
std::vector<int> partners(const std::vector<Origins::File>& before, const std::vector<Origins::File>& after) {
  std::vector<int> partner(before.size(), -1);
  std::vector<bool> taken(after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t j = 0; j < after.size() && partner[i] < 0; ++j)
      if (!taken[j] && (i == 0 ? j == 0 : j > 0 && name_of(before[i].path) == name_of(after[j].path))) {
        partner[i] = static_cast<int>(j);
        taken[j] = true;
      }
  return partner;
}

std::vector<FileDifference> compare_files(const std::vector<Origins::File>& before,
                                          const std::vector<Origins::File>& after) {
  std::vector<FileDifference> files;
  std::vector<bool> met(after.size());
  const auto partner = partners(before, after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (partner[i] < 0) {
      files.push_back({before[i].path, "", {}});
      continue;
    }
    const Origins::File& other = after[static_cast<std::size_t>(partner[i])];
    met[static_cast<std::size_t>(partner[i])] = true;
    auto lines = find_line_changes(before[i].text, other.text);
    if (!lines.empty()) files.push_back({before[i].path, other.path, std::move(lines)});
  }
  for (std::size_t j = 0; j < after.size(); ++j)
    if (!met[j]) files.push_back({"", after[j].path, {}});
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

InputDifferences compare_inputs(const Origins& before, const Origins& after) {
  const auto a = options_of(before.command), b = options_of(after.command);
  return {only_in(a, b), only_in(b, a), compare_files(before.files, after.files),
          compare_plugins(before.plugins, after.plugins), before.version != after.version};
}

}  // namespace

double NumberDifference::percent() const {
  return before != 0 ? 100 * difference() / std::abs(before) : NumberDifference::kUnknown;
}

bool NumberDifference::is_changed() const {
  if (std::isnan(before) && std::isnan(after)) return false;
  return !(std::abs(difference()) <=
           std::max(floor, kRoundOff * std::max(std::abs(before), std::abs(after))));
}

bool NumberDifference::exceeds() const { return is_changed() && std::abs(difference()) > error; }

bool InputDifferences::none() const {
  return options_before.empty() && options_after.empty() && files.empty() && plugins.empty() &&
         !other_program;
}

ResultDiff compare_results(Result before, Result after) {
  auto numbers = compare_numbers(before, after);
  auto inputs = compare_inputs(before.origins, after.origins);
  return {std::move(before), std::move(after), std::move(numbers), std::move(inputs), {}};
}

}  // namespace netloft::results
