// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/calibration.hpp"

#include <gtest/gtest.h>

namespace netloft::studies {
namespace {

/// A calibration of one scene with two variables, fitted to one measurement; a second measurement is held
/// back.
Calibration done(double correlation) {
  Calibration c;
  c.file.name = "study", c.file.scenes = {{"slow", "slow.toml", {}, {}}};
  for (const char* name : {"drag", "diameter"}) {
    Variable v;
    v.name = name, v.keys = {{std::string("a.") + name}}, v.interval = {0, 2};
    c.file.variables.push_back({v, {Distribution::Kind::normal, 1, 0.5}, {0}, true});
  }
  c.file.measured = {{0, "results/held", {}, {}, "", "", true}, {0, "results/pull", {}, {}, "", "", false}};
  c.measured = {{20, 1}, {10, 1}}, c.units = {"N", "N"}, c.order = {1, 0};
  c.fit.converged = true, c.fit.reason = "it is there";
  c.fit.parameters = {1.1, 0.9}, c.fit.deviations = {0.1, 0.49}, c.fit.at_end = {false, false};
  c.fit.correlations = {{1, correlation}, {correlation, 1}};
  c.fit.predictions = {10.5, 26}, c.fit.model_deviations = {0.5, 2};
  return c;
}

TEST(Calibration, SaysWhatCannotBeToldApart) {
  const std::string text = calibration_text(done(-0.98));
  EXPECT_NE(text.find("drag and diameter cannot be told apart by these measurements: correlation -0.98"),
            std::string::npos)
      << text;
  EXPECT_EQ(calibration_text(done(-0.9)).find("told apart"), std::string::npos);
}

TEST(Calibration, SaysWhatTheMeasurementsDoNotKnow) {
  const std::string text = calibration_text(done(0));
  EXPECT_NE(text.find("say little about diameter"), std::string::npos) << text;
  EXPECT_EQ(text.find("say little about drag"), std::string::npos) << text;
}

TEST(Calibration, ShowsWhatWasHeldBackApartAndWhatLiesOutsideItsBand) {
  const std::string text = calibration_text(done(0));
  const auto fitted = text.find("results/pull"), held = text.find("results/held");
  ASSERT_NE(held, std::string::npos);
  EXPECT_LT(fitted, text.find("held back, only predicted"));
  EXPECT_GT(held, text.find("held back, only predicted"));
  EXPECT_NE(text.find("+30.0 % N   outside its band"), std::string::npos) << text;  // 1.645 √(2² + 1²) < 6
}

TEST(Calibration, WritesWordsThatRepeatIt) {
  const std::string text = calibration_text(done(0));
  EXPECT_NE(text.find("netloft run slow.toml --set \"a.drag=1.1\" --set \"a.diameter=0.9\""),
            std::string::npos)
      << text;
}

TEST(Calibration, GivesOnlyVariablesToTheScenesThatHaveThem) {
  Calibration c = done(0);
  c.file.scenes.push_back({"fast", "fast.toml", {}, {"x=1"}});
  EXPECT_EQ(overrides_of(c.file, 1, c.fit.parameters), std::vector<std::string>{"x=1"});
}

}  // namespace
}  // namespace netloft::studies
