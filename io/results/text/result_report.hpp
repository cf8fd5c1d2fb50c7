// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_result.hpp"

#include <string>

namespace netloft::results {

/// The report of a result as text for people, from its file.
std::string result_text(const StoredResult& result);
/// One JSON object with all numbers and what is known of their errors; unknown values are null.
std::string result_json(const StoredResult& result);
/// A line per number: name, value, unit, error of the solver, error of the mesh, what it is.
std::string result_csv(const StoredResult& result);

}  // namespace netloft::results
