// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

#include <string>
#include <vector>

namespace netloft::automatic {

/// One attempt to find an equilibrium by another strategy.
struct Attempt {
  const char* name;        // used in `without` and in the report
  const char* strategy;    // the strategy that runs
  const char* parameters;  // parameters of the strategy
  const char* because;     // why the strategy is tried, printed by `netloft plan`
};

/// The attempts that suit a scene, in the order in which they are tried.
std::vector<Attempt> attempts_for(const Search& search, const Options& options);

/// All parts that a user may leave out.
std::vector<const char*> parts();

/// Whether a part of the strategy is left out by the user.
bool is_left_out(const Options& options, const std::string& part);

}  // namespace netloft::automatic
