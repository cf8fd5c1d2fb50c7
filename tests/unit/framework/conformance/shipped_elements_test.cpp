// SPDX-License-Identifier: BSD-3-Clause
//
// All shipped components pass the checks, and all builds of a component give the same bits.
#include "framework/conformance/law_bench.hpp"
#include "framework/registry/library.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iostream>

namespace {

namespace fs = std::filesystem;
using namespace netloft::conformance;

const fs::path kFolder = netloft::test::build_folder() + "/lib/netloft";

bool has_v3(const std::string& plugin) {
  return netloft::best_build(kFolder, plugin).parent_path() != kFolder;
}

/// All shipped plugins.
std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".so") continue;
    const auto content = netloft::open_library(entry.path());
    if (!content.elements.empty() || !content.laws.empty() || !content.solvers.empty() ||
        !content.integrators.empty() || !content.strategies.empty())
      names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Shipped : public testing::TestWithParam<std::string> {};

void expect_conformance(const netloft::ConformanceReport& report, const fs::path& file) {
  EXPECT_TRUE(report.passed()) << failures(report);
  for (const auto& t : report.timings)
    std::cout << file.string() << ' ' << report.type << ' ' << t.term << ' ' << t.want << ": "
              << t.nanoseconds << " ns per " << t.per << '\n';
}

void expect_conformance(const fs::path& file) {
  const auto content = netloft::open_library(file);
  for (const auto& type : content.elements) expect_conformance(netloft::check_element(type), file);
  for (const auto& type : content.laws) expect_conformance(netloft::check_law(type), file);
  for (const auto& type : content.solvers) expect_conformance(netloft::check_solver(type), file);
  for (const auto& type : content.integrators) expect_conformance(netloft::check_integrator(type), file);
  for (const auto& type : content.strategies) expect_conformance(netloft::check_strategy(type), file);
}

TEST_P(Shipped, KeepsItsPromises) { expect_conformance(kFolder / (GetParam() + ".so")); }

TEST_P(Shipped, KeepsItsPromisesBuiltForAvx2) {
  if (!has_v3(GetParam()))
    GTEST_SKIP() << "there is no build for x86-64-v3, or this processor does not run it";
  expect_conformance(kFolder / "x86-64-v3" / (GetParam() + ".so"));
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

TEST_P(Shipped, GivesTheSameBitsInEveryBuild) {
  if (!has_v3(GetParam()))
    GTEST_SKIP() << "there is no build for x86-64-v3, or this processor does not run it";
  const auto base = netloft::open_library(kFolder / (GetParam() + ".so"));
  const auto v3 = netloft::open_library(kFolder / "x86-64-v3" / (GetParam() + ".so"));
  for (std::size_t k = 0; k < base.elements.size(); ++k) {
    const Bench bench(base.elements[k], {.seed = 7, .elements = 64});
    ASSERT_TRUE(bench.specimen && bench.tiles.size() == 1) << base.elements[k].type << ": " << bench.refusal;
    const States& states = bench.tiles[0];
    const Specimen &one = *bench.specimen, two(v3.elements[k], bench.sample);
    for (std::size_t t = 0; t < base.elements[k].terms.size(); ++t)
      for (const auto want : wants_of(base.elements[k].terms[t])) {
        const Answer a = one.evaluate(base.elements[k].terms[t], states, want);
        const Answer b = two.evaluate(v3.elements[k].terms[t], states, want);
        EXPECT_TRUE(same_bits(a.energy, b.energy) && same_bits(a.force, b.force) &&
                    same_bits(a.matrix, b.matrix) && same_bits(a.memory, b.memory))
            << base.elements[k].type << ' ' << base.elements[k].terms[t].name << ' ' << want_text(want);
      }
  }
}

TEST_P(Shipped, GivesTheSameBitsOfItsLawsInEveryBuild) {
  if (!has_v3(GetParam()))
    GTEST_SKIP() << "there is no build for x86-64-v3, or this processor does not run it";
  const auto base = netloft::open_library(kFolder / (GetParam() + ".so"));
  const auto v3 = netloft::open_library(kFolder / "x86-64-v3" / (GetParam() + ".so"));
  for (std::size_t k = 0; k < base.laws.size(); ++k) {
    const LawBench one(base.laws[k], {.seed = 7}), two(v3.laws[k], {.seed = 7});
    for (std::size_t part = 0; part < one.tiles.size(); ++part) {
      const LawAnswer a = one.evaluate(part, one.tiles[part], true),
                      b = two.evaluate(part, one.tiles[part], true);
      EXPECT_TRUE(same_bits(a.force, b.force) && same_bits(a.d_flow, b.d_flow) &&
                  same_bits(a.d_direction, b.d_direction) && same_bits(a.d_solidity, b.d_solidity))
          << base.laws[k].type;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Shipped, testing::ValuesIn(shipped()),
                         [](const testing::TestParamInfo<std::string>& plugin) {
                           std::string name = plugin.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
