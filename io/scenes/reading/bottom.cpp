// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/bottom.hpp"

#include "io/formats/units/units.hpp"
#include "io/scenes/reading/keys.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>
#include <string_view>

namespace netloft::scenes {

namespace {

constexpr const char* kBottom = "bottom";
constexpr double kMostFactor = 1e6;  // limit of factors, so large for the stiffness of rock over that of mud

const netloft_parameter& bottom_key() {
  return *std::ranges::find_if(bed_keys(),
                               [](const auto& key) { return key.name == std::string_view(kBottom); });
}

/// The index of a column of `[bed] bottom`; nullopt if there is no column with this name.
std::optional<std::size_t> column_named(const char* name) {
  for (std::size_t k = 0; bottom_key().columns[k]; ++k)
    if (!std::strcmp(bottom_key().columns[k], name)) return k;
  return {};
}

/// Reports factors below zero or above kMostFactor as errors; also a stiffness factor of zero, because such a
/// bed bears nothing.
void check_factors(const Samples& rows, formats::TableReader& bottom) {
  for (std::size_t k = 2; bottom_key().columns[k]; ++k) {
    const std::string_view name = bottom_key().columns[k];
    const bool may_be_zero = name != "stiffness";
    for (const auto& row : rows)
      if (!(row[k] >= 0 && row[k] <= kMostFactor) || (row[k] == 0 && !may_be_zero)) {
        bottom.error(
            name,
            "= " + formats::format(row[k], "1") + " is outside " + (may_be_zero ? "[" : "(") + "0, 1e6]",
            "give factors: they multiply the stiffness, friction and ploughing resistance that parts on the "
            "bed have");
        break;
      }
  }
}

bool is_bottom(const netloft_parameter& p) {
  const std::string_view name = p.name;
  return p.kind == NETLOFT_TABLE && p.arguments == 2 && (name == kBottom || name.ends_with(".bottom"));
}

}  // namespace

SeaBottom::SeaBottom(const Values& values, formats::TableReader bed) {
  const auto given = values.find(kBottom);
  if (given == values.end()) return;
  rows_ = std::get<Samples>(given->second);
  formats::TableReader bottom = bed.table(kBottom);
  if (std::ranges::all_of(rows_, [](const auto& row) { return row.size() == 5; }))
    check_factors(rows_, bottom);
}

bool SeaBottom::is_symmetric() const {
  const std::set<std::vector<double>> rows(rows_.begin(), rows_.end());
  return std::ranges::all_of(rows_, [&](std::vector<double> row) {
    row[1] = -row[1];
    return rows.contains(row);
  });
}

bool SeaBottom::lay_under(const ElementType& type, Part& part) const {
  bool takes = false;
  for (const auto& p : type.parameters) {
    if (!is_bottom(p)) continue;
    takes = true;
    Samples own(rows_.size());
    for (std::size_t k = 0; p.columns[k]; ++k)
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto column = column_named(p.columns[k]);
        own[i].push_back(column ? rows_[i][*column] : 1);
      }
    part.parameters.try_emplace(p.name, std::move(own));
  }
  return takes;
}

}  // namespace netloft::scenes
