// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "io/formats/units/udunits.hpp"

namespace netloft::formats {

/// The common words with their units, as the database had them when Netloft was built
/// (write_known_words.cpp). Reading the database takes as long as all else that reads a small scene.
const std::map<std::string, Unit>& known_words();

}  // namespace netloft::formats
