// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::runs {

/// Memory that solving a scene will take, foreseen from its pattern before anything is factorised [bytes].
struct MemoryForecast {
  double taken = 0;      // by the program now: plugins, scene, mesh, pattern, and the order of elimination
  double factor = 0;     // of the tangent, and of the equations of a strategy that has other unknowns beside
  double stability = 0;  // beside it, once the equilibrium is found: what its stability is judged by
  double numbers = 0;    // values of matrices, and vectors over the unknowns
  double total() const { return taken + factor + stability + numbers; }
};

/// Analyses the pattern of the scene as the first factorisation will, on the mesh of the scene. The forecast
/// has the factor of the scene, that of a strategy with tensions as unknowns, and that of the judge of
/// stability with its Krylov space. It has neither the coarser meshes of a strategy nor a second
/// factorisation to which the first one hands a matrix over. tests/bench/memory.py compares it with runs.
MemoryForecast foresee_memory(PreparedScene& scene);

/// Memory that this process may have in all [bytes]: its own, and what the machine, its group (memory.max of
/// cgroup 2) and its limit of addresses (ulimit -v) leave. Infinite if none of these is known.
double memory_within_reach();

}  // namespace netloft::runs
