// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace netloft {

/// A scene as bytes, for another process of the same program; they are no file format. Waves are left out:
/// they are no plain data.
std::vector<std::byte> bytes_of(const Scene& scene);
/// The scene that bytes_of() was given. Throws std::invalid_argument where the bytes are too few or too many.
Scene scene_of(std::span<const std::byte> bytes);

}  // namespace netloft
