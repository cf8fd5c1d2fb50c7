// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <filesystem>
#include <string>

namespace netloft::program {

/// Whether a catalogue file has tables `[polar.NAME]`.
bool holds_polars(const std::filesystem::path& file);

/// Draws the polars of a catalogue file, coefficients of the force on boards over the angle of attack: the
/// numbers in their tables, and the curves between these numbers with which otter boards are computed. The
/// result is SVG, or an HTML page with a plot of each polar.
std::string draw_polars(const std::filesystem::path& file, bool is_page, formats::Diagnostics& diagnostics);

}  // namespace netloft::program
