// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// A factorisation that can predict its memory once it has analysed a pattern.
class ForeseesMemory {
 public:
  virtual ~ForeseesMemory() = default;
  /// Memory that the first factorisation and its solves need beyond that of `analyse` [bytes]; 0 if unknown.
  virtual double factor_bytes() const = 0;
};

/// Returns factor_bytes() of a factorisation, or 0 if the factorisation cannot predict its memory.
inline double factor_bytes_of(const Factorisation& factorisation) {
  const auto* foresees = dynamic_cast<const ForeseesMemory*>(&factorisation);
  return foresees ? foresees->factor_bytes() : 0;
}

}  // namespace netloft
