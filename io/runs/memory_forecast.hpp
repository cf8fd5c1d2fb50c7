// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::runs {

/// Forecast of the memory that solving a scene needs [bytes], made from the pattern of its matrix before any
/// factorisation.
struct MemoryForecast {
  double taken = 0;      // memory in use now: plugins, scene, mesh, pattern, elimination order
  double factor = 0;     // factor of the tangent, and of the system with tensions as unknowns
  double stability = 0;  // additional memory for the stability check of the equilibrium
  double numbers = 0;    // values of matrices, and vectors over the unknowns
  double total() const { return taken + factor + stability + numbers; }
};

/// Orders and analyses the matrix pattern of the scene, as its first factorisation will. The forecast
/// includes the factor of the scene, the factor of a strategy with tensions as unknowns, and the matrices and
/// the Krylov space of the stability check. It excludes the coarser meshes of a strategy, and the second
/// factorisation that is used if the first one fails. tests/bench/memory.py compares the forecast with the
/// memory of runs.
MemoryForecast foresee_memory(PreparedScene& scene);

/// Memory available to this process [bytes]: its present memory, plus what the machine, its control group
/// (memory.max of cgroup 2) and its address limit (ulimit -v) allow. Infinite if none of these is known.
double memory_within_reach();

}  // namespace netloft::runs
