// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/framework/balance/oscillator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft {
namespace {

using test::Moving;
using test::Oscillator;

MarchState pulled(const Moving& m, double u, double v = 0) {
  MarchState from = state_at_rest(m.assembler);
  from.u[0] = u, from.v[0] = v;
  return from;
}

MarchSettings steps_of(double h, double duration) {
  MarchSettings s;
  s.duration = duration, s.step = h, s.adaptive = false, s.output_interval = h;
  return s;
}

/// The displacements of the mass at all outputs.
std::vector<double> path(Moving& m, const std::string& integrator, const Values& values,
                         const MarchSettings& settings, const MarchState& from) {
  std::vector<double> u;
  m.watch.on_output = [&](const Snapshot& s) { u.push_back(s.u[0]); };
  const MarchResult r = m.run(integrator, values, settings, &from);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return u;
}

/// Newmark's method by hand, (2) and (3) of newmark.hpp, with a = −ω² u.
std::vector<double> newmark_by_hand(double omega, double h, double chi, int n, double u, double v) {
  const double beta = (1 - chi) * (1 - chi) / 4, gamma = (1 - 2 * chi) / 2, w2 = omega * omega;
  std::vector<double> all = {u};
  double a = -w2 * u;
  for (int i = 0; i < n; ++i) {
    const double next = (u + h * v + h * h * (0.5 - beta) * a) / (1 + beta * h * h * w2);
    const double next_a = -w2 * next;
    v += h * ((1 - gamma) * a + gamma * next_a);
    u = next, a = next_a;
    all.push_back(u);
  }
  return all;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& wanted, double tolerance) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], wanted[i], tolerance) << "step " << i;
}

TEST(Newmark, FollowsItsRecurrenceOnALinearSpring) {
  const Oscillator o;
  for (const double chi : {0.0, -0.3}) {
    Moving m(o.scene());
    const double h = 0.7 / o.omega();
    const auto found = path(m, "newmark", {{"chi", chi}}, steps_of(h, 100 * h), pulled(m, 0.1, 0.4));
    expect_same(found, newmark_by_hand(o.omega(), h, chi, 100, 0.1, 0.4), 1e-10);
  }
}

TEST(Newmark, FindsTheSameStepsByTheFixedPointOfThePaper) {
  const Oscillator o;
  Moving m(o.scene());
  const double h = 0.5 / o.omega();
  const auto found = path(m, "newmark", {{"corrector", std::string("fixed-point")}, {"settled", 1e-14}},
                          steps_of(h, 50 * h), pulled(m, 0.1));
  expect_same(found, newmark_by_hand(o.omega(), h, -0.3, 50, 0.1, 0), 1e-10);
}

/// Whether Newmark's method with the fixed-point corrector makes 20 steps of length c/ω.
bool settles(double c) {
  const Oscillator o;
  Moving m(o.scene());
  const MarchState from = pulled(m, 0.1);
  return m.run("newmark", {{"corrector", std::string("fixed-point")}, {"corrections", std::int64_t{500}}},
               steps_of(c / o.omega(), 20 * c / o.omega()), &from)
             .status == MarchStatus::finished;
}

TEST(Newmark, SettlesByTheFixedPointBelowItsLimitAndNotAbove) {
  const double limit = 1 / std::sqrt(1.3 * 1.3 / 4);  // 1/√β
  EXPECT_TRUE(settles(0.97 * limit));
  EXPECT_FALSE(settles(1.03 * limit));
}

/// Displacement of the exact motion.
double exact(const Oscillator& o, double t, double u0) { return u0 * std::cos(o.omega() * t); }

double error_at_end(const std::string& integrator, const Values& values, int n) {
  const Oscillator o;
  Moving m(o.scene());
  const double T = 2.3 * 2 * std::numbers::pi / o.omega();
  const auto u = path(m, integrator, values, steps_of(T / n, T), pulled(m, 0.1));
  return std::abs(u.back() - exact(o, T, 0.1));
}

struct Scheme {
  const char* name;
  Values values;
  double order;
};

class Order : public testing::TestWithParam<Scheme> {};

