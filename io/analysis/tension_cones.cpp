// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_cones.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace netloft::io {

namespace {

constexpr double kRoom = 0.1;  // of z0 above what it must at least be, at the start
constexpr double kToBoundary = 0.98;
// Over the first tension: the largest force that may be left, and by how much T may be off the tension that
// the length of its member stands for. The stiffer members are, the smaller a μ that asks for.
constexpr double kForces = 1e-6, kLaw = 1e-5;
// No smaller μ is asked for, over the first tension: rounding.
constexpr double kLeastMu = 1e-12;
// What is left of both over the first tension, where a solver may go on.
constexpr double kNear = 1e-5;
// So many steps in a row of at most this length: it does not come on.
constexpr double kTiny = 0.02;
constexpr int kTinySteps = 5;
// D of (3), over the first tension: tenfold after a short step, a tenth after a long one.
constexpr double kShort = 0.05, kLong = 0.5, kRise = 10, kFall = 0.1;
constexpr double kLeastDamping = 1e-6, kMostDamping = 1e-2, kNoDamping = 1e-9;

// Bounds of E_c over the first tension: the first one where the mean EA_c is not above it, else the second.
constexpr double kMostPressed = 0.1, kLittlePressed = 0.01;
// Mean EA_c over the first tension above which what is pressed decides where things come to rest, and the
// least μ then over the largest force that is left.
constexpr double kDecides = 0.02, kCentral = 0.03;
constexpr double kCollapsed = 1e-9;  // l/l₀ below which a member has no direction

double largest_of(std::span<const double> v) {
  double largest = 0;
  for (const double a : v) largest = std::max(largest, std::abs(a));
  return largest;
}

/// What is no number stays none.
double at_most_whole(double step) { return step > 1 ? 1 : step; }

}  // namespace

TensionCones::TensionCones(const Scene& scene, Registry& registry, MakeFactorisation make, int threads)
    : net_(scene, registry, threads),
      make_(std::move(make)),
      blocks_(net_.size()),
      forces_(net_.size()),
      changes_(net_.size()),
      step_(net_.unknowns()) {
  factorisation_ =
      make_(net_.pattern().symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
}

Leg TensionCones::solve(const ConeOptions& options) {
  const double wall = wall_seconds(), cpu = cpu_seconds();
  books_ = {};
  Leg leg{"tension only, in cones", "cones", net_.unknowns(), SolveStatus::not_converged, "", {}};
  {
    Timed timed(books_.analysis_seconds);
    factorisation_->analyse(net_.pattern());
  }
  begin(options.tension);
  first_mu_ = mu_ = options.tension;
  damping_ = 0;
  const double pressed = net_.pattern().symmetric ? mean_pressed() / options.tension : 0;
  most_pressed_ =
      pressed > 0 ? (pressed <= kMostPressed ? kMostPressed : kLittlePressed) * options.tension : 0;
  central_ = pressed > kDecides && pressed <= kMostPressed ? kCentral : 0;
  const std::string ending = run(options, wall);
  if (ending.empty()) leg.status = SolveStatus::converged;
  char rest[96];
  std::snprintf(rest, sizeof rest, "largest residual %.3g N, tension still to be told from slackness %.2g N",
                largest_residual(), mu_);
  leg.reason = ending.empty() ? rest : ending + "; " + rest;
  books_.total_seconds = wall_seconds() - wall;
  books_.total_cpu_seconds = books_.solver_cpu_seconds = cpu_seconds() - cpu;
  leg.books = books_;
  return leg;
}

/// Until tension is told from slackness; else what ended it.
std::string TensionCones::run(const ConeOptions& options, double begun) {
  for (int tiny = 0; tiny < kTinySteps;) {
    if (!assemble(is_indefinite_)) return "forces are no numbers";
    if (mu_ <= options.tolerance * options.tension && largest_residual() <= kForces * options.tension &&
        (mu_ <= kLeastMu * options.tension || largest_law_error() <= kLaw * options.tension))
      return "";
    if (const std::string why = called_off(options, begun); !why.empty()) return why;
    if (!factorise()) return "no factorisation";
    ++books_.iterations;
    const double a = step();
    if (!std::isfinite(a)) return "a step is no number";
    take(a);
    adapt(a, options.tension);
    tiny = a <= kTiny ? tiny + 1 : 0;
  }
  return "steps have become tiny";
}

/// Of the tension in (1) by the tension that the length of the member stands for, members side by side
/// together, but for what rounding of the positions is worth there [N].
double TensionCones::largest_law_error() const {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest_of(net_.positions());
  double largest = 0;
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const AxialMember& m = net_.members()[e];
    const double off = std::abs(EA(e) * std::max(0.0, net_.line(e).strain) - members_[e].y[0]);
    largest = std::max(largest, m.count * (off - EA(e) * rounding / m.l0));
  }
  return largest;
}

double TensionCones::largest_residual() const { return largest_of({residual_.data(), net_.unknowns()}); }

