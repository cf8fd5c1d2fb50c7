// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/water/dice.hpp"

#include <map>
#include <string>

namespace netloft::hard_cases {

/// The numbers of a random case by their names, written as texts. They are read from a table of entries:
///   across = { whole = [20, 60] }          whole numbers, both ends included, all equally likely
///   bar = { from = 0.1, to = 0.6 }         uniform
///   EA = { from = 1e3, to = 1e6, log = true }    uniform in its logarithm
///   type = { one_of = ["priour/triangle", "lumped/net"] }
using RandomTexts = std::map<std::string, std::string>;
RandomTexts random_texts(formats::TableReader vary, scenes::Dice& dice);

/// Replaces $name by its number, in every text of a value.
void fill_in(formats::Value& value, const RandomTexts& random);

}  // namespace netloft::hard_cases
