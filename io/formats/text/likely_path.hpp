// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/nearest.hpp"

namespace netloft::formats {

/// The path that `word` most likely means: the nearest one or, if none is similar, the first that ends with
/// `word`, as "mouth/headline_height" ends with "headline_height". nullopt if there is neither.
inline std::optional<std::string> likely_path(std::string_view word, std::span<const std::string> paths) {
  if (auto near = nearest(word, paths)) return near;
  const auto is_end = [&](const std::string& path) {
    return path.size() > word.size() && path.ends_with(word) &&
           std::string_view("/.").find(path[path.size() - word.size() - 1]) != std::string_view::npos;
  };
  const auto found = std::find_if(paths.begin(), paths.end(), is_end);
  return found == paths.end() || word.empty() ? std::nullopt : std::optional(*found);
}

}  // namespace netloft::formats
