// SPDX-License-Identifier: BSD-3-Clause
//
// Commands about many values of one scene: `study` with its actions, `scope`, `sensitivity`, `optimise` and
// `calibrate`.
#include "io/program/commands/studies.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

// groups of options
constexpr const char *kForSlurm = "For Slurm", *kForParallel = "For GNU parallel";

template <class Options>
void add_folder(CLI::App& action, Options& o) {
  action.add_option("FOLDER", o.folder, "folder that `netloft study plan` wrote")
      ->required()
      ->type_name("FOLDER");
}

/// Adds an action that works on a planned study and loads no plugins.
template <class Options>
Command<Options> add_action(CLI::App& study, Chosen& chosen, const char* name, const char* doc,
                            int (*run)(const Options&)) {
  auto [action, o] = add_command(study, chosen, name, doc, run);
  add_folder(action, o);
  add_common_options(action, o);
  return {action, o};
}

void add_plan_action(CLI::App& study, Chosen& chosen) {
  auto [plan, o] = add_command(study, chosen, "plan",
                               "check a study file and write the manifest of its items", study_plan_command);
  plan.add_option("STUDY", o.file, "study file")->required()->type_name("FILE.toml");
  as_word(plan.add_option("-o,--output", o.output,
                          "folder of the study; default: its name with .study, in this folder"),
          "FOLDER");
  add_plugin_options(plan, o);
}

void add_run_action(CLI::App& study, Chosen& chosen) {
  auto [run, o] =
      add_command(study, chosen, "run", "compute the items that have no result yet", study_run_command);
  add_folder(run, o);
  as_word(run.add_option("--items", o.items, "compute only these items, such as 1-10 or 3,7; default: all"),
          "A-B");
  run.add_option("--jobs", o.jobs,
                 "items that are computed at the same time; default: as many as the machine has cores")
      ->check(CLI::Range(1, 4096));
  run.add_option("--threads", o.threads, "threads of the assembly of each item; default: one")
      ->check(CLI::Range(1, 1024));
  add_plugin_options(run, o);
}

void add_missing_action(CLI::App& study, Chosen& chosen) {
  auto [missing, o] =
      add_command(study, chosen, "missing", "print the numbers of the items that have no result yet",
                  study_missing_command);
  add_folder(missing, o);
}

void refuse_options_of_other_engines(const StudySubmitOptions& o, const CLI::App& submit) {
  require_group(submit, {o.engine == "slurm" ? kForSlurm : kForParallel}, "the engine is " + o.engine);
}

void add_submit_action(CLI::App& study, Chosen& chosen) {
  auto [submit, o] = add_command(study, chosen, "submit",
                                 "write a script with which GNU parallel or Slurm computes the items",
                                 study_submit_command, refuse_options_of_other_engines);
  add_folder(submit, o);
  submit.add_option("--engine", o.engine, "GNU parallel, or a job array of Slurm")
      ->required()
      ->check(CLI::IsMember({"parallel", "slurm"}));
  add_plugin_options(submit, o);
  submit.add_option("--chunk", o.chunk, "items in a task; default: as many as take a minute")
      ->check(CLI::Range(1, 1000000))
      ->group(kForSlurm);
  submit
      .add_option("--jobs", o.jobs,
                  "items that are computed at the same time; default: as many as there are cores")
      ->check(CLI::Range(1, 4096))
      ->group(kForParallel);
}

void add_collect_action(CLI::App& study, Chosen& chosen) {
  auto [collect, o] = add_action(study, chosen, "collect", "put the results of all items into one table",
                                 study_collect_command);
  as_word(collect.add_option("-o,--output", o.output, "folder of the tables; default: that of the study"),
          "FOLDER");
}

void add_show_action(CLI::App& study, Chosen& chosen) {
  auto [show, o] = add_action(
      study, chosen, "show", "draw figures over a variable, with bands over the samples", study_show_command);
  const auto named = [&app = show](const char* flag, auto& value, const char* doc, const char* type) {
    as_words(app.add_option(flag, value, doc), type);
  };
  named("--figure", o.figures, "a figure of the table; may be repeated; default: all that vary", "NAME");
  named("--over", o.over, "variable of the axis; default: the first of the path", "NAME");
  named("--by", o.by,
        "variable that gets a line for each of its values; default: the next variable with listed values",
        "NAME");
  named("--at", o.at, "value of another variable; may be repeated; default: the first value of each",
        "NAME=VALUE");
  named("-o,--output", o.output, "page or picture; default: the study's name with .html, in its folder",
        "FILE.html|FILE.svg");
}