TEST_P(Order, IsSeenByHalvingTheStep) {
  const auto [name, values, order] = GetParam();
  const double coarse = error_at_end(name, values, 200), fine = error_at_end(name, values, 400);
  EXPECT_NEAR(std::log2(coarse / fine), order, 0.1) << coarse << " " << fine;
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, Order,
    testing::Values(Scheme{"newmark", {}, 2}, Scheme{"newmark", {{"chi", -0.3}}, 1},
                    Scheme{"newmark", {{"corrector", std::string("fixed-point")}, {"settled", 1e-12}}, 1},
                    Scheme{"generalized-alpha", {{"spectral_radius", 0.5}}, 2},
                    Scheme{"generalized-alpha", {{"spectral_radius", 0.0}}, 2},
                    Scheme{"central-difference", {}, 2}));

class SpectralRadius : public testing::TestWithParam<double> {};

using Matrix3 = std::array<double, 9>;

/// The matrix of one step for (u, h v, h² a), column by column.
Matrix3 amplification(double rho, double Omega) {
  const Oscillator o;
  const double h = Omega / o.omega(), scale[3] = {1, 1 / h, 1 / (h * h)};
  constexpr double kSmall = 1e-6;  // [m]
  Matrix3 A{};
  for (std::size_t c = 0; c < 3; ++c) {
    Moving m(o.scene());
    MarchState from = state_at_rest(m.assembler), to;
    from.a = {0.0};
    (c == 0 ? from.u : c == 1 ? from.v : from.a)[0] = kSmall * scale[c];
    from.least_load = o.EA / o.length * kSmall;
    m.watch.on_output = [&](const Snapshot& s) { to = *s.state; };
    m.run("generalized-alpha", {{"spectral_radius", rho}}, steps_of(h, h), &from);
    const double end[3] = {to.u[0], to.v[0], to.a[0]};
    for (std::size_t r = 0; r < 3; ++r) A[3 * r + c] = end[r] / scale[r] / kSmall;
  }
  return A;
}

