// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/ranks.hpp"
#include "tests/folders.hpp"

namespace netloft::test {

inline std::string ranks_module() { return plugin_folder() + "/mpi/mumps_mpi.so"; }
inline bool has_ranks() { return has_mumps() && std::filesystem::exists(ranks_module()); }

/// This process as the only rank; regression/cli/test_ranks.py has several.
inline Ranks& one_rank() {
  static Ranks ranks(ranks_module(), Launch{});
  return ranks;
}

}  // namespace netloft::test
