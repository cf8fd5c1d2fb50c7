// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/dynamics.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/scenes/reading/parameter_reader.hpp"

#include <algorithm>
#include <array>

namespace netloft::scenes {

namespace {

struct DynamicsKeys {
  const char *integrator = nullptr, *start = nullptr;
  double duration = 0, step = 0, longest_step = 0, shortest_step = 0, accuracy = 0, output_interval = 0;
  double mass_damping = 0, stiffness_damping = 0;
  bool adaptive = false, dense = false, energy_budget = false, material_damping = false, check = false;
};

ParameterTable<DynamicsKeys> make_table() {
  using K = DynamicsKeys;
  ParameterTable<K> t;
  t.text("integrator", &K::integrator, "time integrator plugin; a table of its name has its parameters",
         "generalized-alpha");
  t.text("start", &K::start,
         "initial state, at rest: sketch, equilibrium, or a result file such as found.hdf", "sketch");
  t.real("duration", &K::duration, "s", "simulated time", {.lo = 1e-9, .hi = 1e9, .fallback = 10});
  t.boolean("adaptive", &K::adaptive,
            "step lengths follow from the accuracy; otherwise all steps are step long", true);
  t.real("step", &K::step, "s", "first step, or every step if not adaptive; 0: chosen if adaptive",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  t.real("accuracy", &K::accuracy, "1",
         "allowed error of the path, as a fraction of the longest element; from 1e-2 on, the allowed error "
         "of one step",
         {.lo = 1e-12, .hi = 1, .fallback = 1e-2});
  t.boolean("check", &K::check,
            "run the motion a second time with steps twice as long to measure the error of the path; exit "
            "code 3 if it exceeds the accuracy",
            false);
  t.real("longest_step", &K::longest_step, "s", "longest step", {.lo = 1e-9, .hi = 1e9, .fallback = 1e9});
  t.real("shortest_step", &K::shortest_step, "s",
         "shortest step; the run stops if a shorter one would be needed",
         {.lo = 1e-15, .hi = 1, .fallback = 1e-9});
  t.real("output_interval", &K::output_interval, "s",
         "time between outputs; 0: only the beginning and the end", {.lo = 0, .hi = 1e9, .fallback = 0.1});
  t.boolean("dense", &K::dense, "interpolate outputs between steps; otherwise steps end at them", false);
  t.boolean("energy_budget", &K::energy_budget, "compute the energy budget", true);
  t.boolean(
      "material_damping", &K::material_damping,
      "use the loss factors of twines, ropes and wires, unless stability limits the steps of the integrator",
      true);
  t.real("mass_damping", &K::mass_damping, "1/s", "artificial damping c: adds the force -c m v to every node",
         {.lo = 0, .hi = 1e9, .fallback = 0});
  t.real("stiffness_damping", &K::stiffness_damping, "s",
         "damping of stretch for parts without damping of their own: tension per strain rate, divided by EA",
         {.lo = 0, .hi = 1e9, .fallback = 0});
  return t;
}

constexpr formats::Range kTimeRange{-1e9, 1e9, false, false};

std::vector<double> read_times(formats::TableReader& table) {
  const auto t = table.reals("t", {.unit = "s", .doc = "times", .range = kTimeRange, .count = {.least = 1}});
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1])) {
      table.error("t", "does not ascend: each time must be later than the one before");
      break;
    }
  return t;
}

/// Reads the columns x, y, z with `count` values each; an absent column is zero.
std::vector<Course::Point> read_columns(formats::TableReader& table, const char* unit, const char* doc,
                                        formats::Range range, std::size_t count) {
  std::vector<Course::Point> points(count, Course::Point{});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string key(1, "xyz"[axis]);
    if (!table.has(key)) continue;
    const auto column =
        table.reals(key, {.unit = unit, .doc = doc, .range = range, .count = formats::exactly(count)});
    for (std::size_t i = 0; i < std::min(count, column.size()); ++i) points[i][axis] = column[i];
  }
  return points;
}

/// Limits the slope of a cubic at a point, so that the curve stays between neighbouring points (F. N. Fritsch
/// and R. E. Carlson, SIAM J. Numer. Anal. 17, 1980). `before` and `after` are the slopes of the secants to
/// the neighbouring points. The result is at most three times the smaller of these two slopes, and zero if
/// their signs differ or one of them is zero.
double limited(double slope, double before, double after) {
  if (!(before * after > 0)) return 0;
  const double most = 3 * std::min(std::abs(before), std::abs(after));
  return std::clamp(slope, -most, most);
}

/// A smooth motion through the displacements d at the times t, cubic between these times. The velocity at a
/// point is the mean slope to its two neighbours, limited by limited(), and zero at the first and last point.
Course through(const std::vector<double>& t, const std::vector<Course::Point>& d) {
  Course course;
  for (std::size_t i = 0; i < t.size(); ++i) {
    Course::Knot knot{t[i], d[i], {}};
    if (i > 0 && i + 1 < t.size())
      for (std::size_t k = 0; k < 3; ++k)
        knot.v[k] =
            limited((d[i + 1][k] - d[i - 1][k]) / (t[i + 1] - t[i - 1]),
                    (d[i][k] - d[i - 1][k]) / (t[i] - t[i - 1]), (d[i + 1][k] - d[i][k]) / (t[i + 1] - t[i]));
    course.knots.push_back(knot);
  }
  return course;
}

