// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/geometry.hpp"

#include <optional>
#include <string>

namespace netloft::scenes {

/// A fault in the table `key` of a part.
struct ThicknessFault {
  const char* key;
  std::string message;
};

/// Twine as thick as its bars are long leaves no mesh to open, and no rope is as thick as it is long. Empty:
/// it is neither.
std::optional<ThicknessFault> thickness_fault(const Part& part, const Geometry& geometry);

inline constexpr const char* kThicknessCure = "one of the two may be in another unit";

}  // namespace netloft::scenes
