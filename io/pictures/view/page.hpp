// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace netloft::pictures {

/// A page with the viewer, in one file that needs no network. Report and pictures are static, and scripts add
/// the viewer above them. Two results are shown in one picture; three or more form a sweep.
std::string view_page(const std::vector<const results::StoredShape*>& shapes, std::size_t most_states);

/// One script with the classes of the viewer, followed by `start`, which uses them.
std::string viewer_script(const std::string& start);

/// A page with the report only, without scripts.
std::string report_page(const results::StoredShape& shape);

}  // namespace netloft::pictures
