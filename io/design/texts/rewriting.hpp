// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/document.hpp"

#include <filesystem>

namespace netloft::design {

/// The own texts of a scene after which its document equals `wanted`, with as few changes as possible: tables
/// are added at the end, statements are taken out with the comments above them, values are replaced where
/// they are written. What stands in a file that is not among `texts` is left out by `without` in the scene,
/// or overridden there. Throws Refused if there are no such texts.
formats::StoredTexts rewritten(const std::filesystem::path& scene, formats::StoredTexts texts,
                               const formats::Value& wanted);

}  // namespace netloft::design
