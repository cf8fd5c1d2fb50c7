// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/cost.hpp"

namespace netloft {

void Cost::add(const Cost& later) {
  statistics.add(later.statistics);
  work += later.work;
  stages.insert(stages.end(), later.stages.begin(), later.stages.end());
}

void Cost::add_before(const Cost& earlier) {
  statistics.add(earlier.statistics);
  work += earlier.work;
  stages.insert(stages.begin(), earlier.stages.begin(), earlier.stages.end());
}

}  // namespace netloft
