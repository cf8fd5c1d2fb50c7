// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/motion_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft::results {
namespace {

/// The report of a motion whose path was compared with another.
std::string told(double path, double unpredictable_from) {
  AchievedAccuracy a{.asked = 0.01, .element = 2, .allowed = 0.01};
  a.is_checked = true, a.path = path, a.path_at = 0.5, a.path_of = "rope node 3";
  a.unpredictable_from = unpredictable_from;
  Result result;
  result.motion.emplace().accuracy = a;
  return motion_text(result);
}

constexpr double kUnknown = NamedScalar::kUnknown, kNever = std::numeric_limits<double>::infinity();

bool has(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

TEST(MotionText, SaysThatAMotionIsChaoticFromItsFirstOutput) {
  const std::string text = told(kUnknown, 0.1);
  EXPECT_TRUE(has(text, "warning: the motion is chaotic")) << text;
  EXPECT_FALSE(has(text, "took the same steps")) << text;
}

TEST(MotionText, SaysThatAMotionIsChaoticWhosePathHadNoErrorBefore) {
  const std::string text = told(0, 0.6);
  EXPECT_TRUE(has(text, "warning: the motion is chaotic")) << text;
  EXPECT_TRUE(has(text, "error of the path until it cannot be predicted: none")) << text;
}

TEST(MotionText, SaysThatAMotionIsChaoticBeforeTheErrorOfItsPath) {
  const std::string text = told(0.003, 0.6);
  const auto chaos = text.find("the motion is chaotic"), error = text.find("error of the path until it");
  ASSERT_NE(error, std::string::npos) << text;
  EXPECT_LT(chaos, error) << text;
}

TEST(MotionText, SaysThatAPathIsNotKnownWithoutChaos) {
  const std::string text = told(kUnknown, kNever);
  EXPECT_TRUE(has(text, "took the same steps")) << text;
  EXPECT_FALSE(has(text, "chaotic")) << text;
}

}  // namespace
}  // namespace netloft::results
