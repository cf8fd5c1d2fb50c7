// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/prefix.hpp"

#include "io/formats/files/installed_folder.hpp"

namespace netloft::program {

/// The same flags as in cmake/NetloftPlugin.cmake.
std::string compiler_flags() {
  const std::string prefix = formats::installed_folder().string();
  return "-std=c++20 -O2 -fPIC -shared -fvisibility=hidden -fvisibility-inlines-hidden -ffp-contract=off "
         "-fno-math-errno -fno-trapping-math -Wl,-z,defs -Wl,--version-script=" +
         prefix + "/lib/cmake/netloft/plugin.map -I" + prefix + "/include";
}

}  // namespace netloft::program
