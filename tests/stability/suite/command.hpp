// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/stability/suite/options.hpp"

namespace netloft::hard_cases {

/// Runs the suite and prints the matrix. Returns the exit code: kNotConverged unless the first column solved
/// every case correctly. Throws program::UsageError.
int run_hard_cases(const SuiteOptions& options);

}  // namespace netloft::hard_cases
