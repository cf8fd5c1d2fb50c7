// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that hold solvers, strategies and integrators against each other.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

/// Methods are compared in the order in which they are typed, whatever their kinds.
void add_method_option(CLI::App& command, CompareOptions& c, const std::string& name, const std::string& word,
                       const std::string& doc) {
  const auto keep = [&c, word](const std::vector<std::string>& all) {
    for (const auto& one : all) c.methods.push_back(word + one);
  };
  auto* option = command.add_option_function<std::vector<std::string>>(name, keep, doc + "; may be repeated");
  as_words(option->trigger_on_parse(), kMethod);
}

}  // namespace

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
  as_word(command->add_option("--cells", c.cells,
                              "meshes for the discretisation error: cells across, or of one part"),
          "[PART=]N,N,…");
  command
      ->add_option("--reference", c.reference,
                   "solver or integrator that errors are measured against; else another one")
      ->type_name(kMethod);
  command->add_option("--repeats", c.repeats, "runs of each, of which the cheapest counts; else 3")
      ->check(CLI::Range(1, 1000));
  command->add_option("--csv", c.csv, "write the tables as comma-separated values")->type_name("FILE.csv");
  command->add_option("--plot", c.plot, "draw work over precision")->type_name("FILE.svg|FILE.html");
}

}  // namespace netloft::program
