// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/nearest.hpp"
#include "io/cli/commands.hpp"
#include "io/cli/error_json.hpp"
#include "io/cli/last_words.hpp"
#include "io/cli/launched.hpp"
#include "io/cli/memory_room.hpp"
#include "io/cli/prefix.hpp"
#include "solvers/factorisation/large_blocks.hpp"

#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <limits>
#include <span>

namespace netloft::io {
namespace {

void add_plugin_options(CLI::App& command, Options& o) {
  command.add_option("--plugins", o.plugins, "folder with plugins, searched before all others")
      ->type_name("DIR");
  command.add_option("--color", o.color, "colour on standard error")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command.add_flag("--json", o.json, "one JSON object on standard output");
}

/// CLI::Range lets what is no number at all pass.
CLI::Validator between(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return is_number ? "" : fmt::format("Value {} not in range {} to {}", text, low, high);
      },
      "NUMBER");
}

std::string not_empty(const std::string& text) { return text.empty() ? "must not be empty" : ""; }

void add_input_options(CLI::App& command, Options& o) {
  command.add_option("SCENE", o.target, "scene file (TOML)")->required();
  command.add_option("--set", o.set, "a value of the scene: parts.net.cells=[64,64]")
      ->type_name("path=value")
      ->allow_extra_args(false);
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
  command
      .add_option("--strategy", o.strategy, "how the equilibrium is found, with parameters: auto:restarts=6")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME[:key=value,…]");
  command
      .add_option("--solver", o.solver,
                  "solver of the stages, with parameters: newton:method=classic; alone, without a strategy")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME[:key=value,…]");
}

/// Methods are compared in the order in which they are typed, whatever their kinds.
void add_method_option(CLI::App& command, CompareOptions& c, const std::string& name, const std::string& word,
                       const std::string& doc) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [&c, word](const std::vector<std::string>& all) {
            for (const auto& one : all) c.methods.push_back(word + one);
          },
          doc + "; may be repeated")
      ->trigger_on_parse()
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME[:key=value,…]")
      ->allow_extra_args(false);
}

void add_compare_command(CLI::App& app, Options& o) {
  CompareOptions& c = o.compare;
  auto* command =
      app.add_subcommand("compare", "speed against error of several solvers or integrators on one scene");
  add_input_options(*command, o);
  command->add_option("--accuracy", c.accuracy, "accuracies of motions, one per decade; else 1e-3:1e-1")
      ->type_name("LO:HI");
  add_method_option(*command, c, "--integrator", "integrator ",
                    "an integrator to compare on a scene that moves, such as newmark");
  add_method_option(*command, c, "--strategy", "strategy ", "a strategy to compare, as run takes it");
  add_method_option(*command, c, "--solver", "", "a solver to compare, as run takes it");
  command->add_option("--tolerance", c.tolerance, "tolerances, one per decade; else 1e-10:1e-2")
      ->type_name("LO:HI");
  command->add_option("--cells", c.cells, "meshes for the discretisation error: cells across, or of one part")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("[PART=]N,N,…");
  command
      ->add_option("--reference", c.reference,
                   "solver or integrator that errors are measured against; else another one")
      ->type_name("NAME[:key=value,…]");
  command->add_option("--repeats", c.repeats, "runs of each, of which the cheapest counts; else 3")
      ->check(CLI::Range(1, 1000));
  command->add_option("--csv", c.csv, "write the tables as comma-separated values")->type_name("FILE.csv");
  command->add_option("--plot", c.plot, "draw work over precision")->type_name("FILE.svg|FILE.html");
}

void add_diff_command(CLI::App& app, Options& o) {
  auto* command =
      app.add_subcommand("diff", "say what changed between two results, and in what they were made of");
  command->add_option("BEFORE", o.target, "result file (.hdf)")->required();
  command->add_option("AFTER", o.other, "another one")->required();
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_refine_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "refine", "solve a scene on finer and finer meshes, and say what its results tend to");
  add_scene_options(*command, o);
  command->add_option("--nodes", o.nodes, "of a gear: about how many nodes; else 500,2000,8000,30000")
      ->check(CLI::Range(std::int64_t{10}, std::int64_t{10'000'000}))
      ->delimiter(',')
      ->type_name("N,N,…")
      ->allow_extra_args(false);
  command->add_option("--cells", o.compare.cells, "of other scenes: cells across, or of one part")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("[PART=]N,N,…");
}