bool TensionCones::is_near() const {
  return has_forces_ && mu_ <= kNear * first_mu_ && largest_residual() <= kNear * first_mu_;
}

/// On the path of (2), wherever the nodes are; (1) need not hold.
void TensionCones::begin(double mu) {
  members_.clear();
  for (std::size_t e = 0; e < net_.size(); ++e) {
    members_.push_back({std::max(1.0, net_.line(e).l / net_.members()[e].l0) + kRoom, {}});
    const cone::Point z = z_of(e), mirrored = cone::mirrored(z);
    const double share = mu / cone::determinant(z);
    for (std::size_t i = 0; i < 4; ++i) members_[e].y[i] = share * mirrored[i];
  }
}

cone::Point TensionCones::z_of(std::size_t e) const {
  const auto& w = net_.line(e).w;
  const double l0 = net_.members()[e].l0;
  return {members_[e].z0, w[0] / l0, w[1] / l0, w[2] / l0};
}

/// z·y of a bar, the mean over all length of bars.
double TensionCones::mean_complementarity() const {
  double sum = 0, length = 0;
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const double weight = net_.members()[e].count * net_.members()[e].l0;
    sum += weight * cone::dot(z_of(e), members_[e].y), length += weight;
  }
  return sum / length;
}

/// Matrix of (3), r + Σ n c (q + p), and the scaling of all members.
bool TensionCones::assemble(bool convex) {
  Timed timed(books_.assembly_seconds);
  ++books_.residuals, ++books_.matrices;
  has_forces_ = false;
  if (!net_.evaluate(residual_, values_)) return false;
  scaling_.clear();
  for (std::size_t e = 0; e < net_.size(); ++e) set_member(e, convex);
  net_.add_blocks(blocks_, values_);
  net_.add_forces(forces_, residual_);
  mu_ = mean_complementarity();
  return has_forces_ = std::isfinite(norm_of(residual_)) && std::isfinite(mu_);
}

/// K and q + p of (3).
void TensionCones::set_member(std::size_t e, bool convex) {
  const AxialMember& m = net_.members()[e];
  const cone::Point& y = members_[e].y;
  const cone::Scaling& H = scaling_.emplace_back(z_of(e), y);
  MemberNet::Block& K = blocks_[e];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      K[3 * i + j] =
          (H.squared(i + 1, j + 1) - H.squared(0, i + 1) * H.squared(0, j + 1) / (EA(e) + H.squared(0, 0))) /
              m.l0 +
          (i == j ? damping_ / m.l0 : 0);
  forces_[e] = {-y[1], -y[2], -y[3]};
  if (EA_pressed(e) > 0) add_pressed(e, convex);
}

/// (7) and (8); what has no length has no direction to press in.
void TensionCones::add_pressed(std::size_t e, bool convex) {
  const MemberNet::Line& line = net_.line(e);
  if (!(line.l > kCollapsed * net_.members()[e].l0)) return;
  const double stiffness = EA_pressed(e) / net_.members()[e].l0, a = line.strain / (1 + line.strain),
               across = convex ? std::max(0.0, a) : a;
  for (std::size_t i = 0; i < 3; ++i) {
    forces_[e][i] += EA_pressed(e) * line.strain * line.t[i];
    for (std::size_t j = 0; j < 3; ++j)
      blocks_[e][3 * i + j] += stiffness * ((1 - across) * line.t[i] * line.t[j] + (i == j ? across : 0));
  }
}

/// EA_c, the mean over all length of bars.
double TensionCones::mean_pressed() const {
  double sum = 0, length = 0;
  for (const AxialMember& m : net_.members())
    sum += m.count * m.l0 * m.EA_compression, length += m.count * m.l0;
  return sum / length;
}

/// Half of its stiffness is left to the cone of what bears as much when pressed.
double TensionCones::EA_pressed(std::size_t e) const {
  const AxialMember& m = net_.members()[e];
  return std::min({m.EA_compression, most_pressed_, 0.5 * m.EA});
}

double TensionCones::EA(std::size_t e) const { return net_.members()[e].EA - EA_pressed(e); }

FactorStatus TensionCones::factorise_once() {
  Timed timed(books_.factorisation_seconds);
  ++books_.factorisations;
  const FactorStatus status = factorisation_->factorise(net_.matrix(values_)).status;
  if (status == FactorStatus::not_positive_definite) ++books_.refused_factorisations;
  return status;
}

/// With the convex part of (8) if need be. Where other forces make that indefinite it is factorised as what
/// it is.
bool TensionCones::factorise() {
  FactorStatus status = factorise_once();
  if (status == FactorStatus::not_positive_definite && most_pressed_ > 0) {
    if (!assemble(true)) return false;
    status = factorise_once();
  }
  if (status != FactorStatus::not_positive_definite) return status == FactorStatus::ok;
  is_indefinite_ = true;
  factorisation_ = make_(MatrixClass::symmetric);
  factorisation_->analyse(net_.pattern());
  return factorise_once() == FactorStatus::ok;
}

