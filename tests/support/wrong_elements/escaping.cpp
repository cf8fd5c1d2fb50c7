// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin written without the author layer, whose exceptions nobody catches.
#include <netloft/plugin.h>

#include <stdexcept>

namespace {

int evaluate(const void*, netloft_tile*) { throw std::runtime_error("nobody catches me"); }
int create(netloft_create*, void** self) {
  static int family;
  *self = &family;
  return NETLOFT_OK;
}
void destroy(void*) {}

const netloft_term kTerm = {sizeof kTerm, 0, "elastic", "throws across the boundary", nullptr, evaluate};

netloft_element element() {
  netloft_element e{};
  e.size = sizeof e, e.stencil = NETLOFT_BAR, e.name = "bar", e.doc = "no-exception-escapes";
  e.terms = &kTerm, e.term_count = 1;
  e.create = create, e.destroy = destroy;
  return e;
}

int push(const void*, const netloft_flow*) { throw std::runtime_error("nobody catches me"); }

netloft_law law() {
  netloft_law l{};
  l.size = sizeof l, l.kind = NETLOFT_TWINE_LAW, l.name = "law", l.doc = "no-exception-escapes";
  l.evaluate = push;
  return l;
}

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static const netloft_element elements[] = {element()};
  static netloft_plugin plugin{};
  plugin.size = sizeof plugin;
  plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "escaping", plugin.version = "1", plugin.doc = "throws", plugin.compiler = "";
  plugin.elements = elements, plugin.element_count = 1;
  static const netloft_law laws[] = {law()};
  plugin.laws = laws, plugin.law_count = 1;
  return &plugin;
}
