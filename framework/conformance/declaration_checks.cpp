// SPDX-License-Identifier: BSD-3-Clause
//
// Checks that an element reads only the parameters that its table declares, because the host fills no others.
#include "framework/conformance/checks.hpp"

#include <algorithm>

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

/// The first term or output with different answers from two families of the same elements; empty if there is
/// none.
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

/// The function whose result changes with the bytes that no row declares; empty if there is none.
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

}  // namespace netloft::conformance