/// ‖Aⁿ‖^(1/n) for n = 2^16, by squaring, which tends to the spectral radius.
double spectral_radius(Matrix3 A) {
  double log_size = 0, n = 1;
  for (int k = 0; k < 16; ++k, n *= 2) {
    Matrix3 square{};
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t l = 0; l < 3; ++l) square[i] += A[3 * (i / 3) + l] * A[3 * l + i % 3];
    const double size = std::abs(*std::max_element(
        square.begin(), square.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
    for (double& v : square) v /= size;
    A = square, log_size = 2 * log_size + std::log(size);
  }
  return std::exp(log_size / n);
}

TEST_P(SpectralRadius, IsAsAskedFarAboveTheStep) {
  EXPECT_NEAR(spectral_radius(amplification(GetParam(), 1e3)), GetParam(), 0.02);
}

TEST_P(SpectralRadius, IsOneFarBelowTheStep) {
  EXPECT_NEAR(spectral_radius(amplification(GetParam(), 1e-2)), 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Asked, SpectralRadius, testing::Values(0.5, 0.8, 1.0));

TEST(CentralDifference, IsStableBelowItsLimitAndNotAbove) {
  const Oscillator o;
  for (const double c : {1.98, 2.02}) {
    Moving m(o.scene());
    std::vector<double> u;
    m.watch.on_output = [&](const Snapshot& s) { u.push_back(s.u[0]); };
    const double h = c / o.omega();
    const MarchState from = pulled(m, 1e-3);
    MarchSettings s = steps_of(h, 200 * h);
    s.judged = false;
    m.run("central-difference", {}, s, &from);
    const double largest = *std::max_element(u.begin(), u.end());
    EXPECT_EQ(largest < 0.02, c < 2) << largest;
  }
}

/// Energies of the budget at every output.
struct Budget {
  std::vector<double> kinetic, elastic, numerical;
  void note(const EnergyBudget& b) {
    const auto names = b.names();
    const auto values = b.values();
    const auto of = [&](const char* name) {
      return values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    kinetic.push_back(of("kinetic")), elastic.push_back(of("elastic")), numerical.push_back(of("numerical"));
  }
};

Budget budget_of(Moving& m, const Values& values, double h, int n, const MarchState& from) {
  Budget b;
  m.watch.on_output = [&](const Snapshot& s) { b.note(*s.budget); };
  m.run("newmark", values, steps_of(h, n * h), &from);
  return b;
}

TEST(EnergyBudget, ClosesOnALinearSpringUnderTheTrapezoidalRule) {
  const Oscillator o;
  Moving m(o.scene());
  const Budget b = budget_of(m, {}, 0.3 / o.omega(), 200, pulled(m, 0.1));
  const double whole = 0.5 * o.EA / o.length * 0.1 * 0.1;
  for (std::size_t i = 0; i < b.kinetic.size(); ++i) {
    ASSERT_NEAR(b.kinetic[i] + b.elastic[i], whole, 1e-9 * whole);
    ASSERT_NEAR(b.numerical[i], 0, 1e-9 * whole);
  }
}

TEST(EnergyBudget, RetractsAStepToTheBit) {
  const Oscillator o;
  Moving m(o.scene());
  EnergyBudget once(m.assembler, 0.2), twice(m.assembler, 0.2);
  const std::vector<double> start = {0.1}, moved = {0.07}, far = {-0.4}, slow = {0.3}, fast = {2.0},
                            none = {0.0};
  for (EnergyBudget* b : {&once, &twice}) {
    ASSERT_TRUE(b->begin(0, start, none, none));
    ASSERT_TRUE(b->advance(0.1, moved, slow, none));
  }
  const std::vector<double> before = twice.values();
  ASSERT_TRUE(twice.advance(0.3, far, fast, none));
  ASSERT_NE(twice.values(), before);
  twice.retract();
  EXPECT_EQ(twice.values(), before);
  for (EnergyBudget* b : {&once, &twice}) ASSERT_TRUE(b->advance(0.2, start, fast, none));
  EXPECT_EQ(twice.values(), once.values());
  EXPECT_EQ(twice.sums(), once.sums());
}

TEST(EnergyBudget, NeverGainsUnderASchemeThatDamps) {
  const Oscillator o;
  Moving m(o.scene());
  const Budget b = budget_of(m, {{"chi", -0.3}}, 0.1 / o.omega(), 200, pulled(m, 0.1));
  for (std::size_t i = 10; i < b.kinetic.size(); ++i)
    ASSERT_LT(b.kinetic[i] + b.elastic[i], b.kinetic[i - 10] + b.elastic[i - 10]);
  EXPECT_GT(b.numerical.back(), 0.1 * b.elastic[0]);
}

TEST(EnergyBudget, KnowsWhatMassDampingTakes) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s = steps_of(0.01 / o.omega(), 12 / o.omega());
  s.mass_damping = 0.2 * o.omega();
  std::vector<double> last;
  std::vector<std::string> names;
  m.watch.on_output = [&](const Snapshot& at) { last = at.budget->values(), names = at.budget->names(); };
  const MarchState from = pulled(m, 0.1);
  m.run("newmark", {}, s, &from);
  double kept = 0;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == "kinetic" || names[k] == "elastic" || names[k] == "mass_damping_work") kept += last[k];
  EXPECT_NEAR(kept, 0.5 * o.EA / o.length * 0.01, 1e-4 * kept);
}

/// The motion satisfies ü + c u̇ + ω² u = 0 and starts at rest.
TEST(March, DampsByMassAsTheClosedFormSays) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s = steps_of(0.005 / o.omega(), 6 / o.omega());
  s.mass_damping = 0.3 * o.omega();
  const double delta = s.mass_damping / 2, w = std::sqrt(o.omega() * o.omega() - delta * delta);
  const auto u = path(m, "newmark", {}, s, pulled(m, 0.1));
  const double t = s.duration;
  EXPECT_NEAR(u.back(), 0.1 * std::exp(-delta * t) * (std::cos(w * t) + delta / w * std::sin(w * t)), 1e-6);
}

TEST(March, KeepsTheErrorOfAStepBelowTheAccuracy) {
  const Oscillator o;
  double before = 1;
  for (const double accuracy : {1e-4, 1e-5, 1e-6}) {
    Moving m(o.scene());
    MarchSettings s;
    s.duration = 20 / o.omega(), s.accuracy = accuracy;
    const MarchState from = pulled(m, 0.1);
    const MarchResult r = m.run("newmark", {}, s, &from);
    ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
    const double error = std::abs(r.u[0] - exact(o, s.duration, 0.1));
    EXPECT_LT(error, 0.5 * before);
    before = error;
  }
  EXPECT_LT(before, 0.01 * 0.1);
}

TEST(March, GivesTheSameOutputsBetweenStepsAsAtTheirEnds) {
  const Oscillator o;
  std::vector<double> u[2];
  for (const bool dense : {false, true}) {
    Moving m(o.scene());
    MarchSettings s;
    s.duration = 10 / o.omega(), s.accuracy = 1e-6, s.output_interval = 0.37 / o.omega(), s.dense = dense;
    u[dense] = path(m, "newmark", {}, s, pulled(m, 0.1));
  }
  expect_same(u[1], u[0], 1e-4);
}

