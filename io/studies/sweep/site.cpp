// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/site.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/formats/units/units.hpp"
#include "io/studies/variables/read_variable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

// With fewer values, the curvature of a figure between values cannot be estimated.
constexpr std::size_t kLeastLevelsOfSite = 3;

/// Splits "a=1,b=[2, 3]" at the commas outside brackets and quotes.
std::vector<std::string> split_at_commas(const std::string& words) {
  std::vector<std::string> all(1);
  int depth = 0;
  char quote = 0;
  for (const char c : words) {
    if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? '\0' : c;
    if (!quote) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && !quote && depth == 0)
      all.emplace_back();
    else
      all.back() += c;
  }
  return all;
}

/// Reads a place. The member functions are the steps, in the order of execution.
class SiteReader {
 public:
  SiteReader(const StudyTable& table, formats::Diagnostics& diagnostics)
      : table_(table), diagnostics_(diagnostics) {}

  Site read(const std::vector<std::string>& words, SiteNeeds needs) {
    for (const std::string& some : words)
      for (const std::string& word : split_at_commas(some))
        formats::apply(root_, formats::read_change(word, "--at"), diagnostics_);
    refuse_unknown();
    if (needs == SiteNeeds::all) refuse_missing();
    Site site;
    for (std::size_t v = 0; v < table_.columns.size(); ++v) site.push_back(read_value(v));
    return site;
  }

 private:
  const std::string& name(std::size_t v) const { return table_.columns[v].variable.name; }
  const formats::Member* given(std::size_t v) const { return root_.as<formats::Table>()->find(name(v)); }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (std::size_t v = 0; v < table_.columns.size(); ++v) all.push_back(name(v));
    return all;
  }

  void refuse_unknown() {
    const auto all = names();
    for (const formats::Member& member : root_.as<formats::Table>()->members) {
      if (std::find(all.begin(), all.end(), member.key) != all.end()) continue;
      const auto near = nearest(member.key, all);
      diagnostics_.error(
          member.place, "the study has no variable \"" + member.key + "\"",
          near ? "did you mean \"" + *near + "\"?" : fmt::format("it has {}", fmt::join(all, ", ")));
    }
  }

  void refuse_missing() {
    const bool some_sampled = any_sampled_given();
    for (std::size_t v = 0; v < table_.columns.size(); ++v) {
      if (given(v) || (table_.columns[v].is_sampled && !some_sampled)) continue;
      const std::string why =
          table_.columns[v].is_sampled
              ? "; give all sampled variables, or none of them, which estimates over all samples"
              : "";
      diagnostics_.error({}, name(v) + " is missing" + why, "such as --at " + example(v));
    }
  }

  bool any_sampled_given() const {
    for (std::size_t v = 0; v < table_.columns.size(); ++v)
      if (table_.columns[v].is_sampled && given(v)) return true;
    return false;
  }

  std::string example(std::size_t v) const {
    const std::string text = table_.rows.empty() ? "…" : table_.rows.front().values[v].text;
    return name(v) + "=" + (text.find(' ') == std::string::npos ? text : "\"" + text + "\"");
  }

  std::optional<VariableValue> read_value(std::size_t v) {
    const formats::Member* member = given(v);
    if (!member) return std::nullopt;
    return table_.columns[v].is_number ? read_number(v) : read_choice(v, *member);
  }

  std::optional<VariableValue> read_choice(std::size_t v, const formats::Member& member) {
    const std::string text = formats::spell_value(member.value);
    std::vector<std::string> known;
    for (const StudyRow& row : table_.rows) {
      if (row.values[v].text == text) return row.values[v];
      if (std::find(known.begin(), known.end(), row.values[v].text) == known.end())
        known.push_back(row.values[v].text);
    }
    diagnostics_.error(member.value.place, fmt::format("{} is never {} in the study", name(v), text),
                       fmt::format("its values are {}", fmt::join(known, ", ")));
    return std::nullopt;
  }

  std::optional<VariableValue> read_number(std::size_t v) {
    const Variable& variable = table_.columns[v].variable;
    const std::vector<double> levels = levels_of(table_, v);
    if (levels.empty()) return std::nullopt;
    formats::TableReader reader(root_, diagnostics_);
    const std::string ends =
        fmt::format("[{}, {}]{}", formats::format(levels.front()), formats::format(levels.back()),
                    variable.unit.empty() ? "" : " " + variable.unit);
    const auto number = read_number_of(variable, reader, name(v), "the study has " + ends);
    if (!number) return std::nullopt;
    const std::string text = name(v) + " = " + formats::format(*number, variable.unit);
    const auto level =
        std::find_if(levels.begin(), levels.end(), [&](double x) { return is_same_number(x, *number); });
    if (level != levels.end()) return variable.value_of(*level);
    if (!(*number > levels.front() && *number < levels.back()))
      diagnostics_.error(reader.place(name(v)), text + " is outside " + ends + ", the values of the study",
                         "use netloft run for values beyond them");
    else if (!table_.columns[v].is_sampled && levels.size() < kLeastLevelsOfSite)
      diagnostics_.error(
          reader.place(name(v)), text + " lies between the only two values of the study",
          "give the study three or more values, because two do not tell what lies between them");
    return variable.value_of(*number);
  }

  const StudyTable& table_;
  formats::Diagnostics& diagnostics_;
  formats::Value root_{{}, formats::Table{}};
};

}  // namespace

bool is_same_number(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

std::vector<double> levels_of(const StudyTable& table, std::size_t column) {
  std::vector<double> levels;
  for (const StudyRow& row : table.rows)
    if (row.values[column].number) levels.push_back(*row.values[column].number);
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end(), is_same_number), levels.end());
  return levels;
}

Site read_site(const StudyTable& table, const std::vector<std::string>& words,
               formats::Diagnostics& diagnostics, SiteNeeds needs) {
  return SiteReader(table, diagnostics).read(words, needs);
}

}  // namespace netloft::studies
