// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that solve a scene many times: `study` with its actions, and `calibrate`.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

constexpr const char* kFigureDoc = "a figure of the table, may be repeated; else all but those of parts";

CLI::App* add_action(CLI::App& study, Options& o, const char* name, const char* doc) {
  auto* action = study.add_subcommand(name, doc);
  action->callback([&o, name] { o.study.action = name; });
  return action;
}

/// Of one that works on a study that was planned.
CLI::App* add_action_in_folder(CLI::App& study, Options& o, const char* name, const char* doc) {
  auto* action = add_action(study, o, name, doc);
  action->add_option("FOLDER", o.target, "folder of a study that was planned")->required();
  add_color_option(*action, o);
  add_json_option(*action, o);
  return action;
}

void add_plan_action(CLI::App& study, Options& o) {
  auto* plan = add_action(study, o, "plan", "check a study file and write the manifest of its items");
  plan->add_option("STUDY", o.target, "study file (TOML)")->required();
  as_word(plan->add_option("-o,--output", o.output,
                           "folder of the study; else its name with .study, in this folder"),
          "FOLDER");
  add_plugin_options(*plan, o);
}

void add_run_action(CLI::App& study, Options& o) {
  auto* run = add_action_in_folder(study, o, "run", "compute the items that have no result yet");
  as_word(run->add_option("--items", o.study.items, "only these, such as 1-10 or 3,7; else all"), "A-B");
  run->add_option("--jobs", o.study.jobs, "items at a time; else as many as the machine has cores")
      ->check(CLI::Range(1, 4096));
  run->add_option("--threads", o.threads, "threads of the assembly of each; else one")
      ->check(CLI::Range(1, 1024));
  add_plugins_option(*run, o);
}

void add_missing_action(CLI::App& study, Options& o) {
  auto* missing = add_action(study, o, "missing", "print the numbers of the items that have no result yet");
  missing->add_option("FOLDER", o.target, "folder of a study that was planned")->required();
}

void add_submit_action(CLI::App& study, Options& o) {
  auto* submit =
      add_action_in_folder(study, o, "submit", "write a script that lets an engine compute the items");
  submit->add_option("--engine", o.study.engine, "GNU parallel, or a job array of Slurm")
      ->required()
      ->check(CLI::IsMember({"parallel", "slurm"}));
  submit->add_option("--chunk", o.study.chunk, "of Slurm: items of a task; else as many as take a minute")
      ->check(CLI::Range(1, 1000000));
  submit->add_option("--jobs", o.study.jobs, "of parallel: items at a time; else as many as there are cores")
      ->check(CLI::Range(1, 4096));
  add_plugins_option(*submit, o);
}

void add_show_action(CLI::App& study, Options& o) {
  auto* show =
      add_action_in_folder(study, o, "show", "draw figures over a variable, with bands over the draws");
  const auto named = [&](const char* flag, auto& value, const char* doc, const char* type) {
    as_words(show->add_option(flag, value, doc), type);
  };
  named("--figure", o.study.figures, "a figure of the table, may be repeated; else all that vary", "NAME");
  named("--over", o.study.over, "variable of the axis; else the first of the path", "NAME");
  named("--by", o.study.by, "variable with a line for every value; else the next listed one", "NAME");
  named("--at", o.study.at, "value of another variable; may be repeated; else its first", "NAME=VALUE");
  named("-o,--output", o.output, "page or picture; else the study's name with .html, in its folder",
        "FILE.html|FILE.svg");
}

void add_estimate_action(CLI::App& study, Options& o) {
  auto* estimate = add_action_in_folder(
      study, o, "estimate", "say figures between the points that were computed, with their errors");
  as_words(
      estimate->add_option(
          "--at", o.study.at,
          "the place: every variable; those that are sampled all, or none for medians and bands over the "
          "samples; may be repeated, or with commas between"),
      "NAME=VALUE")
      ->required();
  as_words(estimate->add_option("--figure", o.study.figures, kFigureDoc), "NAME");
}

void add_sobol_action(CLI::App& study, Options& o) {
  auto* action = add_action_in_folder(
      study, o, "sobol", "say which variables figures follow from: Sobol indices, with their errors");
  as_words(action->add_option("--figure", o.study.figures, kFigureDoc), "NAME");
  as_words(
      action->add_option("--at", o.study.at,
                         "a variable that is held; may be repeated, or with commas between; else all vary"),
      "NAME=VALUE");
  as_words(action->add_option("-o,--output", o.output, "draw the indices as bars"), "FILE.svg");
}

}  // namespace

void add_study_command(CLI::App& app, Options& o) {
  auto* study = app.add_subcommand("study", "solve one scene many times, with other values");
  study->require_subcommand(1);
  add_plan_action(*study, o);
  add_run_action(*study, o);
  add_missing_action(*study, o);
  add_submit_action(*study, o);
  add_action_in_folder(*study, o, "collect", "put the results of all items into one table");
  add_show_action(*study, o);
  add_estimate_action(*study, o);
  add_sobol_action(*study, o);
}

void add_calibrate_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "calibrate",
      "find what is not known of scenes out of what was measured, and predict what was held back");
  command->add_option("CALIBRATION", o.target, "calibration file (TOML)")->required();
  add_plugin_options(*command, o);
}

}  // namespace netloft::program
