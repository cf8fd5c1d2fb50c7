// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/descriptors.hpp"

#include <limits>

namespace netloft {

/// How much a law was used inside and outside one of the ranges that it was measured in. Weights are metres
/// of twine or square metres of netting as given by the elements; elements that give none weigh one per call.
struct RangeUse {
  const netloft_validity* range = nullptr;
  double inside = 0, outside = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;  // of the quantity

  /// The fraction of all weights, 0 to 1.
  double fraction_outside() const { return outside > 0 ? outside / (inside + outside) : 0; }
};

/// How the parts of a family use a law.
struct LawUse {
  const LawType* law = nullptr;
  std::vector<std::uint32_t> parts;  // of the scene
  std::vector<RangeUse> ranges;
};

/// Passes the calls of elements on to a law. While it watches, it adds up for each range of the law how much
/// of the gear is outside. Watching is serial.
class LawWatch {
 public:
  /// `parameters` have to outlive this object, and have no errors.
  LawWatch(const LawType& law, const ParameterBlock& parameters);

  /// The law that elements call: the plain one if it has no range to watch.
  netloft_bound_law bound() const;
  void begin() { watches_ = true; }
  /// Stops watching and returns the use since begin().
  LawUse end();

 private:
  static int pass_on(const void* watch, const netloft_law_tile* flow);
  void note(const netloft_law_tile& flow);

  const LawType& law_;
  const void* parameters_;
  LawUse use_;
  bool watches_ = false;
};

/// The value of a quantity (NETLOFT_REYNOLDS …) in one lane of a flow, for a law of this kind.
double flow_quantity(std::uint32_t kind, std::uint32_t quantity, const netloft_law_tile& flow,
                     std::size_t lane);

/// "solidity", "Reynolds number across" …
const char* name_of_quantity(std::uint32_t quantity);

}  // namespace netloft
