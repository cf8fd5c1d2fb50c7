// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin through the C interface, correct if FLAW is FLAW_NONE. CMakeLists.txt builds one module for every
// flaw.
#include <netloft/ext/ground.h>
#include <netloft/ext/laws.h>
#include <netloft/ext/members.h>
#include <netloft/ext/strategy.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

enum Flaw {
  FLAW_none,
  FLAW_missing_symbol,
  FLAW_other_major,
  FLAW_newer_minor,
  FLAW_fast_math_compiled,
  FLAW_fast_math_linked,
  FLAW_flushes_to_zero,
  FLAW_two_elements,
  FLAW_two_parameters,
  FLAW_offset_outside,
  FLAW_misaligned,
  FLAW_wrong_name,
  FLAW_null,
  FLAW_no_terms,
  FLAW_needs_unknown,
  FLAW_no_members,
  FLAW_drag_at_rest,
  FLAW_nameless_parameter,
  FLAW_no_unit,
  FLAW_bad_choice,
  FLAW_bad_integer,
  FLAW_endless_integer,
  FLAW_column_without_unit,
  FLAW_throws,
  FLAW_many,
  FLAW_longer,
  FLAW_older,
  FLAW_longer_and_newer,
  FLAW_crashes,
  FLAW_exits,
  FLAW_two_strategies,
  FLAW_no_run,
  FLAW_strategy_outside,
  FLAW_wild_table,
  FLAW_empty_validity,
  FLAW_needs_extension,
  FLAW_unlisted_input
};

#define JOIN(a, b) a##b
#define FLAW_OF(name) JOIN(FLAW_, name)
#define TEXT(name) #name
#define TEXT_OF(name) TEXT(name)

