// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/results/text/gear_text.hpp"

namespace netloft::results {

/// All tables of a report in their order, but for the bill of materials; text and HTML print the same. Beside
/// those of a gear (gear_text.hpp) they are, each left out if it would be empty:
///   the least and the largest value of every number over the equilibria that were found;
///   the change of these numbers with a growing motion, for each metre that its furthest node moves;
///   forces of the holds, and of parts where no table of a gear has them.
std::vector<FigureTable> report_tables(const Result& result);

}  // namespace netloft::results
