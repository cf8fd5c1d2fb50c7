// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/catalogue/catalogue.hpp"
#include "io/toml/value.hpp"

#include <functional>
#include <optional>

namespace netloft::io {

/// Whether what stands under `twine`, `rope` or `float` names a part of the catalogue: "pe-braided-4mm", or
/// { part = "pe-braided-4mm", diameter = "4.2 mm" }, where the other keys override those of the part.
bool names_a_part(const Value& said);

/// The part that `said` names, of one of `kinds`. Null: there is none, and it was said, with near names.
/// `path` is what `said` stands under, for messages.
const CataloguePart* choose_part(const Value& said, const std::vector<std::string>& kinds,
                                 const std::string& path, const Catalogue& catalogue,
                                 Diagnostics& diagnostics);

/// What a part stands for: a table of its numbers for which `wanted(key)`, with what `said` overrides laid on
/// top. All have the place of `said`, for that is where a person can change them.
Value spell_out(const Value& said, const CataloguePart& part,
                const std::function<bool(const std::string&)>& wanted);

}  // namespace netloft::io