namespace {

constexpr Flaw kFlaw = FLAW_OF(FLAW);
constexpr bool has(Flaw flaw) { return kFlaw == flaw; }

#if defined(__x86_64__)
/// Makes the processor flush subnormal numbers to zero, as crtfastmath.o of GCC does.
__attribute__((constructor)) void flush_to_zero() {
  if (has(FLAW_flushes_to_zero)) _mm_setcsr(_mm_getcsr() | 0x8040);
}
#endif

__attribute__((constructor)) void start_up() {
  if (has(FLAW_crashes)) std::abort();
  if (has(FLAW_exits)) std::exit(0);
}

struct Parameters {
  double stiffness;
  double rate;
};

int evaluate(const void*, netloft_tile* t) {
  for (std::uint32_t i = 0; t->force && i < t->count; ++i) t->force[i] += 1;
  return NETLOFT_OK;
}
int run(const void*, netloft_search*) { return NETLOFT_OK; }
int create(netloft_create*, void** self) {
  static int family;
  *self = &family;
  return NETLOFT_OK;
}
void destroy(void*) {}

/// An array of structs, `Step` bytes apart, as in a plugin of another minor version.
template <class T, std::size_t Count, std::size_t Step>
struct Array {
  explicit Array(const T (&rows)[Count]) {
    std::memset(bytes, 0x5a, sizeof bytes);  // fields that the host does not know
    for (std::size_t i = 0; i < Count; ++i) {
      T row = rows[i];
      row.size = Step;
      std::memcpy(bytes + i * Step, &row, Step < sizeof row ? Step : sizeof row);
    }
  }
  const T* data() const { return reinterpret_cast<const T*>(bytes); }
  alignas(8) char bytes[Count * Step];
};

/// The size that a struct has with this flaw: longer in a newer interface, `known` in an older one.
constexpr std::size_t step_of(std::size_t size, std::size_t known) {
  return has(FLAW_longer) || has(FLAW_longer_and_newer) ? size + 24 : has(FLAW_older) ? known : size;
}

netloft_parameter parameter(const char* name, std::size_t offset) {
  netloft_parameter p{};
  p.name = name, p.unit = "N/m", p.doc = "a parameter", p.hi = 10;
  p.offset = static_cast<std::uint32_t>(offset);
  return p;
}

const netloft_parameter* parameters() {
  static const char* const words[] = {"yes", "no", nullptr};
  netloft_parameter stiffness = parameter("stiffness", offsetof(Parameters, stiffness));
  netloft_parameter rate = parameter("rate", offsetof(Parameters, rate));
  if (has(FLAW_two_parameters)) rate.name = "stiffness";
  if (has(FLAW_offset_outside) || has(FLAW_many)) rate.offset = sizeof(Parameters);
  if (has(FLAW_misaligned)) rate.offset = 4;
  if (has(FLAW_no_unit) || has(FLAW_many)) rate.unit = "";
  if (has(FLAW_nameless_parameter)) stiffness.name = nullptr, rate.fallback_of = "stiffness";
  if (has(FLAW_bad_choice)) rate.kind = NETLOFT_CHOICE, rate.choices = words, rate.fallback = 2;
  if (has(FLAW_bad_integer)) rate.kind = NETLOFT_INTEGER, rate.fallback = 1e30;
  if (has(FLAW_endless_integer)) rate.kind = NETLOFT_INTEGER, rate.hi = INFINITY;
  if (has(FLAW_column_without_unit))
    rate.kind = NETLOFT_TABLE, rate.offset = 0, rate.columns = words, rate.column_units = words + 1;
  static const Array<netloft_parameter, 2,
                     step_of(sizeof stiffness, offsetof(netloft_parameter, fallback_text))>
      rows({stiffness, rate});
  return rows.data();
}

const netloft_term* terms() {
  netloft_term one{}, two{};
  one.name = "one", two.name = "two", one.doc = two.doc = "a term";
  one.evaluate = two.evaluate = evaluate;
  two.needs = has(FLAW_needs_unknown) ? "strength" : "stiffness";
  if (has(FLAW_drag_at_rest)) one.traits = NETLOFT_IS_DRAG | NETLOFT_READS_CURRENT;
  if (has(FLAW_no_members)) one.traits = NETLOFT_OF_MEMBERS | NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC;
  if (has(FLAW_unlisted_input)) one.traits = NETLOFT_READS_BED;
  static const Array<netloft_term, 2, step_of(sizeof one, sizeof one)> rows({one, two});
  return rows.data();
}

netloft_element element(const char* name) {
  netloft_element e{};
  e.stencil = NETLOFT_BAR, e.name = name, e.doc = "an element";
  e.parameter_bytes = sizeof(Parameters), e.parameter_count = 2, e.parameters = parameters();
  e.term_count = has(FLAW_no_terms) || has(FLAW_many) ? 0 : 2, e.terms = terms();
  e.create = create, e.destroy = destroy;
  return e;
}

const netloft_element* elements() {
  static const Array<netloft_element, 2, step_of(sizeof(netloft_element), offsetof(netloft_element, output))>
      rows({element("bar"), element(has(FLAW_two_elements) ? "bar" : "rod")});
  return rows.data();
}

int push(const void*, const netloft_law_tile*) { return NETLOFT_OK; }

const netloft_validity* validity() {
  netloft_validity v{};
  v.quantity = has(FLAW_empty_validity) ? 99 : NETLOFT_SOLIDITY, v.lo = has(FLAW_empty_validity) ? 1 : 0,
  v.hi = 0.5;
  v.source = has(FLAW_empty_validity) ? "" : "nobody", v.where = has(FLAW_empty_validity) ? "speed" : "rate";
  static const Array<netloft_validity, 1, step_of(sizeof v, sizeof v)> rows({v});
  return rows.data();
}

const netloft_law* laws() {
  netloft_law l{};
  l.kind = NETLOFT_TWINE_LAW, l.name = "law", l.doc = "a law", l.evaluate = push;
  l.parameter_bytes = sizeof(Parameters), l.parameter_count = 2, l.parameters = parameters();
  l.validity = validity(), l.validity_count = 1;
  static const Array<netloft_law, 1, step_of(sizeof l, offsetof(netloft_law, validity))> rows({l});
  return rows.data();
}

netloft_strategy strategy(const char* name) {
  netloft_strategy s{};
  s.name = name, s.doc = "a strategy", s.run = has(FLAW_no_run) ? nullptr : run;
  s.parameter_bytes = has(FLAW_strategy_outside) ? sizeof(double) : sizeof(Parameters);
  s.parameter_count = 2, s.parameters = parameters();
  return s;
}

const netloft_strategy* strategies() {
  static const Array<netloft_strategy, 2, step_of(sizeof(netloft_strategy), sizeof(netloft_strategy))> rows(
      {strategy(TEXT_OF(FLAW)), strategy(has(FLAW_two_strategies) ? TEXT_OF(FLAW) : "second")});
  return rows.data();
}

/// A list {size, count, rows} as a plugin offers it.
template <class List, class Row>
const void* offer(const Row* rows, std::uint32_t count) {
  static const List list{sizeof list, count, rows};
  return &list;
}

const void* extension(const char* id) {
  if (std::strcmp(id, NETLOFT_EXT_LAWS) == 0) return offer<netloft_laws>(laws(), 1);
  if (std::strcmp(id, NETLOFT_EXT_STRATEGY) == 0) return offer<netloft_strategies>(strategies(), 2);
  return nullptr;
}

const char* const* required() {
  static const char* const ids[] = {NETLOFT_EXT_LAWS, has(FLAW_needs_extension) ? "netloft.ice/1" : nullptr,
                                    nullptr};
  return ids;
}

netloft_plugin plugin() {
  netloft_plugin p{};
  p.abi_major = NETLOFT_ABI_MAJOR + (has(FLAW_other_major) ? 1 : 0);
  p.abi_minor =
      has(FLAW_older) ? 0 : NETLOFT_ABI_MINOR + (has(FLAW_newer_minor) || has(FLAW_longer_and_newer) ? 1 : 0);
  p.flags = NETLOFT_BUILD_FLAGS;
  p.name = has(FLAW_wrong_name) ? "other" : TEXT_OF(FLAW);
  p.version = "1", p.doc = "a plugin", p.compiler = "";
  p.elements = elements(), p.element_count = 2;
  if (has(FLAW_wild_table)) p.elements = reinterpret_cast<const netloft_element*>(std::uintptr_t{0x1230});
  p.required = required(), p.extension = extension;  // in an older header, the struct ends before this member
  return p;
}

const netloft_plugin* describe() {
  if (has(FLAW_throws)) throw 1;
  if (has(FLAW_null)) return nullptr;
  static const Array<netloft_plugin, 1, step_of(sizeof(netloft_plugin), offsetof(netloft_plugin, extension))>
      row({plugin()});
  return row.data();
}

}  // namespace

extern "C" {
#if defined(NO_SYMBOL)
NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v0(void) { return describe(); }
#else
NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) { return describe(); }
#endif
}
