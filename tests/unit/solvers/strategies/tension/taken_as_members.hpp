// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/search/member_problem.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "solvers/strategies/tension/strategies.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <cstring>
#include <stdexcept>

namespace netloft::tension {

/// The default parameters of a strategy.
template <class Strategy>
typename Strategy::Parameters defaults() {
  StrategyTable<Strategy> table("", "");
  Strategy::describe(table);
  std::vector<std::string> faults;
  const ParameterBlock block(table.rows(), sizeof(typename Strategy::Parameters), {}, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  typename Strategy::Parameters parameters;
  std::memcpy(static_cast<void*>(&parameters), block.data(), sizeof parameters);
  return parameters;
}

/// A scene in the form of members and other forces, which methods of solvers/strategies/tension solve.
struct TakenAsMembers {
  explicit TakenAsMembers(const Scene& scene, const Limits& limits = {},
                          const std::function<void(const IterationRecord&)>& on_iteration = {})
      : assembled(scene),
        problem(assembled.assembler, make_factorisation, limits, on_iteration),
        u(problem.interface().unknowns, 0.0) {}

  /// Positions of the nodes, 3 each [m].
  std::vector<double> positions() const {
    const Assembler& assembler = assembled.assembler;
    std::vector<double> x = assembler.start(), all(assembled.scene.positions.size());
    assembler.place(u, x);
    for (std::uint32_t i = 0; i < all.size(); ++i)
      all[i] = x[assembler.numbering().dof(i / 3, static_cast<int>(i % 3)).at()];
    return all;
  }

  test::Assembled assembled;
  MemberProblem problem;
  std::vector<double> u;
};

}  // namespace netloft::tension
