// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/interior_point.hpp"
#include "solvers/strategies/tension/stages.hpp"

namespace netloft::tension {

/// The interior point of members that bear tension only, then the analysis' solver on the scene from there.
struct Only {
  using Parameters = InteriorPoint::Parameters;
  static void describe(StrategyTable<Only>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

/// From soft to stiff with tensions as unknowns, then the analysis' solver on the scene from there.
struct FromSoft {
  using Parameters = Stages::Parameters;
  static void describe(StrategyTable<FromSoft>& table);
  static void run(const Parameters& parameters, Search& search);
  static std::string explain(const Parameters& parameters, Search& search);
};

}  // namespace netloft::tension