/// The motion with velocities v at the times t, linear between these times. The displacement is zero at time
/// zero.
Course gone(const std::vector<double>& t, const std::vector<Course::Point>& v) {
  Course course;
  for (std::size_t i = 0; i < t.size(); ++i) {
    Course::Knot knot{t[i], {}, v[i]};
    for (std::size_t k = 0; k < 3 && i > 0; ++k)
      knot.d[k] = course.knots[i - 1].d[k] + 0.5 * (v[i][k] + v[i - 1][k]) * (t[i] - t[i - 1]);
    course.knots.push_back(knot);
  }
  const Course::Point at_zero = course.at(0).d;
  for (auto& knot : course.knots)
    for (std::size_t k = 0; k < 3; ++k) knot.d[k] -= at_zero[k];
  return course;
}

}  // namespace

std::span<const netloft_parameter> dynamics_keys() {
  static const auto table = make_table();
  return table.rows();
}

namespace {

const std::string kSketch = "sketch", kEquilibrium = "equilibrium";

/// Reads `start`: sketch, equilibrium, or the name of a result file.
void read_start(const std::string& start, formats::TableReader& analysis, Dynamics& d) {
  d.from_equilibrium = start == kEquilibrium;
  if (d.from_equilibrium || start == kSketch) return;
  if (analysis.has("start") && analysis.kind("start") != formats::Kind::text) return;  // reported already
  if (std::filesystem::path(start).extension() == ".hdf") {
    d.start_file = start;
    return;
  }
  const auto near = nearest(start, std::array{kSketch, kEquilibrium});
  analysis.error(
      "start",
      "\"" + start +
          "\" is no shape from which a motion can start; allowed: sketch, equilibrium, the name of a result",
      near ? "did you mean \"" + *near + "\"?" : "the name of a result ends in .hdf");
}

}  // namespace

Dynamics read_dynamics(formats::TableReader& analysis, Registry& registry) {
  const int errors_before = analysis.diagnostics().errors();
  const Values values = read_parameters(dynamics_keys(), analysis);
  std::vector<std::string> faults;
  const ParameterBlock block(dynamics_keys(), sizeof(DynamicsKeys), values, faults);
  if (!faults.empty()) return {};
  const auto& k = *static_cast<const DynamicsKeys*>(block.data());
  Dynamics d;
  d.integrator = k.integrator;
  read_start(k.start, analysis, d);
  d.march.duration = k.duration;
  d.march.step = k.step;
  d.march.adaptive = k.adaptive;
  d.march.accuracy = k.accuracy;
  d.march.longest_step = k.longest_step;
  d.march.shortest_step = k.shortest_step;
  d.march.output_interval = k.output_interval;
  d.march.check = k.check;
  d.march.dense = k.dense;
  d.march.budget = k.energy_budget;
  d.march.mass_damping = k.mass_damping;
  d.stiffness_damping = k.stiffness_damping;
  d.material_damping = k.material_damping;
  const IntegratorType& type = registry.integrator(d.integrator);
  if (analysis.diagnostics().errors() > errors_before)
    return d;  // else the checks below would report these errors again
  if (k.shortest_step > k.longest_step)
    analysis.error("shortest_step", "is longer than longest_step, so that no step is allowed");
  if (k.adaptive && k.step > k.longest_step)
    analysis.error("step", "is longer than longest_step", "adaptive = false makes all steps as long as step");
  if (k.adaptive && k.step > 0 && k.step < k.shortest_step)
    analysis.error("step", "is shorter than shortest_step",
                   "step = 0 lets the program choose the first step");
  if (!k.adaptive && k.step == 0 && !type.is_explicit())
    analysis.error("step", "is 0 with adaptive = false: say how long all steps are");
  if (k.output_interval > 0 && k.duration / k.output_interval > 1e6)
    analysis.error("output_interval", "asks for more than a million outputs");
  return d;
}

Course read_course(formats::TableReader& hold) {
  const bool by_way = hold.has("displacement"), by_speed = hold.has("velocity");
  if (by_way && by_speed)
    hold.error("velocity",
               "is given beside displacement, and each of them determines the motion; give one of them");
  if (by_way == by_speed) return {};
  const char* key = by_way ? "displacement" : "velocity";
  formats::TableReader table = hold.table(key);
  if (table.keys() == std::vector<std::string>{"t"})
    hold.error(key, "has no x, y or z, so that nothing would move", "x = [0, 1] beside t = [0, 10]");
  const auto t = read_times(table);
  if (by_way) {
    Course course = through(t, read_columns(table, "m", "way from where it is held", {-1e6, 1e6}, t.size()));
    if (!t.empty() && course.at(0).d != Course::Point{})
      hold.diagnostics().warning(
          hold.place(key), hold.path(key) + ": is not zero at t = 0, so that the motion begins with a jump",
          "it counts from where the nodes are held: z = [0, 2] moves them up by 2 m");
    return course;
  }
  return gone(t, read_columns(table, "m/s", "velocity of what is held", {-1e3, 1e3}, t.size()));
}

}  // namespace netloft::scenes
