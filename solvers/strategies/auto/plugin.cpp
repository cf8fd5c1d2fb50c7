// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/attempts.hpp"
#include "solvers/strategies/auto/auto.hpp"

using netloft::automatic::Auto;
using netloft::automatic::Options;

NETLOFT_PLUGIN("auto", "0.1.0", "The default strategy") {
  auto& s = plugin.strategy<Auto>(
      "auto", "Attempts that suit the scene, each for a slice of work, then restarts for other shapes");
  s.integer("restarts", &Options::restarts,
            "number of searches for other shapes if compression bears a load, and as many if bending does; "
            "each search costs at most a slice of work more than the first equilibrium",
            0, 1000, 1);
  s.boolean("everywhere", &Options::everywhere,
            "look for other shapes in every scene without dry friction, even if nothing is in compression or "
            "the forces have no energy; without an energy, the first equilibrium is the answer",
            false);
  s.real("slice", &Options::slice, "1",
         "work of the first slice of each attempt and each search for another shape, in Newton iterations on "
         "the mesh of that attempt",
         {.lo = 1, .hi = 1e9, .fallback = 200});
  s.several("without", &Options::without,
            "names of attempts or other parts of the strategy that are left out",
            netloft::automatic::parts());
}
