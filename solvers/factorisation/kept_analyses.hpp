// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/factorisation.hpp"

namespace netloft {

/// The same factorisations, but what one has worked out in `analyse` outlives it: the next that is asked to
/// analyse an equal pattern, for a matrix of the same class, takes its order and its room over. A gear that
/// is solved in several stages has one pattern. The last of each class is kept, if its factor is not large,
/// as long as the result or what it has made is there. Threads may share it.
MakeFactorisation keep_analyses(MakeFactorisation make);

}  // namespace netloft
