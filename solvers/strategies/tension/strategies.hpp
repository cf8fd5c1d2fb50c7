// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/interior_point.hpp"
#include "solvers/strategies/tension/stages.hpp"

namespace netloft::tension {

/// Solves with members that bear tension only by the interior-point method, then the scene itself from there
/// with the solver of the analysis.
struct Only {
  using Parameters = InteriorPoint::Parameters;
  static void describe(StrategyTable<Only>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

/// Solves from soft to stiff with tensions as unknowns, then the scene itself from there with the solver of
/// the analysis.
struct FromSoft {
  using Parameters = Stages::Parameters;
  static void describe(StrategyTable<FromSoft>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

}  // namespace netloft::tension
