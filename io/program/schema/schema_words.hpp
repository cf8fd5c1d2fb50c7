// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/components.hpp"

#include <initializer_list>
#include <span>
#include <string>
#include <utility>

/// Building blocks of JSON schemas.
namespace netloft::program::schema {

/// A table that allows only keys that are added to it.
Json object();
Json text(const std::string& doc);
/// The schema of an SI number, or a text with a unit.
Json quantity(const std::string& unit, double lo, double hi, const std::string& doc);
/// A table of columns by name; the first column is the abscissa.
Json columns_schema(const std::string& doc,
                    std::initializer_list<std::pair<const char*, const char*>> columns);

/// Adds a schema at a dotted name, and creates the tables in between.
void put(Json& owner, const std::string& name, const Json& schema, bool required);
void put_table(Json& owner, std::span<const netloft_parameter> table);
/// Removes repeated names from the required keys.
void drop_repeats(Json& schema);

}  // namespace netloft::program::schema