void add_study_command(CLI::App& app, Chosen& chosen) {
  auto& study = *app.add_subcommand("study", "solve one scene many times, with other values");
  study.require_subcommand(1);
  add_plan_action(study, chosen);
  add_run_action(study, chosen);
  add_missing_action(study, chosen);
  add_submit_action(study, chosen);
  add_collect_action(study, chosen);
  add_show_action(study, chosen);
}

void add_scope_command(CLI::App& app, Chosen& chosen) {
  auto [command, o] = add_command(app, chosen, "scope",
                                  "find, for several depths, the lengths of warp at which the boards have "
                                  "the heel and spread that you want",
                                  scope_command);
  add_method_options(command, o);
  const auto range = [&app = command](const char* flag, std::string& value, const char* doc,
                                      const char* type) {
    return as_word(app.add_option(flag, value, doc), type);
  };
  range("--depth", o.depth, "depths [m]; default: 7 of them", "LO:HI[:N]")->required();
  range("--warp", o.warp, "lengths of warp divided by the depth; default: 2:5:13", "LO:HI[:N]");
  range("--heel", o.heel, "heel of the boards [deg], outward; default: -5:5", "LO:HI");
  range("--spread", o.spread, "spread of the boards [m]; default: any", "LO:HI");
  range("-o,--output", o.output, "draw the lengths over the depth", "FILE.svg|FILE.html");
}

void add_sensitivity_command(CLI::App& app, Chosen& chosen) {
  auto [command, o] = add_command(
      app, chosen, "sensitivity",
      "find by one solve how much each figure changes with each number of the scene", sensitivity_command);
  add_method_options(command, o);
  command.get_option("SCENE")->description("scene file, or a result, whose scene and shape are taken");
  command.get_option("SCENE")->type_name("FILE.toml|RESULT.hdf");
  as_words(command.add_option("--to", o.to,
                              "a number of the scene, or a table of numbers, as for --set, and its standard "
                              "deviation if known: ship.speed=0.1kn, elements.netting=5%; may be repeated; "
                              "default: all numbers"),
           "PATH[=DEVIATION]");
  as_words(command.add_option(
               "--of", o.of, "a figure, or a group such as mouth; may be repeated; default: the key figures"),
           "NAME");
  as_word(
      command.add_option("-o,--output", o.output, "draw the largest changes as bars, or write all of them"),
      "FILE.svg|FILE.hdf");
  command.add_flag("--check", o.check,
                   "also find all changes with a step a thousand times longer, and mark those that differ: "
                   "there, a member is about to become slack or a node to touch the ground");
}

void add_optimise_command(CLI::App& app, Chosen& chosen) {
  auto [command, o] = add_command(
      app, chosen, "optimise",
      "find the values of numbers of a scene at which a figure is least or greatest, within limits",
      optimise_command);
  command.add_option("STUDY", o.file, "file with variables, objective and constraints")
      ->required()
      ->type_name("FILE.toml");
  as_word(command.add_option("-o,--output", o.output,
                             "folder of the answer; default: the file's name with .optimum, in this folder"),
          "FOLDER");
  add_plugin_options(command, o);
}

}  // namespace

void add_study_commands(CLI::App& app, Chosen& chosen) {
  add_scope_command(app, chosen);
  add_sensitivity_command(app, chosen);
  add_optimise_command(app, chosen);
  add_study_command(app, chosen);
  auto [calibrate, o] = add_command(
      app, chosen, "calibrate",
      "find unknown values of scenes from measurements, and predict the measurements that are held back",
      calibrate_command);
  calibrate.add_option("CALIBRATION", o.file, "calibration file")->required()->type_name("FILE.toml");
  add_plugin_options(calibrate, o);
}

}  // namespace netloft::program
