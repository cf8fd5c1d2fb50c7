// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/law_bench.hpp"

#include <netloft/vectors.hpp>

#include "framework/registry/plugin_call.hpp"

#include <algorithm>

namespace netloft::conformance {

namespace {

enum Special : std::size_t { kNoFlow, kAlong, kAcross, kNearlyAlong, kNearlyAcross, kSlow, kAny };
constexpr const char* kNames[] = {
    "no flow", "along the direction", "across the direction", "nearly along", "nearly across", "slow", "",
    ""};
constexpr double kNearly = 1e-6, kLeastReach = 0.01;

void normalise(double (&a)[3]) {
  const double length = std::sqrt(dot(a, a));
  for (double& c : a) c /= length;
}

/// Changes the unit vector `W` to the direction of this special flow. `across` is the direction of the
/// component of W perpendicular to t.
void turn(Special special, const double (&t)[3], double (&W)[3]) {
  double across[3];
  for (std::size_t i = 0; i < 3; ++i) across[i] = W[i] - dot(W, t) * t[i];
  normalise(across);
  for (std::size_t i = 0; i < 3; ++i) {
    if (special == kNoFlow) W[i] = 0;
    if (special == kAlong) W[i] = t[i];
    if (special == kAcross) W[i] = across[i];
    if (special == kNearlyAlong) W[i] = t[i] + kNearly * across[i];
    if (special == kNearlyAcross) W[i] = across[i] + kNearly * t[i];
  }
}

}  // namespace

double not_written() { return std::numeric_limits<double>::quiet_NaN(); }

LawBench::LawBench(const LawType& t, const ConformanceOptions& o)
    : type(t), options(o), sampler(t.parameters, o.seed) {
  for (std::size_t part = 0; part < sampler.parts(); ++part) {
    values.push_back(sampler.parameters(part));
    parameters.emplace_back(t.parameters, t.law.parameter_bytes, values.back(), faults);
    tiles.push_back(sample());
  }
}

Flows LawBench::sample() {
  const std::vector<double> three(3 * kLanes, 0.0), one(kLanes, 0.0);
  Flows f{NETLOFT_LANES, three, three, one, one};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    double t[3], W[3];
    sampler.direction(t);
    sampler.direction(W);
    const auto special = static_cast<Special>(lane % 8);
    turn(special, t, W);
    const double speed =
        std::exp(sampler.uniform(std::log(0.01), std::log(5.0))) * (special == kSlow ? 1e-3 : 1);
    for (std::size_t i = 0; i < 3; ++i) {
      f.flow[at(i, lane)] = speed * W[i];
      f.direction[at(i, lane)] = t[i];
    }
    f.diameter[lane] = std::exp(sampler.uniform(std::log(1e-3), std::log(0.1)));
    f.solidity[lane] = sampler.uniform(0, 1) < 0.25 ? 0 : sampler.uniform(0, 0.9);
  }
  return f;
}

bool LawBench::call(std::size_t part, const netloft_law_tile& flow, std::string& thrown) const {
  const int status =
      call_plugin({type.type.c_str(), "evaluate", nullptr, CallFrame::Kind::element}, int{NETLOFT_ERROR},
                  [&] { return type.law.evaluate(parameters[part].data(), &flow); });
  if (std::string broken = take_broken_rule(); !broken.empty()) {
    thrown = std::move(broken);
    return false;
  }
  return status == NETLOFT_OK;
}

LawAnswer LawBench::evaluate(std::size_t part, const Flows& flows, bool derivatives) const {
  LawAnswer a;
  a.force.assign(3 * kLanes, not_written());
  netloft_law_tile f{};
  f.size = sizeof f;
  f.count = flows.count;
  f.water_density = 1025;
  f.water_viscosity = 1.19e-6;
  f.flow = flows.flow.data();
  f.direction = flows.direction.data();
  f.diameter = flows.diameter.data();
  f.solidity = flows.solidity.data();
  f.force = a.force.data();
  if (derivatives) {
    a.d_flow.assign(9 * kLanes, not_written());
    a.d_direction = a.d_flow;
    a.d_solidity = a.force;
    f.d_flow = a.d_flow.data();
    f.d_direction = a.d_direction.data();
    f.d_solidity = a.d_solidity.data();
  }
  a.ok = call(part, f, a.thrown);
  return a;
}

std::string LawBench::place(std::size_t part, std::size_t lane) const {
  const std::string special = kNames[lane % 8];
  return "parameters " + std::to_string(part) + ", flow " + std::to_string(lane) +
         (special.empty() ? "" : " (" + special + ")");
}

double LawBench::reach(const Flows& f, std::size_t lane) const {
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) square += f.flow[at(i, lane)] * f.flow[at(i, lane)];
  return std::max(std::sqrt(square), kLeastReach);
}

std::vector<double> LawBench::force_scale(std::size_t part, const Flows& flows) {
  std::vector<double> scale(kLanes, 0.0);
  for (int k = 0; k < 4; ++k) {
    Flows other = flows;
    const std::vector<double> field = random_field();
    for (std::size_t i = 0; i < field.size(); ++i) other.flow[i] = reach(flows, i % kLanes) * field[i];
    // solidity must not be zero: netting without twines has no force
    for (double& S : other.solidity) S = k % 2 ? std::max(S, 0.2) : S;
    const LawAnswer a = evaluate(part, other, false);
    for (std::size_t i = 0; i < a.force.size(); ++i)
      scale[i % kLanes] = std::max(scale[i % kLanes], std::abs(a.force[i]));
  }
  return scale;
}

std::vector<double> LawBench::random_field() {
  std::vector<double> field(3 * kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    double d[3];
    sampler.direction(d);
    for (std::size_t i = 0; i < 3; ++i) field[at(i, lane)] = d[i];
  }
  return field;
}

}  // namespace netloft::conformance
