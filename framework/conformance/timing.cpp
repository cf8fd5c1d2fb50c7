// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/timing.hpp"

#include "framework/conformance/checks.hpp"

namespace netloft::conformance {

namespace {

double nanoseconds_per_element(const Specimen& specimen, const netloft_term& term, const States& s,
                               std::uint32_t want) {
  Answer answer = specimen.evaluate(term, s, want);
  return least_nanoseconds_of([&] {
           specimen.evaluate_into(term, s, want, {}, answer.energy.data(), answer.force.data(),
                                  answer.matrix.data(), answer.memory.data());
         }) /
         s.count;
}

}  // namespace

std::vector<TermTiming> time_terms(const Bench& b) {
  std::vector<TermTiming> timings;
  for (const auto& term : b.type.terms)
    for (const std::uint32_t want :
         {std::uint32_t{NETLOFT_WANT_FORCE}, std::uint32_t{NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT}}) {
      if (wants_matrix(want) && (term.traits & NETLOFT_CONSTANT)) continue;
      timings.push_back(
          {term.name, want_text(want), nanoseconds_per_element(*b.specimen, term, b.tiles[0], want)});
    }
  return timings;
}

}  // namespace netloft::conformance
