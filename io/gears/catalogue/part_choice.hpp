// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/value.hpp"
#include "io/gears/catalogue/catalogue.hpp"

#include <functional>
#include <optional>

namespace netloft::gears {

/// Whether the value of `twine`, `rope` or `float` names a part of the catalogue: either "pe-braided-4mm", or
/// { part = "pe-braided-4mm", diameter = "4.2 mm" }, where the other keys override those of the part.
bool names_a_part(const formats::Value& said);

/// The keys whose value may be the name of a part. For such a key, `--set twine.EA=4` changes twine =
/// "pe-braided-4mm" to twine = { part = "pe-braided-4mm", EA = 4 }.
const formats::NamingKeys& keys_that_name_parts();

/// The part of one of `kinds` that `said` names. If there is none, reports an error with similar names and
/// returns nullptr. `path` is the key of `said`, for messages.
const CataloguePart* choose_part(const formats::Value& said, const std::vector<std::string>& kinds,
                                 const std::string& path, const Catalogue& catalogue,
                                 formats::Diagnostics& diagnostics);

/// A table with the numbers and curves of a part, where values in `said` override those of the part. It
/// contains only keys for which `wanted(key)` is true. All numbers have the place of `said`, where the user
/// can change them.
formats::Value spell_out(const formats::Value& said, const CataloguePart& part,
                         const std::function<bool(const std::string&)>& wanted);

/// Adds tables of a catalogue part (points and outline of a board) to the table that names the part. Keys
/// that the table already has take precedence.
void put_beside(const CataloguePart& part, formats::Table& owner);

}  // namespace netloft::gears
