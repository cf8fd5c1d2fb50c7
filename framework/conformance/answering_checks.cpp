// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <cmath>
#include <limits>

namespace netloft::conformance {

namespace {

/// Name of the first number of element `lane` that is not finite, such as "force[4]"; empty if all are
/// finite.
std::string not_finite(const std::vector<double>& values, const char* name, std::size_t lane) {
  for (std::size_t row = 0; row * kLanes < values.size(); ++row)
    if (!std::isfinite(values[at(row, lane)])) return std::string(name) + "[" + std::to_string(row) + "]";
  return {};
}

std::string not_finite(const Answer& a, std::size_t lane) {
  for (const auto& fault : {not_finite(a.energy, "energy", lane), not_finite(a.force, "force", lane),
                            not_finite(a.matrix, "matrix", lane), not_finite(a.memory, "state_new", lane)})
    if (!fault.empty()) return fault;
  return {};
}

/// Describes the first answer, at the states `s`, that is not finite. (A term may refuse states outside its
/// domain.)
std::string fault_of_terms(const Bench& b, const States& s) {
  for (const auto& term : b.type.terms)
    for (const auto want : wants_of(term)) {
      const Answer a = b.specimen->evaluate(term, s, want);
      if (a.status == NETLOFT_OUTSIDE_DOMAIN) continue;
      if (!a.ok()) return b.place(term, s, a.lane_at_fault) + ": " + a.message;
      for (std::size_t lane = 0; lane < s.count; ++lane)
        if (const auto f = not_finite(a, lane); !f.empty())
          return b.place(term, s, lane) + ", output " + want_text(want) + ": " + f + " is not finite";
    }
  return {};
}

std::string fault_of_outputs(const Bench& b, const States& s) {
  if (b.type.outputs.empty()) return {};
  std::vector<double> values(b.type.outputs.size() * kLanes, 0.0);
  if (const Answer a = b.specimen->outputs(s, values); !a.ok()) return "outputs: " + a.message;
  for (std::size_t k = 0; k < b.type.outputs.size(); ++k)
    for (std::size_t lane = 0; lane < s.count; ++lane)
      if (!std::isfinite(values[at(k, lane)]))
        return std::string("output ") + b.type.outputs[k].name + ", element " +
               std::to_string(s.first + lane) + " is not finite";
  return {};
}

/// Evaluates one element (lane) at a time, because a single element outside its domain makes the call fail
/// for the whole tile.
std::string fault_one_by_one(Bench& b, const States& all) {
  for (std::size_t lane = 0; lane < all.count; ++lane) {
    States one = b.tiles[all.first / kLanes];
    for (const auto field : kFields)
      for (std::size_t i = lane; i < (one.*field).size(); i += kLanes) (one.*field)[i] = (all.*field)[i];
    if (auto fault = fault_of_terms(b, one); !fault.empty()) return fault;
  }
  return {};
}

States collapsed(const Bench& b, States s) {
  for (std::size_t d = 3; d < b.dofs(); ++d)
    for (std::size_t lane = 0; lane < kLanes; ++lane) s.x[at(d, lane)] = s.x[at(d % 3, lane)];
  return s;
}

/// States at rest: nothing moves, and neighbouring nodes of an element are the length of the element apart,
/// on a line for pairs of bars and along the axes for other elements. Nothing in the description of an
/// element defines rest more precisely.
States resting(const Bench& b, const States& like) {
  States s = b.blank(like.first, like.count);
  const bool straight = b.type.element.stencil == NETLOFT_BAR_PAIR;
  for (std::size_t lane = 0; lane < s.count; ++lane) {
    const double length = b.sampler.length(b.sample, s.first + lane);
    for (std::size_t node = 1; 3 * node < b.dofs(); ++node)
      if (straight)
        s.x[at(3 * node, lane)] = static_cast<double>(node) * length;
      else
        s.x[at(3 * node + (node - 1) % 3, lane)] = length;
  }
  return s;
}

bool is_refused(const Bench& b, const netloft_parameter& p, double value) {
  Sample wrong = b.sample;
  for (auto& part : wrong.parameters) part[p.name] = value;
  try {
    const Specimen made(b.type, wrong);
    return false;
  } catch (const Refused&) {
    return true;
  } catch (const Escaped&) {
    return false;
  }
}

bool is_refused_missing(const Bench& b, const netloft_parameter& p) {
  Sample wrong = b.sample;
  for (auto& part : wrong.parameters) part.erase(p.name);
  try {
    const Specimen made(b.type, wrong);
    return false;
  } catch (const std::runtime_error&) {
    return true;
  }
}

std::vector<double> wrong_values(const netloft_parameter& p) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::vector<double> wrong = {std::numeric_limits<double>::quiet_NaN(), inf, -inf};
  if (std::isfinite(p.lo)) wrong.push_back(std::nextafter(p.lo, -inf));
  if (std::isfinite(p.hi)) wrong.push_back(std::nextafter(p.hi, inf));
  return wrong;
}

}  // namespace

Finding makes_elements(Bench& b) {
  if (b.specimen || !b.escape.empty()) return {};
  return failed("refused: " + b.refusal);
}

Finding no_exception_escapes(Bench& b) { return judged(b.escape); }

Finding evaluates_without_error(Bench& b) { return judged(b.error); }

Finding outputs_finite(Bench& b) {
  for (const auto& s : b.tiles) {
    if (auto fault = fault_of_terms(b, s); !fault.empty()) return failed(fault);
    if (auto fault = fault_of_outputs(b, s); !fault.empty()) return failed(fault);
  }
  return {};
}

Finding collapsed_finite(Bench& b) {
  if (b.dofs() == 3) return not_applicable("one node cannot collapse");
  if (b.type.is_on_body()) return not_applicable("a body cannot collapse");
  for (const auto& s : b.tiles)
    if (auto fault = fault_one_by_one(b, collapsed(b, s)); !fault.empty()) return failed(fault);
  return {};
}

Finding finite_at_rest(Bench& b) {
  for (const auto& s : b.tiles)
    if (auto fault = fault_one_by_one(b, resting(b, s)); !fault.empty()) return failed(fault);
  return {};
}

Finding defaults_are_allowed(Bench& b) {
  return judged_defaults(b.type.parameters, b.type.element.parameter_bytes, b.sample.parameters[0]);
}

Finding refuses_wrong_parameters(Bench& b) {
  for (const auto& p : b.type.parameters) {
    if ((p.flags & NETLOFT_REQUIRED) && !is_refused_missing(b, p))
      return failed(std::string(p.name) + " is required, but the element is made without it");
    if (p.kind != NETLOFT_REAL) continue;
    for (const double wrong : wrong_values(p))
      if (!is_refused(b, p, wrong))
        return failed(std::string(p.name) + " = " + number_text(wrong) + " is accepted");
  }
  return b.type.parameters.empty() ? not_applicable("the element has no parameters") : Finding{};
}

}  // namespace netloft::conformance
