// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/plot.hpp"
#include "io/studies/compare/comparison.hpp"

namespace netloft::studies {

/// The comparison as text: a table.
std::string comparison_text(const Comparison& c);

/// The comparison as CSV: a line with the names of the columns, then a row for each trial and for each mesh.
/// Solver errors and discretisation errors are in rows of different kinds. The cells of unknown values are
/// empty.
std::string comparison_csv(const Comparison& c);

/// The comparison as one JSON object; unknown values are null.
std::string comparison_json(const Comparison& c);

/// The work-precision diagram: work as a function of error. Each method has a line from its loosest tolerance
/// to its tightest, and the discretisation error of each mesh has a mark.
formats::LinePlot comparison_plot(const Comparison& c);

}  // namespace netloft::studies
