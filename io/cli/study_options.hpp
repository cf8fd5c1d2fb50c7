// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::io {

/// Options of the command `study` alone.
struct StudyCommandOptions {
  std::string action;  // plan, run, collect
  std::string items;   // --items 1-10,15
  int jobs = 0;        // --jobs; 0: as many as the machine has
};

}  // namespace netloft::io
