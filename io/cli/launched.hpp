// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/cli/options.hpp"

#include <memory>

namespace netloft::io {

/// On rank 0 of a launcher of MPI, such as mpirun: starts the ranks of a `run`. Null where there is one
/// process. Throws UsageError where several cannot work together: they would all write one file.
std::unique_ptr<Ranks> start_ranks(const Options& options, const Launch& launch);

/// On every other rank: serves the evaluations and the factorisations of a `run`. It reads no scene, writes
/// no file and says nothing; what is wrong, rank 0 says. Signals that end a run are for rank 0, which writes
/// its last point.
void serve_ranks(const Options& options, const Launch& launch);

}  // namespace netloft::io