/// (5) and (6): the length of the step.
double TensionCones::step() {
  solve_for_step(predictor());
  const double reached = at_most_whole(longest_step());
  const double sigma = (1 - reached) * (1 - reached) * (1 - reached);
  solve_for_step(corrector(std::max(sigma * mu_, central_ * largest_residual())));
  return at_most_whole(kToBoundary * longest_step());
}

std::vector<cone::Point> TensionCones::predictor() const {
  std::vector<cone::Point> g;
  for (const Member& m : members_) g.push_back({-m.y[0], -m.y[1], -m.y[2], -m.y[3]});
  return g;
}

std::vector<cone::Point> TensionCones::corrector(double mu) const {
  std::vector<cone::Point> g;
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const cone::Scaling& W = scaling_[e];
    const cone::Point v = W.unscaled(members_[e].y), vv = cone::product(v, v),
                      second = cone::product(W.scaled(members_[e].dz), W.unscaled(members_[e].dy));
    cone::Point rest;
    for (std::size_t i = 0; i < 4; ++i) rest[i] = (i == 0 ? mu : 0) - vv[i] - second[i];
    g.push_back(W.scaled(cone::quotient(rest, v)));
  }
  return g;
}

/// ζ of (4), `along` h·δw/l₀ less; without it δz₀.
double TensionCones::zeta(std::size_t e, double g0, double along) const {
  const double T = members_[e].y[0], z0 = members_[e].z0;
  return (EA(e) * (1 - z0) + T + g0 - along) / (EA(e) + scaling_[e].squared(0, 0));
}

void TensionCones::solve_for_step(const std::vector<cone::Point>& g) {
  Timed timed(books_.solve_seconds);
  ++books_.solves;
  std::vector<double> rhs = residual_;
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const cone::Scaling& H = scaling_[e];
    const double z = zeta(e, g[e][0], 0);
    forces_[e] = {H.squared(0, 1) * z - g[e][1], H.squared(0, 2) * z - g[e][2],
                  H.squared(0, 3) * z - g[e][3]};
  }
  net_.add_forces(forces_, rhs);
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -rhs[i];
  factorisation_->solve(step_, step_);
  net_.find_changes(step_, changes_);
  for (std::size_t e = 0; e < net_.size(); ++e) set_step(e, g[e]);
}

/// δz and δy of a member, by what the solve has for its nodes: δy = g − H δz.
void TensionCones::set_step(std::size_t e, const cone::Point& g) {
  const cone::Scaling& H = scaling_[e];
  const MemberNet::Vector& change = changes_[e];
  cone::Point &dz = members_[e].dz, &dy = members_[e].dy;
  for (std::size_t k = 0; k < 3; ++k) dz[k + 1] = change[k] / net_.members()[e].l0;
  dz[0] = zeta(e, g[0], H.squared(0, 1) * dz[1] + H.squared(0, 2) * dz[2] + H.squared(0, 3) * dz[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    dy[i] = g[i];
    for (std::size_t j = 0; j < 4; ++j) dy[i] -= H.squared(i, j) * dz[j];
  }
}

/// Up to where the first z or y leaves K.
double TensionCones::longest_step() const {
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < net_.size(); ++e)
    longest = std::min({longest, cone::step_to_boundary(z_of(e), members_[e].dz),
                        cone::step_to_boundary(members_[e].y, members_[e].dy)});
  return std::isfinite(norm_of(step_)) ? longest : std::numeric_limits<double>::quiet_NaN();
}

void TensionCones::take(double a) {
  for (Member& m : members_) {
    m.z0 += a * m.dz[0];
    for (std::size_t i = 0; i < 4; ++i) m.y[i] += a * m.dy[i];
  }
  net_.move(step_, a);
}

/// Drag may leave what is slack with no place to be, or push it out of any: D holds it where steps become
/// short.
void TensionCones::adapt(double a, double tension) {
  if (a < kShort)
    damping_ = std::clamp(kRise * damping_, kLeastDamping * tension, kMostDamping * tension);
  else if (a > kLong)
    damping_ = kFall * damping_ < kNoDamping * tension ? 0 : kFall * damping_;
}

/// Which of the limits is reached, empty: none; tells who looks on.
std::string TensionCones::called_off(const ConeOptions& options, double begun) {
  const double seconds = wall_seconds() - begun;
  if (options.on_iteration)
    options.on_iteration({books_.iterations, largest_residual(), options.tension, 0, books_.factorisations,
                          seconds, "in cones"});
  if (options.interrupt && options.interrupt->load()) return "it was interrupted";
  if (books_.iterations >= options.iterations)
    return "the limit of " + std::to_string(options.iterations) + " iterations was reached";
  return seconds >= options.seconds ? "the time limit was reached" : "";
}

}  // namespace netloft::io