struct Steps {
  const char* name;
  const char* integrator;
  Values values;
  double limit;  // largest stable h ω
  int count = 3000;
};

const Values kFixedPoint = {{"corrector", std::string("fixed-point")}, {"corrections", std::int64_t{500}}};
class Judged : public testing::TestWithParam<std::tuple<Steps, bool>> {
 protected:
  MarchResult march_at(double share_of_limit) {
    const auto& [steps, budget] = GetParam();
    const Oscillator o;
    Moving m(o.scene());
    const double h = share_of_limit * steps.limit / o.omega();
    MarchSettings s = steps_of(h, steps.count * h);
    s.budget = budget, s.output_interval = 0;
    const MarchState from = pulled(m, 0.1);
    return m.run(steps.integrator, steps.values, s, &from);
  }
};
class Unstable : public Judged {};

TEST_P(Judged, FinishesBelowTheLimit) {
  const MarchResult r = march_at(0.97);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
}

TEST_P(Unstable, IsLostAboveTheLimit) {
  const MarchResult r = march_at(1.05);
  EXPECT_EQ(r.status, MarchStatus::failed) << r.reason;
  EXPECT_NE(r.reason.find("the motion is lost"), std::string::npos) << r.reason;
  EXPECT_NE(r.reason.find("bar node 1 moves at"), std::string::npos) << r.reason;
  EXPECT_LT(r.t, 200 * 1.05 * 2 / Oscillator().omega());
}

const Steps kCentral{"CentralDifference", "central-difference", {}, 2};
const Steps kSettled{"FixedPoint", "newmark", kFixedPoint, 1 / 0.65, 50};
std::string name_of_steps(const testing::TestParamInfo<std::tuple<Steps, bool>>& tested) {
  return std::string(std::get<0>(tested.param).name) + (std::get<1>(tested.param) ? "" : "WithoutABudget");
}

INSTANTIATE_TEST_SUITE_P(Schemes, Judged,
                         testing::Combine(testing::Values(kCentral, kSettled,
                                                          Steps{"Newmark", "newmark", {}, 1e2},
                                                          Steps{"Damped", "newmark", {{"chi", -0.3}}, 1},
                                                          Steps{"Alpha", "generalized-alpha", {}, 1e2}),
                                          testing::Bool()),
                         name_of_steps);
INSTANTIATE_TEST_SUITE_P(Schemes, Unstable, testing::Combine(testing::Values(kCentral), testing::Bool()),
                         name_of_steps);

TEST(March, JudgesNothingWhereNobodyAsks) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s = steps_of(2.1 / o.omega(), 30 * 2.1 / o.omega());
  s.judged = false;
  const MarchState from = pulled(m, 0.1);
  EXPECT_EQ(m.run("central-difference", {}, s, &from).status, MarchStatus::finished);
}

/// An output stores the energies that were created and supplied before it.
TEST(March, IsLostAtTheSameStepWhenItGoesOnFromAnOutput) {
  const Oscillator o;
  const double h = 2.0005 / o.omega();
  Moving m(o.scene());
  std::vector<MarchState> kept;
  m.watch.on_output = [&](const Snapshot& s) { kept.push_back(*s.state); };
  MarchState from = pulled(m, 0.1);
  from.v[0] = 1e-4;
  const MarchResult whole = m.run("central-difference", {}, steps_of(h, 3000 * h), &from);
  ASSERT_NE(whole.reason.find("lost"), std::string::npos) << whole.reason;
  ASSERT_GT(kept.size(), 3u);
  Moving again(o.scene());
  const MarchResult rest = again.run("central-difference", {}, steps_of(h, 3000 * h), &kept[kept.size() - 2]);
  EXPECT_EQ(rest.t, whole.t);
  EXPECT_EQ(rest.reason, whole.reason);
}

