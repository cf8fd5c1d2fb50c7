// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::runs {

/// Forecast of the memory for solving a scene, from its pattern before any factorisation [bytes].
struct MemoryForecast {
  double taken = 0;      // memory in use now: plugins, scene, mesh, pattern, elimination order
  double factor = 0;     // factor of the tangent, and of the system of a strategy with other unknowns
  double stability = 0;  // additional memory for the stability check of the equilibrium
  double numbers = 0;    // values of matrices, and vectors over the unknowns
  double total() const { return taken + factor + stability + numbers; }
};

/// Analyses the pattern of the scene, on its own mesh, as the first factorisation will. The forecast includes
/// the factor of the scene, that of a strategy with tensions as unknowns, and that of the stability check
/// with its Krylov space. It excludes the coarser meshes of a strategy and a second factorisation to
/// which the first one passes a matrix. tests/bench/memory.py compares it with runs.
MemoryForecast foresee_memory(PreparedScene& scene);

/// Total memory available to this process [bytes]: its present memory, plus what the machine, its control
/// group (memory.max of cgroup 2) and its address limit (ulimit -v) allow. Infinite if none of these is
/// known.
double memory_within_reach();

}  // namespace netloft::runs
