// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/step_methods.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

TEST(StepMethods, AreThoseOfTheAnalysis) {
  scenes::Dynamics dynamics;
  dynamics.integrator = "newmark";
  const ChosenStepMethods chosen(dynamics, "chord", {}, test::shipped_plugins());
  EXPECT_EQ(chosen.methods().integrator.type, &test::shipped_plugins().integrator("newmark"));
  EXPECT_EQ(chosen.methods().solver.type, &test::shipped_plugins().solver("chord"));
}

TEST(StepMethods, AreRefusedWithParametersThatTheyDoNotHave) {
  scenes::Dynamics dynamics;
  dynamics.integrator = "newmark";
  EXPECT_THROW(ChosenStepMethods(dynamics, "chord", {{"nonsense", 1.0}}, test::shipped_plugins()),
               std::invalid_argument);
}

}  // namespace
}  // namespace netloft::runs
