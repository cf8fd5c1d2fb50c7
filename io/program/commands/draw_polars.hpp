// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <filesystem>
#include <string>

namespace netloft::program {

/// Whether a file of a catalogue has tables `[polar.NAME]`.
bool holds_polars(const std::filesystem::path& file);

/// The polars of such a file over the angle of attack: the numbers of their tables, and between them the
/// curves that boards are computed with. SVG, or an HTML page with a plot of each.
std::string draw_polars(const std::filesystem::path& file, bool is_page, formats::Diagnostics& diagnostics);

}  // namespace netloft::program
