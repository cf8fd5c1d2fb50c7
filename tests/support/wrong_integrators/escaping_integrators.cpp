// SPDX-License-Identifier: BSD-3-Clause
//
// An integrator that does not use integrator.hpp and lets an exception out.
#include <netloft/ext/integrator.h>

#include <cstring>
#include <stdexcept>

namespace {

int step(const void*, netloft_motion*) { throw std::runtime_error("out"); }
double order(const void*) { return 1; }
double stable_step(const void*, double) { return 0; }

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static netloft_integrator integrator{};
  static netloft_plugin plugin{};
  integrator.size = sizeof integrator, integrator.name = "escaping", integrator.doc = "no-exception-escapes";
  integrator.step = step, integrator.order = order, integrator.stable_step = stable_step;
  plugin.size = sizeof plugin, plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "escaping_integrators", plugin.version = "1", plugin.doc = "", plugin.compiler = "";
  static const netloft_integrators list{sizeof list, 1, &integrator};
  plugin.extension = [](const char* id) -> const void* {
    return std::strcmp(id, NETLOFT_EXT_INTEGRATOR) == 0 ? &list : nullptr;
  };
  return &plugin;
}
