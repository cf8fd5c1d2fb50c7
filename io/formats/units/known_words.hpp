// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "io/formats/units/udunits.hpp"

namespace netloft::formats {

/// The common words with their units, copied from the database when Netloft was built
/// (write_known_words.cpp). Reading the database at run time would take as long as reading a small scene.
const std::map<std::string, Unit>& known_words();

}  // namespace netloft::formats
