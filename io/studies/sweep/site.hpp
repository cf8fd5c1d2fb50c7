// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_table.hpp"

#include <optional>

namespace netloft::studies {

/// A place among the points of a study: a value for each column; none for sampled variables that are left
/// open.
using Site = std::vector<std::optional<VariableValue>>;

/// Whether two numbers of a variable are the same but for round-off of their units.
bool is_same_number(double a, double b);

/// The numbers that a variable has in a table, ascending, each once.
std::vector<double> levels_of(const StudyTable& table, std::size_t column);

/// Whether a place must have a value of every variable.
enum class SiteNeeds { all, nothing };

/// Reads a place out of words such as "speed=2.7 kn", which may have several, with commas between. All that
/// is wrong goes to the diagnostics, and then the place must not be used (estimate.hpp says what is wrong).
Site read_site(const StudyTable& table, const std::vector<std::string>& words,
               formats::Diagnostics& diagnostics, SiteNeeds needs = SiteNeeds::all);

}  // namespace netloft::studies
