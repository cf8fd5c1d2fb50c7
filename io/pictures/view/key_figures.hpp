// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_result.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// How a run ended, in a word with a coloured dot.
std::string badge_html(const results::StoredResult& result);

/// The figures that are asked for first, each with its error, as boxes on top of a page; of two results
/// before and after. Empty if there are none.
std::string key_figures_html(const std::vector<const results::StoredResult*>& results);

/// A name of the report as words: "headline_height" is "headline height".
std::string spoken(std::string name);

}  // namespace netloft::pictures
