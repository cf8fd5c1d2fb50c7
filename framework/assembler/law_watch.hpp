// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/descriptors.hpp"

#include <limits>

namespace netloft {

/// How far a law was asked within and beyond one range that it was measured in. Weights are metres of twine
/// or square metres of netting, as elements tell them; where they do not, every call weighs one.
struct RangeUse {
  const netloft_validity* range = nullptr;
  double inside = 0, outside = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;  // of the quantity

  /// Of all that the law acts on, 0 to 1.
  double fraction_outside() const { return outside > 0 ? outside / (inside + outside) : 0; }
};

/// What the parts of a family ask of a law.
struct LawUse {
  const LawType* law = nullptr;
  std::vector<std::uint32_t> parts;  // of the scene
  std::vector<RangeUse> ranges;
};

/// Stands between elements and a law that was measured in some range. It passes every call on, and while it
/// watches, it adds up for how much of the gear each range is left. Watching is serial.
class LawWatch {
 public:
  /// `parameters` must outlive it, and have no errors.
  LawWatch(const LawType& law, const ParameterBlock& parameters);

  /// The law as elements are handed it: without a range to watch, the plain one.
  netloft_bound_law bound() const;
  void begin() { watches_ = true; }
  /// Stops watching and returns what was seen.
  LawUse end();

 private:
  static int pass_on(const void* watch, const netloft_law_tile* flow);
  void note(const netloft_law_tile& flow);

  const LawType& law_;
  const void* parameters_;
  LawUse use_;
  bool watches_ = false;
};

/// The quantity of a lane of a flow that a range of a law of this kind is about.
double flow_quantity(std::uint32_t kind, std::uint32_t quantity, const netloft_law_tile& flow,
                     std::size_t lane);

/// "solidity", "Reynolds number across" …
const char* name_of_quantity(std::uint32_t quantity);

}  // namespace netloft