/// At the end of a step, spring force and inertia of the mass are in balance; on the cubic between two ends
/// they are not.
TEST(March, TellsForcesOfEndsOfStepsBetweenThem) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s = steps_of(1 / o.omega(), 10 / o.omega());
  s.output_interval = 0.37 / o.omega(), s.dense = true;
  std::size_t between = 0;
  m.watch.on_output = [&](const Snapshot& at) {
    EXPECT_GE(at.forces.t, at.t);
    EXPECT_LT(at.forces.t, at.t + s.step * (1 + 1e-9));
    EXPECT_NEAR(at.forces.residual[0], 0, 1e-4 * o.EA / o.length * 0.1) << at.t;
    between += at.forces.t > at.t;
  };
  const MarchState from = pulled(m, 0.1);
  m.run("newmark", {}, s, &from);
  EXPECT_GT(between, 10u);
}

TEST(March, GoesOnFromAnyOutputToTheSameBits) {
  const Oscillator o;
  for (const bool dense : {false, true}) {
    MarchSettings s;
    s.duration = 10 / o.omega(), s.accuracy = 1e-5, s.output_interval = 0.37 / o.omega(), s.dense = dense;
    Moving whole(o.scene());
    std::vector<MarchState> kept;
    std::vector<double> u;
    whole.watch.on_output = [&](const Snapshot& at) {
      u.push_back(at.u[0]);
      if (at.state) kept.push_back(*at.state);
    };
    const MarchState from = pulled(whole, 0.1);
    whole.run("generalized-alpha", {}, s, &from);
    ASSERT_GT(kept.size(), 8u);
    Moving rest(o.scene());
    std::vector<double> again;
    rest.watch.on_output = [&](const Snapshot& at) { again.push_back(at.u[0]); };
    rest.run("generalized-alpha", {}, s, &kept[7]);
    ASSERT_EQ(again, std::vector<double>(u.begin() + static_cast<std::ptrdiff_t>(kept[7].outputs), u.end()));
  }
}

MarchSettings checked(double duration, double accuracy, double interval) {
  MarchSettings s;
  s.duration = duration, s.accuracy = accuracy, s.output_interval = interval, s.check = true;
  return s;
}

/// Largest difference from the closed form at outputs, divided by the length of the only element.
double error_of_path(const Oscillator& o, const std::vector<double>& u, double interval) {
  double most = 0;
  for (std::size_t i = 0; i < u.size(); ++i)
    most = std::max(most, std::abs(u[i] - exact(o, static_cast<double>(i) * interval, 0.1)) / o.length);
  return most;
}

class PathError : public testing::TestWithParam<const char*> {};

