// SPDX-License-Identifier: BSD-3-Clause
//
// A test fixture that asks solvers of different kinds for the same known answers.
#pragma once
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/scene_file.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace netloft::test {

/// A solver with the value of one of its options.
struct Way {
  const char* name;
  const char* solver;
  const char* choice = nullptr;
  const char* made = nullptr;
  const char* of_a_loose_load = "singular";  // part of its message for a loose load

  Values parameters() const { return choice ? Values{{choice, std::string(made)}} : Values{}; }
  /// The solver and its option as settings of a scene file.
  std::vector<std::string> overrides() const {
    const std::string analysis = "analysis.";
    std::vector<std::string> all{analysis + "solver=" + solver};
    if (choice) all.push_back(analysis + solver + "." + choice + "=" + made);
    return all;
  }
};

inline void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }
inline std::string name_of(const testing::TestParamInfo<Way>& given) { return given.param.name; }

class KnownAnswers : public testing::TestWithParam<Way> {
 protected:
  static Solved solve_so(const Scene& scene, Limits limits = {}) {
    return solve_with(GetParam().solver, scene, GetParam().parameters(), limits);
  }
  static SolvedFile solve_file_so(const std::string& name, std::vector<std::string> overrides) {
    const auto way = GetParam().overrides();
    overrides.insert(overrides.end(), way.begin(), way.end());
    return solve_file(name, overrides);
  }
};

/// Known answers with forces that have no potential, for solvers that do not need one.
class KnownAnswersWithoutEnergy : public KnownAnswers {};

}  // namespace netloft::test
