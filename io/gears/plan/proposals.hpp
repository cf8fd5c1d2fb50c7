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

// A proposal is a value of a key that may remove a message of the check. These functions need not know what
// else depends on the key, because tried_cures.hpp tries each proposal before it is shown.
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

/// The rates that go `across` meshes in `deep`: first the simplest that miss by at most half a mesh, or the
/// nearest one if all miss by more.
std::vector<std::string> rates_near(double across, double deep);

/// Changes that make the cuttings of a panel agree with the meshes of its aft edge: other counts, another
/// depth, other rates, or a straight run before a cut.
Cures cures_of_closing(const Panel& panel, const CheckLimits& limits);
/// For a panel whose sides would meet: the opposite direction for each cut, or no taper.
Cures cures_of_direction(const Panel& panel);
/// Changes that make the cuts of the side `key` as deep as the panel.
Cures cures_of_depth(const Panel& panel, const std::vector<Cut>& side, const std::string& key);
/// Other rates for one cut: first the given rates, then the usual ones.
Cures cures_of_rate(const Panel& panel, bool is_outer, std::size_t which, std::vector<std::string> rates);
/// Changes that give an edge, or several consecutive edges of one panel, `more` meshes than now.
Cures cures_of_edge(const EdgeSet& edge, double more);

}  // namespace netloft::gears
