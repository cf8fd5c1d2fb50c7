// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"

namespace netloft {

/// A factorisation that knows what memory it will take once it has analysed a pattern.
class ForeseesMemory {
 public:
  virtual ~ForeseesMemory() = default;
  /// Memory that the first factorisation and solutions with it take beyond what `analyse` has taken; 0 when
  /// not known [bytes].
  virtual double factor_bytes() const = 0;
};

/// The same of any factorisation; 0 where it cannot say.
inline double factor_bytes_of(const Factorisation& factorisation) {
  const auto* foresees = dynamic_cast<const ForeseesMemory*>(&factorisation);
  return foresees ? foresees->factor_bytes() : 0;
}

}  // namespace netloft
