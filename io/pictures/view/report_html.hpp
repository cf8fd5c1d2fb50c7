// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/diff/result_diff.hpp"

#include <string>

namespace netloft::pictures {

// Functions for the report of a result as HTML elements. All texts of the result are escaped.

/// Outcome, notes and warnings.
std::string summary_html(const results::Result& result);
/// The panels to cut, followed by the bill of materials with loads and breaking loads. Empty if there is no
/// plan.
std::string materials_html(const results::Result& result);

/// The tables of boards and warps, which skippers read first.
std::string deck_html(const results::Result& result);
/// All figures with their errors, tables by part, convergence, and the origins of the result.
std::string details_html(const results::Result& result);

/// The changes between two results as a table.
std::string diff_html(const results::ResultDiff& diff);

/// Escapes the special characters of a text for HTML.
std::string in_html(const std::string& text);

}  // namespace netloft::pictures
