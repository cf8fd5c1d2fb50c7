// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

namespace netloft::gears {

/// Proposals for `name`, which no part has: up to three names of parts that have all its words, or synonyms
/// of them, with the nearest diameters. If there are none, the name that differs in a few letters; or else up
/// to three names that have some of its words. Empty if nothing is similar.
std::vector<std::string> similar_names(const std::string& name,
                                       const std::vector<const CataloguePart*>& parts,
                                       const std::vector<std::vector<std::string>>& synonyms);

}  // namespace netloft::gears
