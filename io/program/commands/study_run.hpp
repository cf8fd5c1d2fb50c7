// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"
#include "io/studies/sweep/study.hpp"

namespace netloft::program {

/// Computes the items of a study that have no record, or those of --items: one in this process, more by a
/// process each. An exit code.
int run_study(const Options& o, const studies::Study& study);

}  // namespace netloft::program
