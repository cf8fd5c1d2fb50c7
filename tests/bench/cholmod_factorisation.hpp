// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// CHOLMOD, which chooses its ordering and kernels itself, for comparison. Only this bench uses it, because
/// its supernodal part is under the GPL. Returns nullptr if CHOLMOD was missing when the bench was built.
std::unique_ptr<Factorisation> make_cholmod_factorisation();

}  // namespace netloft
