// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that solve one scene, or report what the scene needs.
#include "io/program/commands/scenes.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

void add_run_command(CLI::App& app, Chosen& chosen) {
  auto [run, o] =
      add_command(app, chosen, "run", "find the equilibrium or the motion of a scene and write it to a file",
                  run_command);
  add_method_options(run, o);
  o.words = chosen.words;
  as_word(run.add_option("-o,--output", o.output,
                         "result file; default: the scene's name with .hdf, in this folder"),
          "FILE.hdf");
  run.add_flag("--resume", o.resume,
               "continue a motion from the .part file that a killed or interrupted run left");
  run.add_flag("--overwrite", o.overwrite,
               "replace the .part file that such a run left, with all its outputs")
      ->excludes("--resume");
  as_word(run.add_option("--start-from", o.start_from,
                         "begin the search from the shape of the gear in another result"),
          "FILE.hdf")
      ->excludes("--resume");
  run.add_flag("--stages", o.stages,
               "keep the start and the shape after every stage of the solve, for the slider of view");
  run.add_flag("--error", o.error,
               "print the errors of the results: that of the solver, and that of the mesh, which needs "
               "solves on other meshes");
  run.add_flag("--sensitivities", o.sensitivities,
               "print the numbers of the scene that each key figure depends on most, by their derivatives");
}

Command<DesignOptions> add_design_command(CLI::App& app, Chosen& chosen, const char* name, const char* doc,
                                          int (*run)(const DesignOptions&)) {
  auto [design, o] = add_command(app, chosen, name, doc, run);
  design
      .add_option("GEAR_OR_SCENE", o.scene,
                  "net plan or scene; a file of the library is opened as a copy that can be changed")
      ->required()
      ->type_name("FILE.toml");
  as_word(
      design.add_option("--beside", o.beside,
                        "another gear, scene or result, which is shown beside this one and compared with it"),
      "FILE");
  design.add_option("--port", o.port, "port of 127.0.0.1; default: any free one")
      ->check(CLI::Range(1, 65535));
  design.add_flag("--as-solver", o.as_solver)->group("");  // for the process that a design starts itself
  add_opening_options(design, o);
  return {design, o};
}

}  // namespace

void add_scene_commands(CLI::App& app, Chosen& chosen) {
  add_run_command(app, chosen);
  auto [plan, o] =
      add_command(app, chosen, "plan",
                  "print which forces and plugins a scene uses, and why others are left out", plan_command);
  add_method_options(plan, o);
  auto [design, d] = add_design_command(
      app, chosen, "design", "open a gear on a local page that shows its new shape while you change it",
      design_command);
  design.add_flag("--no-browser", d.no_browser, "only print the address, and open no browser");
  add_design_command(app, chosen, "serve",
                     "offer the same to other programs, by requests in JSON, until it is interrupted",
                     serve_command);
}

}  // namespace netloft::program
