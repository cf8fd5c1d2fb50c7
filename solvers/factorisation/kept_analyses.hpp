// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Returns a function that makes the same factorisations as `make`, but keeps a factorisation when its user
/// destroys it. The next factorisation of the same matrix class that analyses an equal pattern, as in the
/// stages of one gear, reuses the order and the memory of the kept one. For each class, the last
/// factorisation whose factor is not large is kept until the returned function and all its factorisations are
/// destroyed. Threads may use the function concurrently.
MakeFactorisation keep_analyses(MakeFactorisation make);

}  // namespace netloft
