// SPDX-License-Identifier: BSD-3-Clause
//
// The checks find the flaw of each wrong element, and no other check fails. See tests/support/wrong_elements.
#include "tests/unit/framework/conformance/wrong_plugins.hpp"

namespace netloft::test {
namespace {

/// Whether this element has a data race, at which the thread sanitizer ends the program.
bool is_a_race([[maybe_unused]] const ElementType& type) {
#if defined(__SANITIZE_THREAD__)
  return type.type == "wrong/shared_scratch";
#else
  return false;
#endif
}

std::vector<const ElementType*> wrong_elements() {
  std::vector<const ElementType*> all;
  for (const char* plugin : {"wrong", "wrong_bodies", "escaping"})
    for (const auto& element : wrong_plugin(plugin).elements)
      if (!is_a_race(element)) all.push_back(&element);
  return all;
}

class WrongElement : public testing::TestWithParam<const ElementType*> {};

TEST_P(WrongElement, FailsTheOneCheckNamedForIt) {
  ConformanceOptions quick;
  quick.timings = false;
  const auto report = check_element(*GetParam(), quick);
  EXPECT_EQ(failed_checks(report), promised(GetParam()->element.doc)) << failures(report);
}

TEST_P(WrongElement, FailsItWithOtherSamplesToo) {
  ConformanceOptions other;
  other.timings = false, other.seed = 20, other.elements = 75;
  const auto report = check_element(*GetParam(), other);
  EXPECT_EQ(failed_checks(report), promised(GetParam()->element.doc)) << failures(report);
}

INSTANTIATE_TEST_SUITE_P(Each, WrongElement, testing::ValuesIn(wrong_elements()), test_name<ElementType>);

TEST(WrongElements, ThereIsOneForEveryCheckButThatOfTheFramework) {
  auto names =
      without(conformance_checks(), wrong_elements(), [](const auto& type) { return type.element.doc; });
#if defined(__SANITIZE_THREAD__)
  names.erase("same-from-two-threads");
#endif
  EXPECT_EQ(names, std::set<std::string>{"refuses-wrong-parameters"});
}

TEST(Conformance, GivesTheSameReportForTheSameSeed) {
  ConformanceOptions quick;
  quick.timings = false;
  const auto& type = *wrong_elements()[1];
  const auto one = check_element(type, quick), two = check_element(type, quick);
  ASSERT_EQ(one.checks.size(), two.checks.size());
  for (std::size_t i = 0; i < one.checks.size(); ++i) {
    EXPECT_EQ(one.checks[i].figure, two.checks[i].figure) << one.checks[i].name;
    EXPECT_EQ(one.checks[i].detail, two.checks[i].detail) << one.checks[i].name;
  }
}

TEST(Conformance, NamesTheTermElementAndCureOfAFailure) {
  const auto& types = wrong_plugin("wrong").elements;
  const auto sign =
      std::find_if(types.begin(), types.end(), [](const auto& t) { return t.type == "wrong/force_sign"; });
  const std::string text = failures(check_element(*sign));
  EXPECT_NE(text.find("wrong/force_sign fails force-is-gradient"), std::string::npos) << text;
  EXPECT_NE(text.find("term elastic, element "), std::string::npos) << text;
  EXPECT_NE(text.find("minus the physical force"), std::string::npos) << text;
}

}  // namespace
}  // namespace netloft::test
