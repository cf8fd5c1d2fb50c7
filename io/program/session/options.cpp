// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/options.hpp"

#include <algorithm>

namespace netloft::program {

void refuse_idle(const Options& options, const std::vector<std::string>& idle, const std::string& why) {
  for (const std::string& name : idle)
    if (std::find(options.given.begin(), options.given.end(), name) != options.given.end())
      throw UsageError{name + " has no effect here: " + why};
}

}  // namespace netloft::program
