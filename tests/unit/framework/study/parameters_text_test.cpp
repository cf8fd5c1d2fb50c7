// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "framework/study/study.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

std::span<const netloft_parameter> newton() { return shipped_plugins().solver("newton").parameters; }

TEST(ParametersText, GivesEachValueTheKindOfItsParameter) {
  const Values values = parse_parameters(newton(), "method=classic,damping=0.25");
  EXPECT_EQ(std::get<std::string>(values.at("method")), "classic");
  EXPECT_EQ(std::get<double>(values.at("damping")), 0.25);
  EXPECT_TRUE(parse_parameters(newton(), "").empty());
}

TEST(ParametersText, IsRefusedWithASentenceWhereItIsWrong) {
  for (const char* text : {"damping", "dumping=1", "damping=much", "damping=-1", "method=other"})
    EXPECT_THROW(parse_parameters(newton(), text), std::invalid_argument) << text;
}

TEST(ParametersText, HasWholeNumbersWhereNoOthersCanBe) {
  const auto lbfgs = shipped_plugins().solver("lbfgs").parameters;
  EXPECT_EQ(std::get<std::int64_t>(parse_parameters(lbfgs, "memory=1e2").at("memory")), 100);
  for (const char* text : {"memory=8.5", "memory=1e300", "memory=nan"})
    EXPECT_THROW(parse_parameters(lbfgs, text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace netloft::test
