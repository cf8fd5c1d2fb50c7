// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of the actions of `study`.
#pragma once
#include "io/program/commands/studies.hpp"
#include "io/studies/sweep/study.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace netloft::program {

/// Reads the manifest of a planned study. Throws UsageError if there is none.
studies::Study read_study(const std::filesystem::path& folder);

/// A sentence about a file that is no longer what it was when the study was planned; empty if there is none.
std::string what_changed(const studies::Study& study, const std::filesystem::path& folder);

/// Prints an answer for people, or with --json for programs.
void print_answer(const CommonOptions& options, const nlohmann::ordered_json& json, const std::string& text);

/// "1 item", "2 items".
std::string count_of(std::size_t n, const char* what);

}  // namespace netloft::program
