// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/options.hpp"

#include "io/program/command_line/shared.hpp"

#include <limits>

namespace netloft::hard_cases {

namespace {

void add_columns(CLI::App& app, SuiteOptions& s) {
  program::as_words(
      app.add_option("--strategy", s.strategies, "strategy; may be repeated and combined with --solver"),
      program::kMethod);
  program::as_words(
      app.add_option("--without", s.without, "leave out an attempt of the strategy auto; may be repeated"),
      "PART");
  program::add_set_option(app, s.set, "a value of every scene: analysis.newton.damping=0.1");
  program::as_words(
      app.add_option("--solver", s.solvers, "solver, written as for netloft run; may be repeated"),
      program::kMethod);
}

void add_cases(CLI::App& app, SuiteOptions& s) {
  app.add_option("--size", s.sizes, "sizes of about 200, 800 and 12000 unknowns; default: small,medium")
      ->check(CLI::IsMember({"small", "medium", "large"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--case", s.pattern, "only cases whose name contains this")->type_name("TEXT");
  app.add_option(
         "--flow", s.flow,
         "only nets in a current: on, in water that they slow; off, the same cases in undisturbed water")
      ->check(CLI::IsMember({"on", "off"}));
  app.add_option("--seed", s.seed, "seed of the random numbers: another one changes all random cases")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
}

void add_budgets(CLI::App& app, SuiteOptions& s) {
  app.add_option("--seconds-per-case", s.seconds, "else 10, and 60 of large ones")
      ->check(program::numbers_between(0.001, 1e6));
  app.add_option("--work", s.work,
                 "limit for one case, in iterations of Newton's method for its scene; default: none")
      ->check(program::numbers_between(1.0, 1e9));
}

}  // namespace

void add_options(CLI::App& app, SuiteOptions& s) {
  app.add_option("SUITE", s.suite, "folder of the suite; default: tests/stability in this folder");
  add_columns(app, s);
  add_cases(app, s);
  add_budgets(app, s);
  app.add_option("-o,--output", s.output, "write the matrix as a page")->type_name("FILE.html");
  app.add_flag("--update-references", s.update_references, "store the best answers in the suite");
  app.add_option("--threads", s.threads, "threads of the assembly; default: one")->check(CLI::Range(1, 1024));
  program::add_plugin_options(app, s);
}

}  // namespace netloft::hard_cases
