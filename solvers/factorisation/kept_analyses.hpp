// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Makes the same factorisations, but the result of `analyse` outlives each of them: the next one that
/// analyses an equal pattern, for a matrix of the same class, reuses its order and its memory. A gear that is
/// solved in several stages has one pattern. The last factorisation of each class is kept if its factor is
/// not large, as long as the returned function or one of its factorisations exists. Threads may use it
/// concurrently.
MakeFactorisation keep_analyses(MakeFactorisation make);

}  // namespace netloft
