// SPDX-License-Identifier: BSD-3-Clause
//
// Options that several commands share, and checks of their values.
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

namespace netloft::program {

/// A solver or strategy with parameters.
inline constexpr const char* kMethod = "NAME[:key=value,…]";

/// Requires a word that is not empty. The help shows `type` as its type.
CLI::Option* as_word(CLI::Option* option, const std::string& type);
/// Requires words that are not empty, for an option that may be repeated.
CLI::Option* as_words(CLI::Option* option, const std::string& type);
/// Requires a number in a range. Unlike CLI::Range, it rejects texts that only begin with a number.
CLI::Validator numbers_between(double low, double high);

void add_color_option(CLI::App& command, CommonOptions& o);
void add_json_option(CLI::App& command, CommonOptions& o);
/// Adds --color and --json.
void add_common_options(CLI::App& command, CommonOptions& o);
/// Adds --plugins, --color and --json.
void add_plugin_options(CLI::App& command, PluginOptions& o);
CLI::Option* add_set_option(CLI::App& command, std::vector<std::string>& set, const std::string& doc);
/// Adds --scene-plugins.
void add_scene_plugins_option(CLI::App& command, SceneOptions& o);
/// Adds --threads, and the options that find the plugins of a scene.
void add_opening_options(CLI::App& command, SceneOptions& o);
/// Adds the scene with --set, and the options of add_opening_options().
void add_scene_options(CLI::App& command, SceneOptions& o);
/// Adds the scene options, and those that choose strategy and solver.
void add_method_options(CLI::App& command, MethodOptions& o);
/// Adds the option that selects an output of a motion by its number.
CLI::Option* add_state_option(CLI::App& command, int& state);

}  // namespace netloft::program
