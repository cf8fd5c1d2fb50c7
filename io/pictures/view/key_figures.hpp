// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// Formats a number for a card: "1.99 m", "22.1 kN", "0.41 ± 0.06 m".
std::string card_text(const results::NamedScalar& figure);

/// The outcome of a run, as a word with a coloured dot.
std::string badge_html(const results::Result& result);

/// The key figures with their errors, as boxes at the top of a page. With two results, each box has both
/// values. Empty if the results have no key figures.
std::string key_figures_html(const std::vector<const results::Result*>& results);

}  // namespace netloft::pictures
