// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/components.hpp"

#include <initializer_list>
#include <span>
#include <string>
#include <utility>

/// Building blocks of JSON schemas.
namespace netloft::program::schema {

/// A table without keys, which allows only the keys that are put in.
Json object();
Json text(const std::string& doc);
/// An SI number, or a text with a unit.
Json quantity(const std::string& unit, double lo, double hi, const std::string& doc);
/// A table of columns by name; the first has the abscissa.
Json columns_schema(const std::string& doc,
                    std::initializer_list<std::pair<const char*, const char*>> columns);

/// Puts a schema at a dotted name, making tables on the way.
void put(Json& owner, const std::string& name, const Json& schema, bool required);
void put_table(Json& owner, std::span<const netloft_parameter> table);
/// Removes repeated names from the required keys.
void drop_repeats(Json& schema);

}  // namespace netloft::program::schema
