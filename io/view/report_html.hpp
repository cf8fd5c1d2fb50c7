// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/diff/result_diff.hpp"
#include "io/result/stored_result.hpp"

#include <string>

namespace netloft::io {

/// The report of a result as elements of a page: figures with their errors, parts, materials, warnings, where
/// it comes from. All texts of the result are escaped.
std::string report_html(const StoredResult& result);

/// What changed between two results, as a table.
std::string diff_html(const ResultDiff& diff);

/// Text as it has to stand in a page.
std::string in_html(const std::string& text);

}  // namespace netloft::io
