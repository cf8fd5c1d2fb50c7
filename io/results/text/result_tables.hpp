// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/results/text/gear_text.hpp"

namespace netloft::results {

/// All tables of a report in their order, except the bill of materials, for text and HTML alike. Besides the
/// tables of a gear (gear_text.hpp), these are the following, unless they are empty:
///   the least and the largest value of every number over the equilibria that were found;
///   the numbers of the scene on which the key figures depend most;
///   the changes of the numbers in a growing motion, per metre of the largest displacement of a node;
///   the forces of holds;
///   the forces on parts, if no table of a gear has them.
std::vector<FigureTable> report_tables(const Result& result);

}  // namespace netloft::results
