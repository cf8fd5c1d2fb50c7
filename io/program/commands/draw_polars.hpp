// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <filesystem>
#include <string>

namespace netloft::program {

/// Whether a catalogue file has tables `[polar.NAME]`.
bool holds_polars(const std::filesystem::path& file);

/// Draws the polars of a catalogue file as SVG, or as an HTML page with a plot of each polar. A polar is a
/// table of the force coefficients of a board over the angle of attack. A plot shows the numbers of the table
/// and the interpolated curve that the computation of otter boards uses.
std::string draw_polars(const std::filesystem::path& file, bool is_page, formats::Diagnostics& diagnostics);

}  // namespace netloft::program
