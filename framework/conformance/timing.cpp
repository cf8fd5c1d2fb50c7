// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <chrono>

namespace netloft::conformance {

namespace {

constexpr int kRepeats = 15;
constexpr int kCallsPerRepeat = 100;

/// The least of several repeats, since everything that disturbs a measurement makes it longer.
double nanoseconds_per_element(const Specimen& specimen, const netloft_term& term, const States& s,
                               std::uint32_t want) {
  using Clock = std::chrono::steady_clock;
  Answer answer = specimen.evaluate(term, s, want);
  double least = 1e300;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto start = Clock::now();
    for (int call = 0; call < kCallsPerRepeat; ++call)
      specimen.evaluate_into(term, s, want, {}, answer.energy.data(), answer.force.data(),
                             answer.matrix.data(), answer.memory.data());
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    least = std::min(least, spent.count() / kCallsPerRepeat / s.count);
  }
  return least;
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
