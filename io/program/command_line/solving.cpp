// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that solve a scene, once or on several meshes or at several depths.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

void add_run_command(CLI::App& app, Options& o) {
  auto* run = app.add_subcommand("run", "find the equilibrium of a scene and write it to a file");
  add_scene_options(*run, o);
  as_word(run->add_option("-o,--output", o.output,
                          "result file; else the scene's name with .hdf, in this folder"),
          "FILE.hdf");
  run->add_flag("--resume", o.resume,
                "go on with a motion from the .part that a killed or interrupted run left");
  run->add_flag("--overwrite", o.overwrite, "replace the .part that such a run left, and all its outputs")
      ->excludes("--resume");
  as_word(run->add_option("--start-from", o.start_from, "begin the search where another result has the gear"),
          "RESULT.hdf")
      ->excludes("--resume");
  run->add_flag("--stages", o.stages,
                "keep the start and the shape after every stage of the solve, for the slider of view");
  run->add_flag("--error", o.error,
                "print the errors of the results: of the solver and, over other meshes, of the mesh");
}

void add_plan_command(CLI::App& app, Options& o) {
  add_scene_options(*app.add_subcommand("plan", "say what a scene needs, and why not the rest"), o);
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
  as_word(command->add_option("--cells", o.compare.cells, "of other scenes: cells across, or of one part"),
          "[PART=]N,N,…");
}

void add_scope_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "scope", "find the lengths of warp, over depths, with which boards stand as they ought to");
  add_scene_options(*command, o);
  const auto range = [&](const char* flag, std::string& value, const char* doc, const char* type) {
    return as_word(command->add_option(flag, value, doc), type);
  };
  range("--depth", o.scope.depth, "depths [m]; else 7 of them", "LO:HI[:N]")->required();
  range("--warp", o.scope.warp, "lengths of warp over the depth; else 2:5:13", "LO:HI[:N]");
  range("--heel", o.scope.heel, "heel of the boards [deg], outward; else -5:5", "LO:HI");
  range("--spread", o.scope.spread, "spread of the boards [m]; else any", "LO:HI");
  range("-o,--output", o.output, "draw the lengths over the depth", "FILE.svg|FILE.html");
}

}  // namespace netloft::program
