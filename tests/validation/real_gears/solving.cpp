// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/solving.hpp"
#include "framework/motion/time_march.hpp"
#include "tests/folders.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace netloft::real_gears {

Registry& plugins() {
  Registry& registry = test::shipped_plugins();
  [[maybe_unused]] static const PluginContent& femnet =
      registry.add_file(test::build_folder() + "/tests/validation/plugins/femnet.so");
  return registry;
}

namespace {

/// Normal deviates by the method of Box and Muller, which are the same with every standard library.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}
  double operator()() {
    const double r = std::sqrt(-2 * std::log(uniform()));
    return r * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 random_;
};

void add_noise(Scene& scene, const Start& start) {
  Noise noise(start.seed);
  for (std::size_t i = 0; i < scene.positions.size(); ++i)
    if (!(scene.held[i / 3] >> (i % 3) & 1)) scene.positions[i] += start.noise * noise();
}

double energy_at(Assembler& assembler, const std::vector<Vector>& positions) {
  double energy = 0;
  const bool found = assembler.evaluate(over_dofs(assembler, positions), {.energy = &energy});
  return found ? energy : std::nan("");
}

Scene scene_of(const NeutralCase& gear, const Modelling& modelling, const Start& start) {
  Scene scene = make_scene(gear, modelling);
  if (start.at_reference) place_nodes(scene, gear.reference.positions);
  if (start.noise > 0) add_noise(scene, start);
  return scene;
}

void compare(SolvedGear& s, const NeutralCase& gear) {
  const Solution& solution = s.solved.solution;
  s.positions = nodal(gear, *s.solved.assembler, solution.x);
  s.out_of_balance = out_of_balance(gear, *s.solved.assembler, solution.residual);
  s.furthest = furthest(s.positions, gear.reference.positions);
  s.branches = branches(gear, s.positions);
  s.energy_above_reference =
      energy_at(*s.solved.assembler, s.positions) - energy_at(*s.solved.assembler, gear.reference.positions);
  s.largest_tension = largest_tension(gear, s.positions);
}

}  // namespace

SolvedGear solve(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                 const test::Solving& how) {
  plugins();
  Scene scene = scene_of(gear, modelling, start);
  const double begun = cpu_seconds();
  SolvedGear s{test::solve(std::move(scene), how), {}, {}, {}, {}};
  s.cpu_seconds = cpu_seconds() - begun;
  compare(s, gear);
  return s;
}

std::vector<Vector> follow_motion(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                                  double duration) {
  const IntegratorType& integrator = plugins().integrator("generalized-alpha");
  const SolverType& newton = plugins().solver("newton");
  const Scene scene = scene_of(gear, modelling, start);
  const ScenePlan plan = make_scene_plan(scene, plugins(), TangentChoice::exact, AnalysisKind::dynamics);
  Assembler assembler(scene, plan, 1);
  std::vector<std::string> faults;  // must remain empty: all parameters keep their values
  const ParameterBlock scheme(integrator.parameters, integrator.integrator.parameter_bytes, {}, faults);
  const ParameterBlock steps(newton.parameters, newton.solver.parameter_bytes, {}, faults);
  std::vector<double> x;
  const MarchWatch watch{.on_output = [&](const Snapshot& now) { x.assign(now.x.begin(), now.x.end()); }};
  const MarchResult end =
      march({scene, assembler, make_factorisation}, {{&integrator, scheme.data()}, {&newton, steps.data()}},
            {}, {.duration = duration}, watch);
  if (end.status != MarchStatus::finished) throw std::runtime_error(end.reason);
  return nodal(gear, assembler, x);
}

SolvedGear solve_by_strategy(const NeutralCase& gear, const Modelling& modelling, const Start& start,
                             const test::Solving& how) {
  test::Solving by_strategy = how;
  if (by_strategy.strategy.empty()) by_strategy.strategy = "auto";
  return solve(gear, modelling, start, by_strategy);
}

}  // namespace netloft::real_gears
