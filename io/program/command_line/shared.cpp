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

void add_color_option(CLI::App& command, Options& o) {
  command.add_option("--color", o.color, "colour on standard error")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

void add_json_option(CLI::App& command, Options& o) {
  command.add_flag("--json", o.json, "one JSON object on standard output");
}

void add_set_option(CLI::App& command, Options& o, const std::string& doc) {
  command.add_option("--set", o.set, doc)->type_name("path=value")->allow_extra_args(false);
}

CLI::Option* add_plugins_option(CLI::App& command, Options& o) {
  return command.add_option("--plugins", o.plugins, "folder with plugins, searched before all others")
      ->type_name("DIR");
}

void add_plugin_options(CLI::App& command, Options& o) {
  add_plugins_option(command, o);
  add_color_option(command, o);
  add_json_option(command, o);
}

void add_input_options(CLI::App& command, Options& o) {
  command.add_option("SCENE", o.target, "scene file (TOML)")->required();
  add_set_option(command, o, "a value of the scene: parts.net.cells=[64,64]");
  command
      .add_option(
          "--threads", o.threads,
          "threads of the assembly and of large factorisations; results have the same bits for any number")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--scene-plugins", o.scene_plugins, "search the scene's folder for plugins, too");
  add_plugin_options(command, o);
}

void add_scene_options(CLI::App& command, Options& o) {
  add_input_options(command, o);
  as_word(command.add_option("--strategy", o.strategy,
                             "how the equilibrium is found, with parameters: auto:restarts=6"),
          kMethod);
  as_word(command.add_option(
              "--solver", o.solver,
              "solver of the stages, with parameters: newton:method=classic; alone, without a strategy"),
          kMethod);
}

void add_state_option(CLI::App& command, Options& o) {
  command.add_option("--state", o.picture.state, "of a motion: number of the output, from 0; else the last")
      ->check(CLI::Range(0, 100000000));
}

}  // namespace netloft::program
