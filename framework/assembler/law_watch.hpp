// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/descriptors.hpp"

#include <limits>

namespace netloft {

/// How much a law is used inside and outside one of the ranges in which it was measured. The weight of a call
/// is the length of twine [m] or area of netting [m²] that the element states, or 1 if it states neither.
struct RangeUse {
  const netloft_validity* range = nullptr;
  double inside = 0, outside = 0;
  // Least and largest value with which the law was called.
  double least = std::numeric_limits<double>::infinity(), most = -least;

  /// Fraction of the use that is outside the range, 0 to 1.
  double fraction_outside() const { return outside > 0 ? outside / (inside + outside) : 0; }
};

/// How much the parts of a family use a law inside and outside its ranges.
struct LawUse {
  const LawType* law = nullptr;
  std::vector<std::uint32_t> parts;  // indices, in the scene, of the parts that use the law
  std::vector<RangeUse> ranges;
};

/// Stands between the elements and a law, so that an error message can name the law if it crashes or breaks a
/// rule of the plugin interface. Between begin() and end(), a watch also sums, for each range of the law, how
/// much of the gear is inside and outside the range. During this time, only one thread may call the law.
class LawWatch {
 public:
  /// `parameters` must be valid and outlive this object.
  LawWatch(const LawType& law, const ParameterBlock& parameters);

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

/// The value of a quantity (NETLOFT_REYNOLDS …) for one element (`lane`) of a tile of flows. Its definition
/// depends on the `kind` of the law.
double flow_quantity(std::uint32_t kind, std::uint32_t quantity, const netloft_law_tile& flow,
                     std::size_t lane);

/// The name of a quantity, such as "Reynolds number across".
const char* name_of_quantity(std::uint32_t quantity);

}  // namespace netloft