/// The march runs once with control of the errors of steps, and once with fixed steps; both are compared with
/// the closed form.
TEST_P(PathError, IsNeverBelowThatOfTheClosedFormAndAtMostTenTimesIt) {
  const Oscillator o;
  const double interval = 0.4 / o.omega();
  for (const bool adaptive : {true, false}) {
    Moving m(o.scene());
    MarchSettings s = checked(20 / o.omega(), 1e-3, interval);
    s.adaptive = adaptive, s.step = adaptive ? 0 : 0.1 / o.omega();
    std::vector<double> u;
    m.watch.on_output = [&](const Snapshot& at) { u.push_back(at.u[0]); };
    const MarchState from = pulled(m, 0.1);
    const MarchResult r = m.run(GetParam(), {}, s, &from);
    ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
    const double error = error_of_path(o, u, interval);
    EXPECT_GE(r.accuracy.path, error) << adaptive;
    EXPECT_LE(r.accuracy.path, 10 * error) << adaptive;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, PathError,
                         testing::Values("generalized-alpha", "newmark", "central-difference"),
                         [](const auto& scheme) {
                           std::string name = scheme.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(PathError, IsMissedWhereStepsThatAreGivenAreTooLong) {
  const Oscillator o;
  for (const auto& [h, is_missed] : {std::pair{0.3, true}, {0.003, false}}) {
    Moving m(o.scene());
    MarchSettings s = checked(20 / o.omega(), 1e-3, 2 / o.omega());
    s.adaptive = false, s.step = h / o.omega();
    const MarchState from = pulled(m, 0.1);
    EXPECT_EQ(m.run("generalized-alpha", {}, s, &from).accuracy.is_missed(), is_missed);
  }
}

/// The rate of the current jumps at every step, so that both marches end a step there.
TEST(PathError, IsNotKnownWhereBothMarchesTakeTheSameSteps) {
  const Oscillator o;
  Scene scene = o.scene();
  const double h = 0.01 / o.omega();
  for (int i = 0; i <= 100; ++i) scene.current.factors.push_back({i * h, 1});
  Moving m(scene);
  MarchSettings s = checked(100 * h, 1e-3, 20 * h);
  s.adaptive = false, s.step = h;
  const MarchState from = pulled(m, 0.1);
  const AchievedAccuracy a = m.run("generalized-alpha", {}, s, &from).accuracy;
  EXPECT_TRUE(std::isnan(a.path)) << a.path;
  EXPECT_TRUE(a.is_missed());
}

/// Outputs are so dense that some are within the first step.
TEST(PathError, IsKnownWhereOutputsAreDenserThanSteps) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s = checked(20 / o.omega(), 1e-3, 0.01 / o.omega());
  s.adaptive = false, s.dense = true, s.step = 0.01 / o.omega();
  const MarchState from = pulled(m, 0.1);
  const AchievedAccuracy a = m.run("generalized-alpha", {}, s, &from).accuracy;
  EXPECT_TRUE(std::isfinite(a.path));
  EXPECT_FALSE(a.is_missed()) << a.path;
}

TEST(PathError, LeavesTheMotionAsItIs) {
  const Oscillator o;
  std::vector<double> u[2];
  for (const bool is_checked : {false, true}) {
    Moving m(o.scene());
    MarchSettings s = checked(10 / o.omega(), 1e-4, 0.37 / o.omega());
    s.check = is_checked;
    u[is_checked] = path(m, "generalized-alpha", {}, s, pulled(m, 0.1));
  }
  EXPECT_EQ(u[0], u[1]);
}

TEST(PathError, GoesOnFromAnyOutputToTheSameBits) {
  const Oscillator o;
  for (const bool dense : {false, true}) {
    MarchSettings s = checked(10 / o.omega(), 1e-5, 0.37 / o.omega());
    s.dense = dense;
    Moving whole(o.scene());
    std::vector<MarchState> kept;
    whole.watch.on_output = [&](const Snapshot& at) {
      if (at.state) kept.push_back(*at.state);
    };
    const MarchState from = pulled(whole, 0.1);
    const AchievedAccuracy all = whole.run("generalized-alpha", {}, s, &from).accuracy;
    ASSERT_GT(kept.size(), 8u);
    EXPECT_TRUE(std::isfinite(all.path)) << dense;
    for (const std::size_t k : {std::size_t{0}, std::size_t{7}}) {
      Moving rest(o.scene());
      const AchievedAccuracy again = rest.run("generalized-alpha", {}, s, &kept[k]).accuracy;
      EXPECT_EQ(again.path, all.path);
      EXPECT_EQ(again.path_at, all.path_at);
    }
  }
}

TEST(March, SaysWhyItStopsAtANodeWithoutMass) {
  Scene scene = Oscillator().scene();
  scene.parts[0].parameters["rope.density"] = 0.0;
  Moving m(scene);
  const MarchResult r = m.run("central-difference", {}, steps_of(0.01, 0.1));
  EXPECT_EQ(r.status, MarchStatus::failed);
  EXPECT_NE(r.reason.find("bar node 1 has no mass"), std::string::npos) << r.reason;
}

/// The other end of the spring moves by d(t) = ½ b t²: ü + ω² u = ω² d, so that from rest u = d − b (1 − cos
/// ωt)/ω².
TEST(March, MovesWhatAGuideHolds) {
  const Oscillator o;
  Scene scene = o.scene();
  constexpr double b = 0.8;
  const double T = 7 / o.omega();
  scene.guides.push_back({{0}, {kAllAxes}, {{{0, {}, {}}, {T, {b * T * T / 2}, {b * T}}}}});
  Moving m(scene);
  const auto u = path(m, "newmark", {}, steps_of(T / 2000, T), state_at_rest(m.assembler));
  const double w = o.omega();
  EXPECT_NEAR(u.back(), b * T * T / 2 - b * (1 - std::cos(w * T)) / (w * w), 1e-6);
}

/// Three masses on two free bars, which become slack and taut while they fly and rotate.
Scene flying() {
  Scene s = Oscillator().scene();
  s.positions = {0, 0, 0, 2, 0, 0, 3, 1.7, 0.4};
  s.held = {0, 0, 0};
  s.labels = {{0, 0}, {0, 1}, {0, 2}};
  s.parts[0].nodes = {0, 1, 1, 2}, s.parts[0].data["rest_length"] = {2, 2.05};
  s.parts[0].parameters["rope.EA_compression"] = 0.0;
  return s;
}

struct Momenta {
  std::array<double, 3> linear{}, angular{};
};
/// Momenta with half of the mass of each bar at either end.
Momenta momenta_of(const Snapshot& s, const Assembler& assembler) {
  const std::array<double, 3> mass = {0.5, 0.5 + 0.5 * 2.05 / 2, 0.5 * 2.05 / 2};  // [kg]
  const std::vector<double> x = assembler.node_positions(s.x), v = assembler.node_positions(s.v);
  Momenta sum;
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
      sum.linear[k] += mass[n] * v[3 * n + k];
      sum.angular[k] += mass[n] * (x[3 * n + p] * v[3 * n + q] - x[3 * n + q] * v[3 * n + p]);
    }
  return sum;
}

TEST(EnergyMomentum, KeepsMomentaAndEnergyWhereNothingActs) {
  Moving m(flying(), "chord", 1, "energy-momentum");
  MarchState from = state_at_rest(m.assembler);
  for (std::size_t i = 0; i < from.v.size(); ++i) from.v[i] = std::sin(7.0 * static_cast<double>(i + 1));
  std::vector<Momenta> all;
  double numerical = 0, kinetic = 0;
  m.watch.on_output = [&](const Snapshot& s) {
    all.push_back(momenta_of(s, m.assembler));
    numerical = std::max(numerical, std::abs(s.budget->totals().numerical));
    kinetic = std::max(kinetic, s.budget->totals().kinetic);
  };
  MarchSettings s = steps_of(0.03, 30);
  const MarchResult r = m.run("energy-momentum", {{"spectral_radius", 1.0}}, s, &from);
  ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
  for (const Momenta& at : all)
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(at.linear[k], all[0].linear[k], 1e-9);
      ASSERT_NEAR(at.angular[k], all[0].angular[k], 1e-9);
    }
  EXPECT_GT(kinetic, 0.1);
  EXPECT_LT(numerical, 1e-9 * kinetic);
}

