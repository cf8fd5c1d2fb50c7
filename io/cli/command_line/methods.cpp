// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that hold solvers, strategies and integrators against each other.
#include "io/cli/command_line/groups.hpp"
#include "io/cli/command_line/shared.hpp"

#include <limits>

namespace netloft::io {

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

void add_stability_command(CLI::App& app, Options& o) {
  StabilityOptions& s = o.stability;
  auto* command = app.add_subcommand(
      "stability", "run strategies and solvers on the suite of hard cases, and print how they did");
  command->add_option("SUITE", s.suite,
                      "folder of the suite; else tests/stability here, or the installed one");
  as_words(
      command->add_option("--strategy", s.strategies, "strategy; may be repeated, and stand beside solvers"),
      kMethod);
  as_words(command->add_option("--without", s.without,
                               "leave out an attempt of the strategy auto; may be repeated"),
           "PART");
  add_set_option(*command, o, "a value of every scene: analysis.newton.damping=0.1");
  as_words(command->add_option("--solver", s.solvers, "solver, as run takes it; may be repeated"), kMethod);
  command->add_option("--size", s.sizes, "about 200, 800 and 12000 unknowns; else small,medium")
      ->check(CLI::IsMember({"small", "medium", "large"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--case", s.pattern, "only cases whose name contains this")->type_name("TEXT");
  command->add_option("--draw", s.draw, "number of the draw: another one changes all drawn cases")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  command->add_option("--seconds-per-case", s.seconds, "else 10, and 60 of large ones")
      ->check(numbers_between(0.001, 1e6));
  command
      ->add_option("--work", s.work, "for one case, in iterations of Newton's method for its scene; else any")
      ->check(numbers_between(1.0, 1e9));
  command->add_option("--html", s.html, "write the matrix as a page")->type_name("FILE.html");
  command->add_flag("--update-references", s.update_references, "keep the best answers found in the suite");
  command->add_option("--threads", o.threads, "threads of the assembly; else one")
      ->check(CLI::Range(1, 1024));
  add_plugin_options(*command, o);
}

}  // namespace netloft::io
