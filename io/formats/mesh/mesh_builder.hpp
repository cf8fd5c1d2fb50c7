// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"

#include <map>
#include <string>
#include <string_view>

namespace netloft::formats {

/// Builds a mesh for readers of other formats, and reports errors at their places.
class MeshBuilder {
 public:
  explicit MeshBuilder(Diagnostics& diagnostics)
      : diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {}

  /// Whether a reader should continue with its file: true until fifty errors were reported.
  bool goes_on() const { return errors() < 50; }
  int errors() const { return diagnostics_.errors() - errors_before_; }
  void error(const Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }

  /// Converts a word to a coordinate, in metres or in meshes. Reports an error and returns 0 if the word is
  /// not a number, or if its magnitude exceeds a million.
  double real(std::string_view word, const Place& place);
  void add_coordinate(double x, const Place& place);

  /// The region of a name and kind. If a region of another kind already has this name, the name of the kind
  /// is appended to `name`. Characters that are not allowed in names become dashes.
  MeshRegion& region(const std::string& name, RegionKind kind);
  MeshSet& set(const std::string& name);

  /// Adds one element. If bars have no numbers, finish() computes the fractions of the rope from the
  /// distances between nodes.
  void add_element(MeshRegion& region, const std::uint32_t* nodes, const double* numbers, const Place& place);

  InputMesh finish(const Place& end);

 private:
  struct At {
    std::string region;
    std::size_t element;
    Place place;
  };
  void share_out(MeshRegion& region) const;

  Diagnostics& diagnostics_;
  int errors_before_;
  InputMesh mesh_;
  std::vector<std::vector<Place>> places_;  // places of the elements, by region
  std::map<std::pair<std::string, RegionKind>, std::size_t> known_;
  std::size_t elements_ = 0;
};

}  // namespace netloft::formats
