// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "framework/search/named_component.hpp"
#include "framework/search/search.hpp"
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
  for (const char* text :
       {"damping", "dumping=1", "damping=much", "damping=-1", "method=other", "damping=1,damping=2"})
    EXPECT_THROW(parse_parameters(newton(), text), std::invalid_argument) << text;
}

TEST(ParametersText, HasWholeNumbersWhereNoOthersCanBe) {
  const auto lbfgs = shipped_plugins().solver("lbfgs").parameters;
  EXPECT_EQ(std::get<std::int64_t>(parse_parameters(lbfgs, "memory=1e2").at("memory")), 100);
  for (const char* text : {"memory=8.5", "memory=1e300", "memory=nan"})
    EXPECT_THROW(parse_parameters(lbfgs, text), std::invalid_argument) << text;
}

const netloft_parameter& parameter_of(const std::string& strategy, const std::string& name) {
  for (const auto& p : shipped_plugins().strategy(strategy).parameters)
    if (name == p.name) return p;
  throw std::logic_error("no such parameter");
}

void check(const std::string& strategy, const std::string& name, const std::string& specification) {
  check_named(parameter_of(strategy, name), specification, shipped_plugins());
}

TEST(NamedComponent, IsOneThatIsThereWithParametersThatAreRight) {
  check("relaxed", "solver", "newton:method=classic;damping=1");
  check("coarse-to-fine", "by", "coarse-to-fine:by=auto:restarts=0");
  check("coarse-to-fine", "then", "");
}

TEST(NamedComponent, IsRefusedWhereItLeadsBackToACaller) {
  const auto by = [](const char* strategy) { return Values{{"by", std::string(strategy)}}; };
  const auto why = [](const std::string& specification, const GivenValues& given) -> std::string {
    try {
      check_named(parameter_of("coarse-to-fine", "by"), specification, shipped_plugins(), given,
                  {"coarse-to-fine/coarse-to-fine"});
      return "";
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
  };
  const std::string itself = "makes coarse-to-fine/coarse-to-fine call itself without end";
  EXPECT_NE(why("coarse-to-fine", {}).find(itself), std::string::npos);
  EXPECT_NE(why("deflation", {{"deflation/deflation", by("coarse-to-fine")}}).find(itself),
            std::string::npos);
  EXPECT_NE(why("deflation:by=coarse-to-fine", {}).find(itself), std::string::npos);
  // A value given by the user replaces the value in the specification.
  EXPECT_NE(why("deflation:by=direct", {{"deflation/deflation", by("coarse-to-fine")}}).find(itself),
            std::string::npos);
  EXPECT_EQ(why("deflation:by=coarse-to-fine", {{"deflation/deflation", by("direct")}}), "");
  EXPECT_EQ(why("deflation:by=auto", {}), "");
}

TEST(NamedComponent, IsRefusedWhereItIsNotThere) {
  EXPECT_THROW(check("relaxed", "solver", "newtn"), UnknownComponent);
  EXPECT_THROW(check("relaxed", "solver", "direct"), UnknownComponent);
  EXPECT_THROW(check("coarse-to-fine", "by", "coarse-to-fine:by=newton"), UnknownComponent);
}

TEST(NamedComponent, IsRefusedWhereItsParametersAreWrong) {
  for (const char* by : {"", ":restarts=0", "auto:restrts=0", "auto:restarts=1;restarts=2",
                         "auto:without=nothing", "coarse-to-fine:by=auto:restarts=-1"})
    EXPECT_THROW(check("coarse-to-fine", "by", by), std::invalid_argument) << by;
}

}  // namespace
}  // namespace netloft::test
