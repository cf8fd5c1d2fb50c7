// SPDX-License-Identifier: BSD-3-Clause
//
// A solver that does not use solver.hpp and lets an exception out.
#include <netloft/ext/solver.h>

#include <cstring>
#include <stdexcept>

namespace {

int solve(const void*, netloft_problem*) { throw std::runtime_error("out"); }

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static netloft_solver solver{};
  static netloft_plugin plugin{};
  solver.size = sizeof solver, solver.name = "escaping", solver.doc = "no-exception-escapes";
  solver.solve = solve;
  plugin.size = sizeof plugin, plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "escaping_solvers", plugin.version = "1", plugin.doc = "", plugin.compiler = "";
  static const netloft_solvers list{sizeof list, 1, &solver};
  plugin.extension = [](const char* id) -> const void* {
    return std::strcmp(id, NETLOFT_EXT_SOLVER) == 0 ? &list : nullptr;
  };
  return &plugin;
}