struct FlyingScheme {
  const char *name, *integrator;
  Values parameters;
  double step;  // [s]
};
class FreeFlight : public testing::TestWithParam<FlyingScheme> {};

/// Members have equal and opposite end forces, so that linear momentum is constant with any scheme. Only
/// energy-momentum also conserves angular momentum (above).
TEST_P(FreeFlight, KeepsLinearMomentumWhereNothingActs) {
  const FlyingScheme& scheme = GetParam();
  Moving m(flying(), "newton", 1, scheme.integrator);
  MarchState from = state_at_rest(m.assembler);
  for (std::size_t i = 0; i < from.v.size(); ++i) from.v[i] = std::sin(7.0 * static_cast<double>(i + 1));
  std::vector<Momenta> all;
  double least = 1e9, most = -1e9;
  m.watch.on_output = [&](const Snapshot& s) {
    all.push_back(momenta_of(s, m.assembler));
    least = std::min(least, s.budget->totals().kinetic), most = std::max(most, s.budget->totals().kinetic);
  };
  const MarchResult r = m.run(scheme.integrator, scheme.parameters, steps_of(scheme.step, 5), &from);
  ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
  for (const Momenta& at : all)
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(at.linear[k], all[0].linear[k], 1e-8) << k;
  EXPECT_GT(most - least, 0.01 * most);  // members have pulled
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, FreeFlight,
    testing::Values(
        FlyingScheme{"Newmark", "newmark", {}, 1e-3},
        FlyingScheme{"NewmarkOfThePaper", "newmark", {{"chi", -0.3}}, 1e-3},
        FlyingScheme{"GeneralizedAlpha", "generalized-alpha", {{"spectral_radius", 0.8}}, 1e-3},
        FlyingScheme{"GeneralizedAlphaThatDampsMost", "generalized-alpha", {{"spectral_radius", 0.0}}, 1e-3},
        FlyingScheme{"CentralDifferences", "central-difference", {}, 1e-3},
        FlyingScheme{"EnergyMomentumThatDamps", "energy-momentum", {{"spectral_radius", 0.3}}, 1e-2}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(TransientProblem, HasTheFrequencyOfTheSpring) {
  const Oscillator o;
  Moving m(o.scene());
  TransientProblem p(m.assembler, 0, {&m.solver_type, m.solver_block.data()}, make_factorisation, m.limits);
  EXPECT_NEAR(p.highest_frequency(), o.omega(), 1e-6 * o.omega());
}

}  // namespace
}  // namespace netloft
