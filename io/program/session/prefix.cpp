// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/prefix.hpp"

namespace netloft::program {

std::filesystem::path installed_prefix() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path().parent_path();
}

/// The same flags as in cmake/NetloftPlugin.cmake.
std::string compiler_flags() {
  const std::string prefix = installed_prefix().string();
  return "-std=c++20 -O2 -fPIC -shared -fvisibility=hidden -fvisibility-inlines-hidden -ffp-contract=off "
         "-fno-math-errno -fno-trapping-math -Wl,-z,defs -Wl,--version-script=" +
         prefix + "/lib/cmake/netloft/plugin.map -I" + prefix + "/include";
}

}  // namespace netloft::program
