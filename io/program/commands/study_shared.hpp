// SPDX-License-Identifier: BSD-3-Clause
//
// Functions that commands about many values of a scene share.
#pragma once
#include "io/formats/svg/bar_chart.hpp"
#include "io/program/commands/studies.hpp"
#include "io/studies/sweep/study.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace netloft::program {

/// Reads the manifest of a planned study. Throws UsageError if there is none.
studies::Study read_study(const std::filesystem::path& folder);

/// A sentence about a file that has changed since the study was planned; empty if no file has changed.
std::string what_changed(const studies::Study& study, const std::filesystem::path& folder);

/// Prints an answer as text or, with --json, as an object.
void print_answer(const CommonOptions& options, const nlohmann::ordered_json& json, const std::string& text);

/// Writes bars as SVG. Throws UsageError if there is nothing to draw or too much for a page. `flag` is the
/// option that selects the groups, for the message.
void write_bars(const std::string& file, const formats::BarChart& bars, const char* flag);

/// Number and noun: "1 item", "2 items".
std::string count_of(std::size_t n, const char* what);

}  // namespace netloft::program
