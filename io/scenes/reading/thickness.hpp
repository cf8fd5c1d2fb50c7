// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/geometry.hpp"

#include <optional>
#include <string>

namespace netloft::scenes {

/// A wrong thickness: the key of the table that states it, and the message.
struct ThicknessFault {
  const char* key;
  std::string message;
};

/// Finds twine that is as thick as its bars are long, so that no mesh could open, or a rope that is as thick
/// as it is long. nullopt if there is neither.
std::optional<ThicknessFault> thickness_fault(const Part& part, const Geometry& geometry);

inline constexpr const char* kThicknessCure = "one of the two may be in another unit";

}  // namespace netloft::scenes
