// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// What is solved: a scene, the sum of its elements, and what factorises its matrices.
struct AssembledScene {
  const Scene& scene;
  Assembler& assembler;
  MakeFactorisation make;
};

}  // namespace netloft
