// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace netloft::formats {

/// The reason why a text cannot be a name; empty if it can. Names of parts, bodies, results, variables and
/// studies appear in file names, in paths in results, and in lines of meshes and scripts. Therefore no name
/// may contain a slash or a control character.
std::string name_fault(const std::string& name);

}  // namespace netloft::formats
