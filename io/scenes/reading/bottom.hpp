// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// The material of the bed of a scene, `[bed] bottom`: rows of x, y and factors on parameters of the elements
/// that rest on the bed. Every element type that has a grid named `bottom` receives the factors that the
/// columns of this grid name.
class SeaBottom {
 public:
  SeaBottom() = default;
  /// `values` are those of bed_keys(), read from `bed`.
  SeaBottom(const Values& values, formats::TableReader bed);

  bool empty() const { return rows_.empty(); }
  /// Whether the factors are the same at y and -y.
  bool is_symmetric() const;
  /// Gives a part of this type its factors, unless the part states its own. Returns false if the type takes
  /// none.
  bool lay_under(const ElementType& type, Part& part) const;

 private:
  Samples rows_;
};

}  // namespace netloft::scenes
