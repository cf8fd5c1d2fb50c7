// SPDX-License-Identifier: BSD-3-Clause
//
// Checks that an element reads only what it declares: the parameters in its table, and the inputs for which a
// term has traits. The host provides nothing else.
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <limits>

namespace netloft::conformance {

namespace {

bool same_answer(const Answer& a, const Answer& b, std::size_t count) {
  if (a.status != b.status) return false;
  for (std::size_t lane = 0; lane < count; ++lane)
    if (!same_lane(a.energy, lane, b.energy, lane) || !same_lane(a.force, lane, b.force, lane) ||
        !same_lane(a.matrix, lane, b.matrix, lane) || !same_lane(a.memory, lane, b.memory, lane))
      return false;
  return true;
}

/// The first term or output that differs between two families of the same elements; empty if there is none.
std::string first_difference(const Bench& b, const Specimen& other, const States& s) {
  for (const auto& term : b.type.terms)
    for (const auto want : wants_of(term))
      if (!same_answer(b.specimen->evaluate(term, s, want), other.evaluate(term, s, want), s.count))
        return "term " + std::string(term.name);
  std::vector<double> here(b.type.outputs.size() * kLanes, 0.0), there = here;
  if (here.empty()) return {};
  if (b.specimen->outputs(s, here).status != other.outputs(s, there).status) return "the outputs";
  for (std::size_t k = 0; k < here.size(); ++k)
    if (!same_bits(here[k], there[k])) return "output " + std::string(b.type.outputs[k / kLanes].name);
  return {};
}

/// Overwrites bytes of the parameters that no row of the table declares. Returns the name of a function whose
/// result changes; empty if none does.
std::string reader_of(const Bench& b, const ByteRange& range) {
  Sample spoilt = b.sample;
  spoilt.spoilt = {range};
  try {
    const Specimen other(b.type, spoilt);
    for (const auto& s : b.tiles)
      if (auto difference = first_difference(b, other, s); !difference.empty()) return difference;
    return {};
  } catch (const std::runtime_error&) {
    return "create";
  }
}

}  // namespace

std::string undeclared_text(const ByteRange& range) {
  return "bytes " + std::to_string(range.begin) + " to " + std::to_string(range.end) +
         " of its parameters, which no row of its table declares and the host leaves zero";
}

Finding reads_what_it_declares(Bench& b) {
  const auto ranges = undeclared(b.type.parameters, b.type.element.parameter_bytes);
  if (ranges.empty()) return not_applicable("its table declares every byte of its parameters");
  std::string fault;
  for (const auto& range : ranges)
    if (const auto reader = reader_of(b, range); !reader.empty())
      fault += (fault.empty() ? "" : "; ") + reader + " reads " + undeclared_text(range);
  return judged(fault);
}

namespace {

/// An input that terms with the trait `trait` receive. Terms with the trait `also` may read it, too.
struct Input {
  std::uint32_t trait;
  const char* text;
  std::uint32_t also = 0;
};
constexpr Input kInputs[] = {
    {NETLOFT_READS_VELOCITY, "velocities without the trait reads_velocity"},
    {NETLOFT_READS_ACCELERATION, "accelerations without the trait reads_acceleration"},
    {NETLOFT_READS_CURRENT, "the current without the trait reads_current"},
    {NETLOFT_READS_STATE, "the memory of the element without the trait reads_state"},
    {NETLOFT_READS_TIME, "the time without the trait reads_time", NETLOFT_READS_WAVES},
    {NETLOFT_READS_GROUND, "the velocity of the ground without the trait reads_ground"},
    {NETLOFT_READS_BED, "the bed of the scene without the trait reads_bed"},
    {NETLOFT_READS_WAVES, "acceleration and surface of the water without the trait reads_waves"}};

/// Returns the states with other values of one input: NaN if `no_numbers`, else numbers that differ between
/// entries. Every term receives this input, whatever its traits.
States with_other(const Bench& b, const States& from, std::uint32_t trait, bool no_numbers) {
  const auto value = [&](std::size_t i) {
    return no_numbers ? std::numeric_limits<double>::quiet_NaN() : 0.75 + 0.25 * static_cast<double>(i % 7);
  };
  const auto fill = [&](std::vector<double>& field, std::size_t rows) {
    field.resize(rows * kLanes);
    for (std::size_t i = 0; i < field.size(); ++i) field[i] = value(i / kLanes + i % kLanes);
  };
  const std::size_t dofs = b.dofs();
  States to = from;
  to.exposed = trait;
  if (trait & NETLOFT_READS_VELOCITY) fill(to.v, dofs);
  if (trait & NETLOFT_READS_ACCELERATION) fill(to.a, dofs);
  if (trait & NETLOFT_READS_CURRENT) fill(to.current, dofs), fill(to.current_dz, dofs);
  if (trait & NETLOFT_READS_STATE) fill(to.memory, b.type.state_width);
  if (trait & NETLOFT_READS_TIME) to.time = value(0) + 1;
  if (trait & NETLOFT_READS_GROUND) to.ground = {value(0), value(1), 0};
  if (trait & NETLOFT_READS_BED) fill(to.bed, 6 * static_cast<std::size_t>(b.type.nodes()));
  if (trait & NETLOFT_READS_WAVES) fill(to.swing, dofs), fill(to.surface, dofs / 3);
  return to;
}

/// Whether the answer of a term changes with an input that the term does not declare.
bool reads(const Bench& b, const netloft_term& term, const States& s, const Input& input) {
  for (const bool no_numbers : {false, true}) {
    const States other = with_other(b, s, input.trait, no_numbers);
    for (const auto want : wants_of(term))
      if (!same_answer(b.specimen->evaluate(term, s, want), b.specimen->evaluate(term, other, want), s.count))
        return true;
  }
  return false;
}

}  // namespace

Finding reads_the_inputs_it_declares(Bench& b) {
  std::string fault;
  for (const auto& term : b.type.terms)
    for (const auto& input : kInputs)
      if (!(term.traits & (input.trait | input.also)) &&
          std::ranges::any_of(b.tiles, [&](const States& s) { return reads(b, term, s, input); }))
        fault += (fault.empty() ? "" : "; ") + ("term " + std::string(term.name)) + " reads " + input.text;
  return judged(fault);
}

}  // namespace netloft::conformance