void add_scope_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "scope", "find the lengths of warp, over depths, with which boards stand as they ought to");
  add_scene_options(*command, o);
  const auto range = [&](const char* flag, std::string& value, const char* doc, const char* type) {
    return command->add_option(flag, value, doc)
        ->check(CLI::Validator(not_empty, "", "not empty"))
        ->type_name(type);
  };
  range("--depth", o.scope.depth, "depths [m]; else 7 of them", "LO:HI[:N]")->required();
  range("--warp", o.scope.warp, "lengths of warp over the depth; else 2:5:13", "LO:HI[:N]");
  range("--heel", o.scope.heel, "heel of the boards [deg], outward; else -5:5", "LO:HI");
  range("--spread", o.scope.spread, "spread of the boards [m]; else any", "LO:HI");
  range("-o,--output", o.output, "draw the lengths over the depth", "FILE.svg|FILE.html");
}

void add_author_commands(CLI::App& app, Options& o) {
  auto* make =
      app.add_subcommand("new", "write a plugin to begin with: it builds, passes its tests and runs");
  make->add_option("KIND", o.kind, "what the plugin holds")
      ->required()
      ->check(CLI::IsMember({"element", "law", "solver", "integrator", "strategy"}));
  make->add_option("NAME", o.target, "its name, such as otter_board; also that of the folder")->required();
  auto* reference =
      app.add_subcommand("reference", "write reference pages of all components, and the schema");
  reference->add_option("FOLDER", o.target, "where to; made if it is not there")->required();
  add_plugin_options(*reference, o);
  app.add_flag_callback(
      "--cflags", [] { throw CLI::CallForVersion(compiler_flags(), 0); },
      "flags that compile a plugin: c++ $(netloft --cflags) otter.cpp -o otter.so");
}

void add_plan_options(CLI::App& command, Options& o) {
  command.add_option("GEAR", o.target, "net plan (TOML); draw takes a result, too")->required();
  command.add_option("--set", o.set, "a value of the plan: panels.top-wing.aft=130")
      ->type_name("path=value")
      ->allow_extra_args(false);
  add_plugin_options(command, o);
}

void add_picture_options(CLI::App& command, Options& o) {
  PictureOptions& p = o.picture;
  command.add_option("--view", p.view, "of a result: where from; else oblique")
      ->check(CLI::IsMember({"side", "top", "front", "oblique"}));
  command.add_option("--field", p.field, "of a result: what is coloured, or part; else tension")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME");
  command.add_option("--state", p.state, "of a motion: number of the output, from 0; else the last")
      ->check(CLI::Range(0, 100000000));
  command.add_option("--width", p.width, "of a result: pixels; else 1000")->check(CLI::Range(300, 8000));
  command.add_option("--fit", p.fit, "of a result: what there is room for; else netting")
      ->check(CLI::IsMember({"netting", "boards", "all"}));
  command.add_flag("--dark", p.dark, "of a result: on dark ground");
  command.add_flag("--log", p.log, "of a result: logarithmic colours");
  command.add_flag("--elements", p.elements,
                   "of a result: netting in the value of each triangle, not in means at nodes");
  command.add_flag("--dimensions", p.dimensions,
                   "of a result: headline height and spreads as dimension lines");
}

