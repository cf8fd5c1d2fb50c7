// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>

namespace netloft::results {

/// The report of a result as text, for people. The result may be new or read from a file.
std::string result_text(const Result& result);
/// One JSON object with all numbers and their errors; unknown values are null.
std::string result_json(const Result& result);
/// One line per number: name, value, unit, solver error, mesh error, description.
std::string result_csv(const Result& result);

/// The outcome of a run in words: "converged, stable equilibrium", "unstable equilibrium, swinging".
std::string ending_text(const Result& result);
/// A short sentence about the errors of the numbers: whether ± includes all errors, or why they are not
/// known.
std::string short_errors_text(const Result& result);
/// A longer text that also gives the meshes from which errors were estimated, and the figures that do not
/// converge.
std::string errors_text(const Result& result);

}  // namespace netloft::results
