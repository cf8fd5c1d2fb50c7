// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// Work that rank 0 wants done: a job of a DMUMPS_STRUC_C, or one of those in rank_branches.hpp or in
/// framework/ranks/share_orders.hpp, with a number for whoever wants it.
struct RanksOrder {
  enum Kind : int { mumps, branches, shares, end };
  int kind = end, instance = 0, job = 0, symmetry = 0;
};

/// What the module of MPI and parallel MUMPS exports (ranks_module.cpp). Programs are built without MPI and
/// open it only when a launcher has started several of them.
struct RanksModule {
  const char* mumps_version;
  std::size_t structure_bytes;  // of DMUMPS_STRUC_C, which the program and the module have to see alike
  /// Starts MPI in this process. Returns null, or why it cannot be used.
  const char* (*start)(int* rank, int* size);
  /// Rank 0 gives an order, all others wait for it.
  void (*give)(const RanksOrder* order);
  void (*wait)(RanksOrder* order);
  /// Takes part in an order of MUMPS. `structure`: the DMUMPS_STRUC_C on rank 0, null on others.
  void (*run_mumps)(const RanksOrder* order, void* structure);
  /// Messages between two ranks, which arrive in the order in which they were sent.
  void (*send)(int rank, const void* bytes, std::size_t count);
  void (*receive)(int rank, void* bytes, std::size_t count);
  /// Called by all: rank 0 sends, all others receive.
  void (*broadcast)(void* bytes, std::size_t count);
};

inline constexpr const char* kRanksSymbol = "netloft_ranks_v3";
using RanksFunction = const RanksModule* (*)();

}  // namespace netloft
