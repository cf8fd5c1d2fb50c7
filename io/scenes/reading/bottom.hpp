// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// The material of the bed as a function of place. The table `[bed] bottom` has rows of x, y and factors,
/// which multiply parameters of the elements that rest on the bed. If an element type has a parameter
/// `bottom`, a grid over x and y, this parameter gets the factors in its columns.
class SeaBottom {
 public:
  SeaBottom() = default;
  /// `values` has the keys of the table `bed`, read as bed_keys().
  SeaBottom(const Values& values, formats::TableReader bed);

  bool empty() const { return rows_.empty(); }
  /// Whether the factors are the same at y and -y.
  bool is_symmetric() const;
  /// Gives a part of this element type its factors, unless the part states its own. Returns false if the type
  /// has no parameter for factors.
  bool lay_under(const ElementType& type, Part& part) const;

 private:
  Samples rows_;
};

}  // namespace netloft::scenes
