// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/commands/scenes.hpp"
#include "io/program/session/session.hpp"
#include "io/results/file/write_result.hpp"

namespace netloft::program {

/// The two kinds of runs. Each solves a prepared scene, writes the result and prints it. Both throw
/// UsageError for options of the other kind, and return the exit code.
int run_equilibrium(const RunOptions& options, Session& session, results::RunContext& context);
int run_motion(const RunOptions& options, Session& session, results::RunContext& context);

/// Displacements that move the gear to its shape in the result `file`. `key` is the option that names the
/// file, for messages.
std::vector<double> read_start(const std::string& file, const char* key, runs::PreparedScene& scene);

}  // namespace netloft::program