void add_result_commands(CLI::App& app, Options& o) {
  auto* report = app.add_subcommand("report", "print the report of a result again");
  report->add_option("RESULT", o.target, "result file (.hdf)")->required();
  auto* html = report->add_flag("--html", o.html, "as a page in one file, without scripts");
  auto* json = report->add_flag("--json", o.json, "one JSON object on standard output");
  report->add_flag("--csv", o.csv, "comma-separated values on standard output")
      ->excludes(html)
      ->excludes(json);
  report->add_option("-o,--output", o.output, "page; else the result's name with .html, in this folder")
      ->needs(html)
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE.html");
  auto* convert = app.add_subcommand("export", "write a result for other programs");
  convert->add_option("RESULT", o.target, "result file (.hdf)")->required();
  convert
      ->add_option(
          "FILE", o.output,
          "its ending says what: .glb is binary glTF, .csv a table, .mesh, .obj and .vtk meshes for scenes")
      ->required();
  convert->add_option("--table", o.kind, "of a .csv: nodes or elements; else nodes")
      ->check(CLI::IsMember({"nodes", "elements"}));
  convert->add_option("--field", o.picture.field, "of a .glb: what is coloured, or part; else tension")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME");
  convert->add_option("--state", o.picture.state, "of a motion: number of the output, from 0; else the last")
      ->check(CLI::Range(0, 100000000));
  convert->add_flag("--json", o.json, "one JSON object on standard output");
  auto* view = app.add_subcommand(
      "view", "write a page to look at results with: two are laid over one another, more are a sweep");
  view->add_option("RESULT", o.targets, "result files (.hdf)")->required();
  view->add_option("-o,--output", o.output, "page; else the first result's name with .html, in this folder")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE.html");
  view->add_option("--states", o.picture.states, "of a motion with more outputs, as many are kept; else 100")
      ->check(CLI::Range(2, 100000));
  view->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_gear_commands(CLI::App& app, Options& o) {
  auto* catalogue = app.add_subcommand("catalogue", "list the parts that scenes and gears name");
  catalogue->add_option("NAME", o.target, "a part, for all that is known of it, or a kind, such as twine");
  add_plugin_options(*catalogue, o);
  add_plan_options(
      *app.add_subcommand("check", "say whether a net plan can be sewn, and what to change if not"), o);
  auto* draw = app.add_subcommand("draw", "draw a net plan to scale, or the shape of a result");
  add_plan_options(*draw, o);
  add_picture_options(*draw, o);
  auto* mesh = draw->add_flag("--mesh", o.mesh, "in triangles, as it is divided for a simulation");
  draw->add_option("--nodes", o.mesh_nodes, "about as many, ropes included (2000)")
      ->needs(mesh)
      ->check(CLI::Range(3, 1000000))
      ->type_name("N");
  draw->add_option("-o,--output", o.output,
                   "picture; else the name of the gear or result with .svg, in this folder")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE.svg|FILE.png");
}

void add_stability_command(CLI::App& app, Options& o) {
  StabilityOptions& s = o.stability;
  auto* command = app.add_subcommand(
      "stability", "run strategies and solvers on the suite of hard cases, and print how they did");
  command->add_option("SUITE", s.suite,
                      "folder of the suite; else tests/stability here, or the installed one");
  command->add_option("--strategy", s.strategies, "strategy; may be repeated, and stand beside solvers")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME[:key=value,…]")
      ->allow_extra_args(false);
  command->add_option("--without", s.without, "leave out an attempt of the strategy auto; may be repeated")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("PART")
      ->allow_extra_args(false);
  command->add_option("--set", o.set, "a value of every scene: analysis.newton.damping=0.1")
      ->type_name("path=value")
      ->allow_extra_args(false);
  command->add_option("--solver", s.solvers, "solver, as run takes it; may be repeated")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("NAME[:key=value,…]")
      ->allow_extra_args(false);
  command->add_option("--size", s.sizes, "about 200, 800 and 12000 unknowns; else small,medium")
      ->check(CLI::IsMember({"small", "medium", "large"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--case", s.pattern, "only cases whose name contains this")->type_name("TEXT");
  command->add_option("--draw", s.draw, "number of the draw: another one changes all drawn cases")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  command->add_option("--seconds-per-case", s.seconds, "else 10, and 60 of large ones")
      ->check(between(0.001, 1e6));
  command->add_option("--work", s.work, "for one case, in factorisations of its tangent; else any")
      ->check(between(1.0, 1e9));
  command->add_option("--html", s.html, "write the matrix as a page")->type_name("FILE.html");
  command->add_flag("--update-references", s.update_references, "keep the best answers found in the suite");
  command->add_option("--threads", o.threads, "threads of the assembly; else one")
      ->check(CLI::Range(1, 1024));
  add_plugin_options(*command, o);
}

void add_study_folder(CLI::App& command, Options& o) {
  command.add_option("FOLDER", o.target, "folder of a study that was planned")->required();
  command.add_option("--color", o.color, "colour on standard error")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command.add_flag("--json", o.json, "one JSON object on standard output");
}

CLI::App* add_study_action(CLI::App& study, Options& o, const char* name, const char* doc) {
  auto* action = study.add_subcommand(name, doc);
  action->callback([&o, name] { o.study.action = name; });
  return action;
}

void add_show_action(CLI::App& study, Options& o) {
  auto* show = add_study_action(study, o, "show", "draw figures over a variable, with bands over the draws");
  add_study_folder(*show, o);
  const auto named = [&](const char* flag, auto& value, const char* doc, const char* type) {
    show->add_option(flag, value, doc)
        ->check(CLI::Validator(not_empty, "", "not empty"))
        ->type_name(type)
        ->allow_extra_args(false);
  };
  named("--figure", o.study.figures, "a figure of the table, may be repeated; else all that vary", "NAME");
  named("--over", o.study.over, "variable of the axis; else the first of the path", "NAME");
  named("--by", o.study.by, "variable with a line for every value; else the next listed one", "NAME");
  named("--at", o.study.at, "value of another variable; may be repeated; else its first", "NAME=VALUE");
  named("-o,--output", o.output, "page or picture; else the study's name with .html, in its folder",
        "FILE.html|FILE.svg");
}

void add_estimate_action(CLI::App& study, Options& o) {
  auto* estimate = add_study_action(study, o, "estimate",
                                    "say figures between the points that were computed, with their errors");
  add_study_folder(*estimate, o);
  const auto named = [&](const char* flag, auto& values, const char* doc, const char* type) {
    return estimate->add_option(flag, values, doc)
        ->check(CLI::Validator(not_empty, "", "not empty"))
        ->type_name(type)
        ->allow_extra_args(false);
  };
  named("--at", o.study.at,
        "the place: every variable; those that are drawn all, or none for medians and bands over the draws; "
        "may be repeated, or with commas between",
        "NAME=VALUE")
      ->required();
  named("--figure", o.study.figures, "a figure of the table, may be repeated; else all but those of parts",
        "NAME");
}

void add_sensitivity_action(CLI::App& study, Options& o) {
  auto* action = add_study_action(
      study, o, "sensitivity", "say which variables figures follow from: Sobol indices, with their errors");
  add_study_folder(*action, o);
  const auto named = [&](const char* flag, auto& values, const char* doc, const char* type) {
    action->add_option(flag, values, doc)
        ->check(CLI::Validator(not_empty, "", "not empty"))
        ->type_name(type)
        ->allow_extra_args(false);
  };
  named("--figure", o.study.figures, "a figure of the table, may be repeated; else all but those of parts",
        "NAME");
  named("--at", o.study.at, "a variable that is held; may be repeated, or with commas between; else all vary",
        "NAME=VALUE");
  named("-o,--output", o.output, "draw the indices as bars", "FILE.svg");
}

void add_study_command(CLI::App& app, Options& o) {
  auto* study = app.add_subcommand("study", "solve one scene many times, with other values");
  study->require_subcommand(1);
  auto* plan = add_study_action(*study, o, "plan", "check a study file and write the manifest of its items");
  plan->add_option("STUDY", o.target, "study file (TOML)")->required();
  plan->add_option("-o,--output", o.output, "folder of the study; else its name with .study, in this folder")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FOLDER");
  add_plugin_options(*plan, o);
  auto* run = add_study_action(*study, o, "run", "compute the items that have no result yet");
  add_study_folder(*run, o);
  run->add_option("--items", o.study.items, "only these, such as 1-10 or 3,7; else all")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("A-B");
  run->add_option("--jobs", o.study.jobs, "items at a time; else as many as the machine has cores")
      ->check(CLI::Range(1, 4096));
  run->add_option("--threads", o.threads, "threads of the assembly of each; else one")
      ->check(CLI::Range(1, 1024));
  run->add_option("--plugins", o.plugins, "folder with plugins, searched before all others")
      ->type_name("DIR");
  auto* missing =
      add_study_action(*study, o, "missing", "print the numbers of the items that have no result yet");
  missing->add_option("FOLDER", o.target, "folder of a study that was planned")->required();
  auto* submit =
      add_study_action(*study, o, "submit", "write a script that lets an engine compute the items");
  add_study_folder(*submit, o);
  submit->add_option("--engine", o.study.engine, "GNU parallel, or a job array of Slurm")
      ->required()
      ->check(CLI::IsMember({"parallel", "slurm"}));
  submit->add_option("--chunk", o.study.chunk, "of Slurm: items of a task; else as many as take a minute")
      ->check(CLI::Range(1, 1000000));
  submit->add_option("--jobs", o.study.jobs, "of parallel: items at a time; else as many as there are cores")
      ->check(CLI::Range(1, 4096));
  submit->add_option("--plugins", o.plugins, "folder with plugins, searched before all others")
      ->type_name("DIR");
  add_study_folder(*add_study_action(*study, o, "collect", "put the results of all items into one table"), o);
  add_show_action(*study, o);
  add_estimate_action(*study, o);
  add_sensitivity_action(*study, o);
}

void add_calibrate_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "calibrate",
      "find what is not known of scenes out of what was measured, and predict what was held back");
  command->add_option("CALIBRATION", o.target, "calibration file (TOML)")->required();
  add_plugin_options(*command, o);
}

void add_import_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "import",
      "write a gear of another program as a scene; what cannot be carried over is said line by line");
  command
      ->add_option("FORMAT", o.kind,
                   "femnet: GEAR.don, with its mesh GEAR.mdg or without one; table: nodes and bars as "
                   "GEAR.csv; moordyn: a mooring")
      ->check(CLI::IsMember({"femnet", "table", "moordyn"}));
  auto* gear = command->add_option("GEAR", o.target, "file of the gear");
  command->add_flag("--divide", o.divides, "divide it into elements here, whatever mesh lies beside it");
  command->add_flag("--motion", o.moves,
                    "of FEMNET: the scene is the motion that its file describes, with waves and drums");
  command
      ->add_option("--mesh", o.mesh_file,
                   "file of its mesh; else the one of the same name beside it, if it is of this gear")
      ->excludes("--divide")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE");
  command
      ->add_option("-o,--output", o.output,
                   "scene; else the gear's name with .toml, in this folder. Its mesh is written beside it")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE.toml");
  command
      ->add_option(
          "--check", o.folder,
          "write nothing: say of all gears in a folder, and those below, what they need and how many convert")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER")
      ->excludes(gear);
  command->add_option("--color", o.color, "colour on standard error")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_test_command(CLI::App& app, Options& o) {
  auto* test = app.add_subcommand(
      "test", "check the elements, laws and solvers of a plugin: derivatives, balance, lanes, manners");
  test->add_option("PLUGIN", o.target, "plugin file (.so), plugin name or element type")->required();
  test->add_option("--seconds", o.seconds, "processor time for the checks of one component; else 60")
      ->check(between(0.001, 1e6));
  add_plugin_options(*test, o);
}

void add_out_of_core_option(CLI::App& command, Options& o) {
  command
      .add_option("--out-of-core", o.out_of_core,
                  "keep large factors in files there, where memory does not hold them")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER");
}

void add_run_command(CLI::App& app, Options& o) {
  auto* run = app.add_subcommand("run", "find the equilibrium of a scene and write it to a file");
  add_scene_options(*run, o);
  run->add_option("-o,--output", o.output, "result file; else the scene's name with .hdf, in this folder")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("FILE.hdf");
  run->add_flag("--resume", o.resume,
                "go on with a motion from the .part that a killed or interrupted run left");
  run->add_flag("--overwrite", o.overwrite, "replace the .part that such a run left, and all its outputs")
      ->excludes("--resume");
  run->add_option("--start-from", o.start_from, "begin the search where another result has the gear")
      ->check(CLI::Validator(not_empty, "", "not empty"))
      ->type_name("RESULT.hdf")
      ->excludes("--resume");
  run->add_flag("--stages", o.stages,
                "keep the start and the shape after every stage of the solve, for the slider of view");
  run->add_flag("--error", o.error,
                "print the errors of the results: of the solver and, over other meshes, of the mesh");
  run->add_option("--ranks-from", o.ranks_from,
                  "under mpirun: unknowns from which on all processes factorise together; else 100000")
      ->check(CLI::Range(std::int32_t{1}, std::numeric_limits<std::int32_t>::max()))
      ->type_name("UNKNOWNS");
  run->add_flag("--same-bits", o.same_bits,
                "under mpirun: results to the last bit, on any number of processes; takes more memory");
  add_out_of_core_option(*run, o);
}

void add_plan_command(CLI::App& app, Options& o) {
  auto* plan = app.add_subcommand("plan", "say what a scene needs, and why not the rest");
  add_scene_options(*plan, o);
  add_out_of_core_option(*plan, o);
}

void add_commands(CLI::App& app, Options& o) {
  add_run_command(app, o);
  add_plan_command(app, o);
  add_plugin_options(*app.add_subcommand("list", "list all elements and solvers"), o);
  auto* describe = app.add_subcommand(
      "describe", "parameters, terms and outputs of a component, or of the tables water, analysis and gear");
  describe->add_option("TYPE", o.target, "such as rope/bar, newton, water")->required();
  add_plugin_options(*describe, o);
  add_plugin_options(*app.add_subcommand("schema", "JSON schema of scene files, for editors"), o);
  add_test_command(app, o);
  add_author_commands(app, o);
  add_gear_commands(app, o);
  add_compare_command(app, o);
  add_diff_command(app, o);
  add_result_commands(app, o);
  add_refine_command(app, o);
  add_scope_command(app, o);
  add_import_command(app, o);
  add_stability_command(app, o);
  add_study_command(app, o);
  add_calibrate_command(app, o);
  app.require_subcommand(1);
}

int dispatch(const Options& o) {
  if (o.command == "run") return run_command(o);
  if (o.command == "plan") return plan_command(o);
  if (o.command == "list") return list_command(o);
  if (o.command == "describe") return describe_command(o);
  if (o.command == "schema") return schema_command(o);
  if (o.command == "compare") return compare_command(o);
  if (o.command == "diff") return diff_command(o);
  if (o.command == "refine") return refine_command(o);
  if (o.command == "scope") return scope_command(o);
  if (o.command == "stability") return stability_command(o);
  if (o.command == "study") return study_command(o);
  if (o.command == "calibrate") return calibrate_command(o);
  if (o.command == "new") return new_command(o);
  if (o.command == "reference") return reference_command(o);
  if (o.command == "catalogue") return catalogue_command(o);
  if (o.command == "check") return check_command(o);
  if (o.command == "draw") return draw_command(o);
  if (o.command == "report") return report_command(o);
  if (o.command == "view") return view_command(o);
  if (o.command == "export") return export_command(o);
  if (o.command == "import") return import_command(o);
  return test_command(o);
}

int fail(const Options& o, const std::string& message, int code) {
  std::fprintf(stderr, "netloft: %s\n", message.c_str());
  if (o.json) std::puts(error_json(message, code).c_str());
  return code;
}

bool solves(const Options& o) {
  constexpr std::array<const char*, 8> kSolving = {"run",       "compare", "refine",    "scope",
                                                   "stability", "study",   "calibrate", "test"};
  return std::find(kSolving.begin(), kSolving.end(), o.command) != kSolving.end();
}

int guarded(Options& o) {
  explain_crashes();
  if (const std::string lack = lack_of_memory(); solves(o) && !lack.empty()) return fail(o, lack, kOther);
  try {
    const auto ranks = start_ranks(o, launch_of_environment());
    o.ranks = ranks.get();
    put_large_blocks_into(o.out_of_core);
    return dispatch(o);
  } catch (const UsageError& e) {
    return fail(o, e.message, kWrongInput);
  } catch (const PluginRefused& e) {
    return fail(o, e.what(), kRefused);
  } catch (const std::bad_alloc&) {
    return fail(o, "not enough memory", kOther);
  } catch (const std::exception& e) {
    return fail(o, e.what(), kOther);
  }
}

/// Help and versions go to standard output and are no error.
int explain(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (app.exit(error) == 0) return kDone;
  if (std::find(words.begin(), words.end(), "--json") != words.end())
    std::puts(error_json(error.what(), kWrongInput).c_str());
  return kWrongInput;
}

/// A first word that is no command, or a second one that is none of the first's, as a sentence with the
/// command it may stand for; else empty. `before`: "study ".
std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before = "") {
  const auto commands = app.get_subcommands({});
  if (words.empty() || words[0].starts_with('-') || commands.empty()) return {};
  std::vector<std::string> names;
  for (const auto* command : commands) {
    names.push_back(command->get_name());
    if (names.back() == words[0]) return unknown_command(*command, words.subspan(1), words[0] + " ");
  }
  const auto near = nearest(words[0], names);
  return "there is no command \"" + before + words[0] +
         (near ? "\"; did you mean \"" + before + *near + "\"?"
               : "\"; `netloft " + before + "--help` lists them");
}

