// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/result_diff.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::results {

namespace {

constexpr double kRoundOff =
    1e-12;  // relative to the larger number: a smaller difference counts as no change

NumberDifference difference_of(const std::string& name, const ResultSummary& before,
                               const ResultSummary& after) {
  const auto find = [&](const ResultSummary& summary) {
    const auto at = summary.numbers.find(name);
    return at == summary.numbers.end() ? ResultNumber{} : at->second;
  };
  const ResultNumber a = find(before), b = find(after);
  return {name, a.unit.empty() ? b.unit : a.unit, a.value, b.value,
          a.solver_error + a.mesh_error + b.solver_error + b.mesh_error};
}

/// Sets the floor of every number: the rounding of the largest number of its unit. A force that is the small
/// difference of large ones carries their rounding.
void set_floors(std::vector<NumberDifference>& numbers) {
  std::map<std::string, double> largest;
  for (const auto& d : numbers)
    for (const double value : {d.before, d.after})
      if (std::isfinite(value)) largest[d.unit] = std::max(largest[d.unit], std::abs(value));
  for (auto& d : numbers) d.floor = kRoundOff * largest[d.unit];
}

std::vector<NumberDifference> compare_numbers(const ResultSummary& before, const ResultSummary& after) {
  std::set<std::string> names;
  for (const auto* summary : {&before, &after})
    for (const auto& [name, number] : summary->numbers) names.insert(name);
  const bool has_gear = before.has_gear || after.has_gear;
  std::vector<NumberDifference> all;
  for (const auto& name : names)
    if (!(has_gear && name.starts_with("forces/"))) all.push_back(difference_of(name, before, after));
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

/// Pairs the scene with the scene and every other file with the one of the same name; -1 marks a file without
/// a partner.
std::vector<int> partners(const std::vector<InputText>& before, const std::vector<InputText>& after) {
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

std::vector<FileDifference> compare_files(const std::vector<InputText>& before,
                                          const std::vector<InputText>& after) {
  std::vector<FileDifference> files;
  std::vector<bool> met(after.size());
  const auto partner = partners(before, after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (partner[i] < 0) {
      files.push_back({before[i].path, "", {}});
      continue;
    }
    const InputText& other = after[static_cast<std::size_t>(partner[i])];
    met[static_cast<std::size_t>(partner[i])] = true;
    auto lines = find_line_changes(before[i].text, other.text);
    if (!lines.empty()) files.push_back({before[i].path, other.path, std::move(lines)});
  }
  for (std::size_t j = 0; j < after.size(); ++j)
    if (!met[j]) files.push_back({"", after[j].path, {}});
  return files;
}

std::vector<std::string> compare_plugins(const ResultSummary& before, const ResultSummary& after) {
  std::vector<std::string> different;
  for (const auto& [name, hash] : before.plugins)
    if (!after.plugins.contains(name))
      different.push_back(name + ", before only");
    else if (after.plugins.at(name) != hash)
      different.push_back(name + ", built differently");
  for (const auto& [name, hash] : after.plugins)
    if (!before.plugins.contains(name)) different.push_back(name + ", after only");
  return different;
}

InputDifferences compare_inputs(const ResultSummary& before, const ResultSummary& after) {
  const auto a = options_of(before.command), b = options_of(after.command);
  return {only_in(a, b), only_in(b, a), compare_files(before.files, after.files),
          compare_plugins(before, after), before.version != after.version};
}

}  // namespace

double NumberDifference::percent() const {
  return before != 0 ? 100 * difference() / std::abs(before) : ResultNumber::kUnknown;
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

ResultDiff compare_results(ResultSummary before, ResultSummary after) {
  auto numbers = compare_numbers(before, after);
  auto inputs = compare_inputs(before, after);
  return {std::move(before), std::move(after), std::move(numbers), std::move(inputs), {}};
}

}  // namespace netloft::results
