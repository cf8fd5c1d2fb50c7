// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/interior_point.hpp"
#include "solvers/strategies/tension/stages.hpp"

namespace netloft::tension {

/// Solves the scene by the interior-point method, with members that bear tension only. From the result, the
/// solver of the analysis then solves the scene itself.
struct Only {
  using Parameters = InteriorPoint::Parameters;
  static void describe(StrategyTable<Only>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

/// Solves stages from soft to stiff with tensions as unknowns. From the result, the solver of the analysis
/// then solves the scene itself.
struct FromSoft {
  using Parameters = Stages::Parameters;
  static void describe(StrategyTable<FromSoft>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

}  // namespace netloft::tension
