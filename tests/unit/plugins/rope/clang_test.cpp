// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin built by clang for AVX2 runs in this program, with the same results as the plugin built by the
// program's compiler.
#include "framework/conformance/bench.hpp"
#include "framework/registry/library.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

using namespace netloft::conformance;

const std::string kClang = netloft::test::build_folder() + "/tests/clang/rope.so";
const std::string kShipped = netloft::test::build_folder() + "/lib/netloft/rope.so";

bool runs() {
#if defined(__x86_64__)
  return std::filesystem::exists(kClang) && __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// Largest difference in a lane, divided by the largest number in the lane.
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
  const Bench bench(one.elements[0], {.seed = 3, .elements = 64});
  ASSERT_EQ(bench.tiles.size(), 1u) << bench.refusal;
  const States& states = bench.tiles[0];
  const Specimen &here = *bench.specimen, clang(two.elements[0], bench.sample);
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
