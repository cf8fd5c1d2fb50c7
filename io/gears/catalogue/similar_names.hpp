// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

namespace netloft::gears {

/// Proposals if no part is called `name`: up to three part names that contain all its words (or synonyms of
/// them) and have the nearest diameters. If there are none: a part name that differs in a few letters, or up
/// to three part names that contain some of its words. Empty if nothing is similar.
std::vector<std::string> similar_names(const std::string& name,
                                       const std::vector<const CataloguePart*>& parts,
                                       const std::vector<std::vector<std::string>>& synonyms);

}  // namespace netloft::gears
