// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_table.hpp"

#include <optional>

namespace netloft::studies {

/// A place in the space of a study's variables: a value for each column of its table; nullopt for variables
/// to which the request gives no value.
using Site = std::vector<std::optional<VariableValue>>;

/// Whether two numbers of a variable are equal except for the round-off of unit conversion.
bool is_same_number(double a, double b);

/// The numbers that a variable has in a table, in ascending order, each once.
std::vector<double> levels_of(const StudyTable& table, std::size_t column);

/// Whether a request has to give every variable a value.
enum class SiteNeeds { all, nothing };

/// Reads a place from words such as "speed=2.7 kn", each of which may contain several, separated by commas.
/// Errors (estimate.hpp lists them) are reported to `diagnostics`; after one, the place must not be used.
Site read_site(const StudyTable& table, const std::vector<std::string>& words,
               formats::Diagnostics& diagnostics, SiteNeeds needs = SiteNeeds::all);

}  // namespace netloft::studies
