// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

namespace netloft::gears {

/// The names of the parts that `name`, which is none of theirs, most likely means: up to three that have its
/// words, or synonyms of them, with the nearest diameters; or else the one that differs in a few letters; or
/// else up to three that have some of its words. Empty if nothing is similar.
std::vector<std::string> similar_names(const std::string& name,
                                       const std::vector<const CataloguePart*>& parts,
                                       const std::vector<std::vector<std::string>>& synonyms);

}  // namespace netloft::gears
