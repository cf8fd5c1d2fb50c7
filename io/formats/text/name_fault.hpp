// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace netloft::formats {

/// States why a text cannot be a name; empty if it can. Names of parts, bodies, results, variables and
/// studies become files, paths in results, and lines of meshes and scripts, so that no name may hold a slash
/// or a control character.
std::string name_fault(const std::string& name);

}  // namespace netloft::formats
