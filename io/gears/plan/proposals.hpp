// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/value.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::gears {

// Proposals are values of keys that may remove a message of the check. The functions here need not know what
// else depends on a key: tried_cures.hpp tries each proposal before anybody reads it.
using Cures = std::vector<formats::Cure>;

/// A dotted path: path_of({"panels", "bag", "aft"}) is panels.bag.aft.
std::string path_of(std::initializer_list<std::string_view> keys);
/// A proposal of one value.
formats::Cure set(const std::string& path, const formats::Value& value, std::string note = {});
/// Numbers as people write them: 20 without a decimal point, and lengths as "25.57 m".
formats::Value as_number(double number);
formats::Value as_metres(double metres);
formats::Value as_text(std::string text);
/// A length rounded to millimetres, downwards or upwards.
double millimetres_below(double metres);
double millimetres_above(double metres);

/// Values with which the cuttings of a panel give the meshes of its aft edge: other counts, another depth,
/// other rates, a straight run before a cut.
Cures cures_of_closing(const Panel& panel, const CheckLimits& limits);
/// The other direction for each cut of a panel whose sides would meet, or no taper.
Cures cures_of_direction(const Panel& panel);
/// Values with which the cuts of a side, of which `key` is the name, go as deep as the panel.
Cures cures_of_depth(const Panel& panel, const std::vector<Cut>& side, const std::string& key);
/// Other rates for one cut: these, and then the usual ones.
Cures cures_of_rate(const Panel& panel, bool is_outer, std::size_t which, std::vector<std::string> rates);
/// Values with which an edge, or several in a row of one panel, has `more` meshes than now.
Cures cures_of_edge(const EdgeSet& edge, double more);

}  // namespace netloft::gears
