// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin built by clang for AVX2 runs in this program and agrees with the one built beside it.
#include "framework/conformance/conformance.hpp"
#include "framework/conformance/sampler.hpp"
#include "framework/registry/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

using namespace netloft::conformance;

const char* kClang = NETLOFT_BINARY_DIR "/tests/clang/rope.so";
const char* kShipped = NETLOFT_BINARY_DIR "/lib/netloft/rope.so";

bool runs() {
#if defined(__x86_64__)
  return std::filesystem::exists(kClang) && __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// Largest difference in a lane over the largest number in it.
double worst_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    double difference = 0, size = 0;
    for (std::size_t i = lane; i < a.size(); i += kLanes) {
      difference = std::max(difference, std::abs(a[i] - b[i]));
      size = std::max(size, std::abs(a[i]));
    }
    worst = std::max(worst, difference == 0 ? 0 : difference / size);
  }
  return worst;
}

TEST(RopeByClang, AgreesWithThisCompilersTo1e12) {
  if (!runs()) GTEST_SKIP() << "no clang++, or no AVX2 here";
  const auto one = netloft::open_library(kShipped), two = netloft::open_library(kClang);
  EXPECT_NE(two.origin.compiler.find("Clang"), std::string::npos) << two.origin.compiler;
  Sampler sampler(one.elements[0], 3);
  Sample sample;
  for (std::size_t p = 0; p < sampler.parts(); ++p) sample.parameters.push_back(sampler.parameters(p));
  for (std::uint32_t e = 0; e < kLanes; ++e)
    sample.part.push_back(e % static_cast<std::uint32_t>(sampler.parts()));
  for (std::size_t e = 0; e < kLanes; ++e) sampler.data(sample, e);
  const std::vector<double> zero(6 * kLanes, 0.0);
  States states{0, kLanes, zero, zero, zero, zero, zero};
  for (std::size_t lane = 0; lane < kLanes; ++lane) sampler.state(sample, lane, states, lane);

  const Specimen here(one.elements[0], sample), clang(two.elements[0], sample);
  for (std::size_t t = 0; t < one.elements[0].terms.size(); ++t)
    for (const auto want : wants_of(one.elements[0].terms[t])) {
      const Answer a = here.evaluate(one.elements[0].terms[t], states, want);
      const Answer b = clang.evaluate(two.elements[0].terms[t], states, want);
      EXPECT_LE(worst_difference(a.energy, b.energy), 1e-12) << want_text(want);
      EXPECT_LE(worst_difference(a.force, b.force), 1e-12) << want_text(want);
      EXPECT_LE(worst_difference(a.matrix, b.matrix), 1e-12) << want_text(want);
    }
}

TEST(RopeByClang, KeepsItsPromises) {
  if (!runs()) GTEST_SKIP() << "no clang++, or no AVX2 here";
  const auto content = netloft::open_library(kClang);
  netloft::ConformanceOptions quick;
  quick.timings = false;
  const auto report = netloft::check_element(content.elements.at(0), quick);
  EXPECT_TRUE(report.passed()) << failures(report);
}

}  // namespace
