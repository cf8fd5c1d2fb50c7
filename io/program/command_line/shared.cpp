// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/shared.hpp"

#include <fmt/format.h>

namespace netloft::program {

namespace {

std::string not_empty(const std::string& text) { return text.empty() ? "must not be empty" : ""; }

}  // namespace

CLI::Option* as_word(CLI::Option* option, const std::string& type) {
  return option->check(CLI::Validator(not_empty, "", "not empty"))->type_name(type);
}

CLI::Option* as_words(CLI::Option* option, const std::string& type) {
  return as_word(option, type)->allow_extra_args(false);
}

CLI::Validator numbers_between(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return is_number ? "" : fmt::format("Value {} not in range {} to {}", text, low, high);
      },
      "NUMBER");
}

void add_color_option(CLI::App& command, CommonOptions& o) {
  command.add_option("--color", o.color, "colours on standard error")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

void add_json_option(CLI::App& command, CommonOptions& o) {
  command.add_flag("--json", o.json, "one JSON object on standard output");
}

void add_common_options(CLI::App& command, CommonOptions& o) {
  add_color_option(command, o);
  add_json_option(command, o);
}

void add_plugin_options(CLI::App& command, PluginOptions& o) {
  command.add_option("--plugins", o.plugins, "folder with plugins, searched before all others")
      ->type_name("DIR");
  add_common_options(command, o);
}

CLI::Option* add_set_option(CLI::App& command, std::vector<std::string>& set, const std::string& doc) {
  return command.add_option("--set", set, doc)->type_name("path=value")->allow_extra_args(false);
}

void add_scene_plugins_option(CLI::App& command, SceneOptions& o) {
  command.add_flag("--scene-plugins", o.scene_plugins, "search the scene's folder for plugins, too");
}

void add_scene_options(CLI::App& command, SceneOptions& o) {
  command.add_option("SCENE", o.scene, "scene file")->required()->type_name("FILE.toml");
  add_set_option(command, o.set, "a value of the scene: parts.net.cells=[64,64]");
  add_opening_options(command, o);
}

void add_opening_options(CLI::App& command, SceneOptions& o) {
  command
      .add_option(
          "--threads", o.threads,
          "threads of the assembly and of large factorisations; results have the same bits for any number")
      ->check(CLI::Range(1, 1024));
  add_scene_plugins_option(command, o);
  add_plugin_options(command, o);
}

void add_method_options(CLI::App& command, MethodOptions& o) {
  add_scene_options(command, o);
  as_word(command.add_option("--strategy", o.strategy,
                             "strategy that finds the equilibrium, with parameters: auto:restarts=6"),
          kMethod);
  as_word(command.add_option("--solver", o.solver,
                             "solver of the stages of the strategy, with parameters: newton:method=classic; "
                             "without --strategy, the solver alone"),
          kMethod);
}

CLI::Option* add_state_option(CLI::App& command, int& state) {
  return command.add_option("--state", state, "number of the output of a motion, from 0; default: the last")
      ->check(CLI::Range(0, 100000000));
}

}  // namespace netloft::program
