// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// CHOLMOD with its own choice of ordering and of kernels, to compare with. It is in this bench only, because
/// its supernodal part is under the GPL. nullptr: it was not there when the bench was built.
std::unique_ptr<Factorisation> make_cholmod_factorisation();

}  // namespace netloft
