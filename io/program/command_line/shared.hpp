// SPDX-License-Identifier: BSD-3-Clause
//
// Options that several commands have, and what options of one kind have in common.
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

namespace netloft::program {

/// A solver or strategy with parameters.
inline constexpr const char* kMethod = "NAME[:key=value,…]";

/// A word that must not be empty; help shows `type` for it.
CLI::Option* as_word(CLI::Option* option, const std::string& type);
/// The same of an option that may be repeated.
CLI::Option* as_words(CLI::Option* option, const std::string& type);
/// CLI::Range lets what is no number at all pass.
CLI::Validator numbers_between(double low, double high);

void add_color_option(CLI::App& command, Options& o);
void add_json_option(CLI::App& command, Options& o);
void add_set_option(CLI::App& command, Options& o, const std::string& doc);
CLI::Option* add_plugins_option(CLI::App& command, Options& o);
/// --plugins, --color, --json.
void add_plugin_options(CLI::App& command, Options& o);
/// A scene, and where its plugins are.
void add_input_options(CLI::App& command, Options& o);
/// The same, and how it is solved.
void add_scene_options(CLI::App& command, Options& o);
/// Number of an output of a motion.
void add_state_option(CLI::App& command, Options& o);

}  // namespace netloft::program
