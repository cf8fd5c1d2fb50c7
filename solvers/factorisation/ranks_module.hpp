// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// What the module of MPI and parallel MUMPS exports (ranks_module.cpp). Programs are built without MPI and
/// open it only when a launcher has started several of them.
struct RanksModule {
  const char* mumps_version;
  std::size_t structure_bytes;  // of DMUMPS_STRUC_C, which the program and the module have to see alike
  /// Starts MPI in this process. Returns null, or why it cannot be used.
  const char* (*start)(int* rank, int* size);
  /// On rank 0: runs the job of a DMUMPS_STRUC_C on all ranks. `instance`: its number there.
  void (*call)(int instance, void* mumps);
  /// On all others: takes part in such calls until rank 0 stops.
  void (*serve)();
  void (*stop)();
};

inline constexpr const char* kRanksSymbol = "netloft_ranks_v1";
using RanksFunction = const RanksModule* (*)();

}  // namespace netloft
