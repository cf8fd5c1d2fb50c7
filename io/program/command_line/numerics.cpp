// SPDX-License-Identifier: BSD-3-Clause
//
// Commands about the numerics of a scene: comparison of methods, and mesh refinement.
#include "io/program/commands/numerics.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

/// Adds an option for compared methods. They are compared in the order on the command line, even if solvers
/// and strategies alternate.
void add_compared_method(CLI::App& command, CompareOptions& o, const std::string& name,
                         const std::string& word, const std::string& doc) {
  const auto keep = [&o, word](const std::vector<std::string>& all) {
    for (const auto& one : all) o.methods.push_back(word + one);
  };
  auto* option = command.add_option_function<std::vector<std::string>>(name, keep, doc + "; may be repeated");
  as_words(option->trigger_on_parse(), kMethod);
}

void add_compare_command(CLI::App& app, Chosen& chosen) {
  auto [command, o] =
      add_command(app, chosen, "compare",
                  "compare time and error of several solvers or integrators on one scene", compare_command);
  add_scene_options(command, o);
  command.add_option("--accuracy", o.accuracy, "accuracies of motions, one per decade; default: 1e-3:1e-1")
      ->type_name("LO:HI");
  add_compared_method(command, o, "--integrator", "integrator ",
                      "an integrator to compare on a scene that moves, such as newmark");
  add_compared_method(command, o, "--strategy", "strategy ",
                      "a strategy to compare, written as for netloft run");
  add_compared_method(command, o, "--solver", "", "a solver to compare, written as for netloft run");
  command.add_option("--tolerance", o.tolerance, "tolerances, one per decade; default: 1e-10:1e-2")
      ->type_name("LO:HI");
  as_word(
      command.add_option("--cells", o.cells,
                         "meshes for the discretisation error: cells across the scene, or cells of one part"),
      "[PART=]N,N,…");
  command
      .add_option(
          "--reference", o.reference,
          "solver or integrator whose answer counts as exact; default: another one than the compared method")
      ->type_name(kMethod);
  command.add_option("--repeats", o.repeats, "number of runs of each method; the fastest counts; default: 3")
      ->check(CLI::Range(1, 1000));
  as_words(command.add_option("-o,--output", o.outputs,
                              "a picture of work over precision, or the tables as .csv; may be repeated"),
           "FILE.svg|FILE.html|FILE.csv");
}

void add_refine_command(CLI::App& app, Chosen& chosen) {
  auto [command, o] =
      add_command(app, chosen, "refine",
                  "solve a scene on finer and finer meshes, and extrapolate its results", refine_command);
  add_method_options(command, o);
  command.add_option("--nodes", o.nodes, "for a gear: numbers of nodes; default: 500,2000,8000,30000")
      ->check(CLI::Range(std::int64_t{10}, std::int64_t{10'000'000}))
      ->delimiter(',')
      ->type_name("N,N,…")
      ->allow_extra_args(false);
  as_word(command.add_option("--cells", o.cells,
                             "for other scenes: cells across the scene, or cells of one part"),
          "[PART=]N,N,…");
}

}  // namespace

void add_numeric_commands(CLI::App& app, Chosen& chosen) {
  add_refine_command(app, chosen);
  add_compare_command(app, chosen);
}

}  // namespace netloft::program
