// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// A number as it is on a card: "1.99 m", "22.1 kN", "0.41 ± 0.06 m".
std::string card_text(const results::NamedScalar& figure);

/// How a run ended, in a word with a coloured dot.
std::string badge_html(const results::Result& result);

/// The figures that are wanted first, each with its error, as boxes on top of a page; for two results before
/// and after. Empty if there are none.
std::string key_figures_html(const std::vector<const results::Result*>& results);

}  // namespace netloft::pictures
