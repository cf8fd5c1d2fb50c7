// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/water/dice.hpp"

#include <map>
#include <string>

namespace netloft::hard_cases {

/// The random values of a case by name, written as texts. The table `vary` has an entry for each:
///   across = { whole = [20, 60] }          whole numbers, both ends included, all equally likely
///   bar = { from = 0.1, to = 0.6 }         uniform
///   EA = { from = 1e3, to = 1e6, log = true }    uniform in its logarithm
///   type = { one_of = ["priour/triangle", "lumped/net"] }
using RandomTexts = std::map<std::string, std::string>;
RandomTexts random_texts(formats::TableReader vary, scenes::Dice& dice);

/// Replaces $name by its random value, in every text within a value.
void fill_in(formats::Value& value, const RandomTexts& random);

}  // namespace netloft::hard_cases
