// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/don_scanner.hpp"
#include "io/scenes/import/femnet_gear.hpp"

namespace netloft::scenes::femnet {

/// Reads the tail of a .don, which consists of words. In the tail, `input NAME` and its arguments change the
/// gear. Keywords that a scene cannot represent are added to the findings of the gear; wrong arguments are
/// errors.
void read_keywords(DonScanner& in, GearFile& gear, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes::femnet
