// SPDX-License-Identifier: BSD-3-Clause
//
// bench_real_gears FOLDER: solves the gears of the folder and prints a table of the work and the distance
// from FEMNET's answer. With --perturbed 30, it also prints how often the default strategy converges from 30
// perturbed drawings. --help lists all options.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "framework/search/search.hpp"
#include "tests/validation/real_gears/perturbed.hpp"

namespace {

using namespace netloft;
using namespace netloft::real_gears;

struct Wish {
  std::filesystem::path folder;
  std::string gear;
  Modelling modelling;
  Start start;
  test::Solving how{{}, {.tolerance = 1e-9}};
  std::vector<std::string> settings;
  bool history = false;
  PerturbedDrawings drawings{.count = 0};
  int repeats = 1;
};

/// Sets parameters of a solver or a strategy, such as "newton:damping=0.1" or
/// "tension/stages:turn=0.5,fall=0.2".
void set(test::Solving& how, const std::string& setting) {
  const auto colon = setting.find(':');
  if (colon == std::string::npos) throw std::invalid_argument("--set " + setting + ": write NAME:key=value");
  const std::string name = setting.substr(0, colon), text = setting.substr(colon + 1);
  const auto set_of = [&](const auto& type, const std::string& used, Values& parameters) {
    how.given[type.type] = parse_parameters(type.parameters, text);
    if (name == used) parameters = how.given[type.type];
  };
  if (plugins().plugin(name.substr(0, name.find('/'))).strategies.empty())
    set_of(plugins().solver(name), how.solver, how.solver_parameters);
  else
    set_of(plugins().strategy(name), how.strategy, how.strategy_parameters);
}

void describe(CLI::App& app, Wish& wish) {
  app.add_option("folder", wish.folder, "where the files of the gears are")->required();
  app.add_option("--gear", wish.gear, "part of the name of those that are wanted");
  app.add_option("--solver", wish.how.solver, "plugin, or plugin/name")->capture_default_str();
  app.add_option("--set", wish.settings, "NAME:key=value,… of a solver or a strategy; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--tolerance", wish.how.limits.tolerance, "largest residual over largest load")
      ->capture_default_str();
  app.add_option("--iterations", wish.how.limits.iterations, "limit")->capture_default_str();
  app.add_option("--seconds", wish.how.limits.seconds, "limit, per gear");
  app.add_flag("!--no-surface", wish.modelling.surface, "water everywhere, above z = 0, too");
  app.add_flag("--shipped-bending", wish.modelling.shipped_bending, "rope/bending instead of FEMNET's");
  app.add_flag("--from-reference", wish.start.at_reference,
               "start from FEMNET's answer, not from the drawing");
  app.add_option("--noise", wish.start.noise, "shake the start by so much [m]");
  app.add_option("--seed", wish.start.seed, "of the noise");
  app.add_option("--strategy", wish.how.strategy,
                 "auto, tension/stages, …; else the solver alone, of perturbed drawings auto");
  app.add_option("--perturbed", wish.drawings.count,
                 "instead: from the drawing and so many, perturbed by 1 mm to 0.3 m")
      ->check(CLI::PositiveNumber);
  app.add_option("--repeat", wish.repeats, "solve so often and show the time of the fastest")
      ->check(CLI::PositiveNumber);
  app.add_flag("--history", wish.history, "print every iteration");
}

void print_history(const Solution& solution) {
  std::printf("    iteration  residual N      load N        energy J  factors  seconds\n");
  for (const auto& i : solution.run.history)
    std::printf("    %9d  %10.3e  %10.3e  %14.7e  %7d  %7.3f  %s\n", i.iteration, i.residual, i.scale,
                i.energy, i.factorisations, i.seconds, i.note);
}

void print_row(const NeutralCase& gear, const SolvedGear& s) {
  const Solution& n = s.solved.solution;
  std::printf("%-18s %5zu %8zu %5d %7d %8.5f %7.1fx %9.2e %9.2e  %s\n", gear.name.c_str(), gear.nodes.size(),
              s.solved.plan.unknowns, n.cost.statistics.iterations, n.cost.statistics.factorisations,
              s.cpu_seconds, gear.femnet.cpu_seconds / s.cpu_seconds, s.furthest.distance,
              s.residual_over_tension(), name_of(n.status));
}

void print_stages(const SolvedGear& s) {
  for (const StageRecord& stage : s.solved.solution.cost.stages)
    std::printf("    %-34s %3d factorisations, %.4f s, %s\n", stage.name.c_str(),
                stage.statistics.factorisations, stage.statistics.total_cpu_seconds, name_of(stage.status));
}

/// Prints the ten nodes that are furthest from their positions in the reference.
void print_strays(const NeutralCase& gear, const SolvedGear& s) {
  const auto away = [&](std::uint32_t n) { return distance(s.positions[n], gear.reference.positions[n]); };
  std::vector<std::uint32_t> strays;
  for (std::uint32_t n = 0; n < gear.nodes.size(); ++n)
    if (away(n) > 1e-3) strays.push_back(n);
  std::sort(strays.begin(), strays.end(), [&](auto a, auto b) { return away(a) > away(b); });
  std::printf("    %zu nodes are further than 1 mm from the reference\n", strays.size());
  strays.resize(std::min<std::size_t>(strays.size(), 10));
  for (const auto n : strays) {
    const Vector &x = s.positions[n], &r = gear.reference.positions[n];
    std::printf("    node %3u at %9.4f %9.4f %9.4f, reference %9.4f %9.4f %9.4f\n", n, x[0], x[1], x[2], r[0],
                r[1], r[2]);
  }
}

void print_ending(const NeutralCase& gear, const SolvedGear& s) {
  const Branches &b = s.branches, r = branches(gear, gear.reference.positions);
  std::printf("    %s\n    furthest: node %u, out of balance: mean %.2e N, largest component %.2e N\n",
              s.solved.solution.reason.c_str(), s.furthest.node, s.out_of_balance.mean,
              s.out_of_balance.largest_component);
  std::printf("    here (reference): bars slack %d (%d), pressed %d (%d); twines slack %d (%d); ",
              b.slack_bars, r.slack_bars, b.pressed_bars, r.pressed_bars, b.slack_twines, r.slack_twines);
  std::printf("nodes dry %d (%d), on the bed %d (%d)\n", b.dry_nodes, r.dry_nodes, b.nodes_on_bed,
              r.nodes_on_bed);
  std::printf("    energy %.6g J above that of the reference\n", s.energy_above_reference);
  print_strays(gear, s);
}

/// Solves several times with the same result, and returns the solve that took the least time.
SolvedGear solve_repeatedly(const NeutralCase& gear, const Wish& wish) {
  const auto solve_once = [&] { return solve(gear, wish.modelling, wish.start, wish.how); };
  SolvedGear fastest = solve_once();
  for (int i = 1; i < wish.repeats; ++i)
    if (SolvedGear s = solve_once(); s.cpu_seconds < fastest.cpu_seconds) fastest = std::move(s);
  return fastest;
}

std::vector<NeutralCase> wanted_gears(const Wish& wish) {
  std::vector<NeutralCase> gears;
  for (const auto& file : neutral_files(wish.folder))
    if (NeutralCase gear = read_neutral_case(file); gear.name.find(wish.gear) != std::string::npos)
      gears.push_back(std::move(gear));
  return gears;
}

int run_perturbed(const Wish& wish) {
  PerturbedDrawings drawings = wish.drawings;
  drawings.seed = wish.start.seed;
  std::printf("gear               converged  factorisations: median  95 %%\n");
  for (const NeutralCase& gear : wanted_gears(wish)) {
    const Reliability r = solve_perturbed(gear, wish.modelling, drawings, wish.how);
    std::printf("%-18s %3zu of %-3zu %22d %5d\n", gear.name.c_str(), r.converged, r.runs, r.median,
                r.most_of_them);
  }
  return 0;
}

int run(const Wish& wish) {
  std::printf(
      "gear               nodes unknowns iters factors    CPU s  FEMNET  distance m res/tens  outcome\n");
  for (const NeutralCase& gear : wanted_gears(wish)) {
    const SolvedGear s = solve_repeatedly(gear, wish);
    print_row(gear, s);
    print_stages(s);
    if (s.solved.solution.status != SolveStatus::converged || s.furthest.distance > 1e-3)
      print_ending(gear, s);
    if (wish.history) print_history(s.solved.solution);
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  Wish wish;
  CLI::App app(
      "Solves gears that FEMNET has solved, and prints what it took and how far from there it ended");
  describe(app, wish);
  CLI11_PARSE(app, count, arguments);
  try {
    for (const auto& setting : wish.settings) set(wish.how, setting);
    return wish.drawings.count > 0 ? run_perturbed(wish) : run(wish);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_real_gears: %s\n", error.what());
    return 2;
  }
}
