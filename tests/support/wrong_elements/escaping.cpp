// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin that does not use element.hpp: nothing catches its exceptions, and its parameters keep the values
// that the host left in their memory.
#include <netloft/ext/laws.h>

#include <cstddef>
#include <cstring>
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

/// The tables of the plugin declare only `coefficient`, so that `number` has no default.
struct Parameters {
  double coefficient, number;
};

netloft_parameter coefficient() {
  netloft_parameter p{};
  p.size = sizeof p, p.kind = NETLOFT_REAL, p.name = "coefficient", p.unit = "1", p.doc = "times number + 1";
  p.fallback = 1, p.lo = 0.5, p.hi = 2, p.offset = offsetof(Parameters, coefficient);
  return p;
}
const netloft_parameter kCoefficient = coefficient();

int create_with_number(netloft_create* in, void** self) {
  *self = const_cast<void*>(in->parameters[0]);
  return NETLOFT_OK;
}

/// A weight of (number + 1) N.
int pull_down(const void* self, netloft_tile* t) {
  const auto& p = *static_cast<const Parameters*>(self);
  for (std::uint32_t i = 0; i < t->count; ++i) {
    if (t->energy) t->energy[i] += (p.number + 1) * t->x[2 * NETLOFT_LANES + i];
    if (t->force) t->force[2 * NETLOFT_LANES + i] += p.number + 1;
  }
  return NETLOFT_OK;
}
const netloft_term kWeight = {
    sizeof kWeight, NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC | NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE,
    "weight",       "reads a number nobody declares",
    nullptr,        pull_down};

netloft_element element_with_number() {
  netloft_element e{};
  e.size = sizeof e, e.stencil = NETLOFT_NODE, e.name = "undeclared", e.doc = "reads-what-it-declares";
  e.parameter_bytes = sizeof(Parameters), e.parameters = &kCoefficient, e.parameter_count = 1;
  e.terms = &kWeight, e.term_count = 1;
  e.create = create_with_number, e.destroy = destroy;
  return e;
}

/// A force along the flow, proportional to its velocity.
int push_in_proportion(const void* parameters, const netloft_law_tile* f) {
  const auto& p = *static_cast<const Parameters*>(parameters);
  const double k = p.coefficient * (p.number + 1);
  for (std::uint32_t i = 0; i < f->count; ++i)
    for (std::size_t r = 0; r < 3; ++r) {
      f->force[r * NETLOFT_LANES + i] = k * f->flow[r * NETLOFT_LANES + i];
      if (!f->d_flow) continue;
      f->d_solidity[r * NETLOFT_LANES + i] = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        f->d_flow[(3 * r + c) * NETLOFT_LANES + i] = r == c ? k : 0;
        f->d_direction[(3 * r + c) * NETLOFT_LANES + i] = 0;
      }
    }
  return NETLOFT_OK;
}

netloft_law law_with_number() {
  netloft_law l{};
  l.size = sizeof l, l.kind = NETLOFT_TWINE_LAW, l.name = "undeclared_law", l.doc = "reads-what-it-declares";
  l.parameter_bytes = sizeof(Parameters), l.parameters = &kCoefficient, l.parameter_count = 1;
  l.evaluate = push_in_proportion;
  return l;
}

int push(const void*, const netloft_law_tile*) { throw std::runtime_error("nobody catches me"); }

netloft_law law() {
  netloft_law l{};
  l.size = sizeof l, l.kind = NETLOFT_TWINE_LAW, l.name = "law", l.doc = "no-exception-escapes";
  l.evaluate = push;
  return l;
}

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static const netloft_element elements[] = {element(), element_with_number()};
  static netloft_plugin plugin{};
  plugin.size = sizeof plugin;
  plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "escaping", plugin.version = "1", plugin.doc = "throws", plugin.compiler = "";
  plugin.elements = elements, plugin.element_count = 2;
  static const netloft_law laws[] = {law(), law_with_number()};
  static const netloft_laws list{sizeof list, 2, laws};
  plugin.extension = [](const char* id) -> const void* {
    return std::strcmp(id, NETLOFT_EXT_LAWS) == 0 ? &list : nullptr;
  };
  return &plugin;
}