/// Of the command, and of one below it.
std::vector<std::string> given_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options())
      if (option->count() > 0) names.push_back(option->get_name());
    for (auto& name : given_options(*command)) names.push_back(std::move(name));
  }
  return names;
}

/// A file that is opened must not become a stream that was closed: what is printed would land in it. Nor is a
/// limit on the size of files a reason to die without a word.
void guard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// What was printed has to arrive.
int after_printing(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return code;
  std::fprintf(stderr, "netloft: standard output cannot be written: %s\n", std::strerror(errno));
  return code == kDone ? kOther : code;
}

constexpr const char* kDescription = "Netloft finds the shape and the forces of trawl gears.";

/// A rank other than 0. Where the command line is none of a `run`, rank 0 says so.
int serve(int argc, char** argv, const Launch& launch) {
  Options o;
  CLI::App app{kDescription, "netloft"};
  add_commands(app, o);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return kDone;
  }
  if (app.get_subcommands().front()->get_name() != "run") return kDone;
  try {
    put_large_blocks_into(o.out_of_core);
  } catch (const std::runtime_error& e) {
    return fail(o, e.what(), kOther);
  }
  serve_ranks(launch);
  return kDone;
}

int start(int argc, char** argv) {
  Options o;
  o.words.assign(argv, argv + argc);
  CLI::App app{kDescription, "netloft"};
  app.set_version_flag("--version", std::string("netloft " NETLOFT_VERSION));
  add_commands(app, o);
  if (argc == 1) {
    std::fputs(app.help().c_str(), stdout);
    return kDone;
  }
  if (const std::string fault = unknown_command(app, std::span(o.words).subspan(1)); !fault.empty()) {
    o.json = std::find(o.words.begin(), o.words.end(), "--json") != o.words.end();
    return fail(o, fault, kWrongInput);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return explain(app, e, o.words);
  }
  o.command = app.get_subcommands().front()->get_name();
  o.given = given_options(app);
  return guarded(o);
}

}  // namespace
}  // namespace netloft::io

int main(int argc, char** argv) {
  netloft::io::guard_streams();
  if (const auto launch = netloft::launch_of_environment(); launch.rank > 0)
    return netloft::io::serve(argc, argv, launch);
  return netloft::io::after_printing(netloft::io::start(argc, argv));
}
