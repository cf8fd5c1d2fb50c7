// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// A scene, the assembler of its elements, and the factory of the factorisations of its matrices.
struct AssembledScene {
  const Scene& scene;
  Assembler& assembler;
  MakeFactorisation make;
};

}  // namespace netloft
