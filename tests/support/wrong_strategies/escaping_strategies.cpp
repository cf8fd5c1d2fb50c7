// SPDX-License-Identifier: BSD-3-Clause
//
// Strategies that do not use strategy.hpp: they solve the unchanged scene once, with a flaw that strategy.hpp
// would prevent. The description of a strategy is the name of the check that must fail.
#include <netloft/ext/strategy.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace {

enum class Flaw { escapes, unsized, scribbles, overflows };

int run_at_once(netloft_search* search, bool sized) {
  std::vector<double> u(search->unknowns, 0.0);
  if (search->start) std::copy_n(search->start, u.size(), u.begin());
  netloft_stage stage{};
  stage.variant.compression = stage.variant.current = 1;
  stage.name = "at once", stage.u = u.data();
  if (sized) stage.size = sizeof stage, stage.variant.size = sizeof stage.variant;
  if (search->solve(search->host, &stage) != NETLOFT_OK) return NETLOFT_ERROR;
  const bool balanced = stage.ending == NETLOFT_ENDED_CONVERGED || stage.ending == NETLOFT_ENDED_UNSTABLE;
  return balanced ? search->answer(search->host, u.data()) : NETLOFT_OK;
}

template <Flaw F>
int run(const void*, netloft_search* search) {
  if (F == Flaw::escapes) throw std::runtime_error("out");
  const int status = run_at_once(search, F != Flaw::unsized);
  if (F == Flaw::scribbles && search->start) const_cast<double*>(search->start)[0] += 1;
  return status;
}

int explain(const void*, netloft_search*, char* text, uint32_t) {
  std::strcpy(text, "solves the scene as it is written");
  return NETLOFT_OK;
}

template <Flaw F>
netloft_strategy strategy(const char* name, const char* found_by) {
  netloft_strategy s{};
  s.size = sizeof s, s.name = name, s.doc = found_by, s.run = run<F>;
  if (F == Flaw::overflows) s.explain = explain;
  return s;
}

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static const netloft_strategy strategies[] = {
      strategy<Flaw::escapes>("escaping", "no-exception-escapes"),
      strategy<Flaw::unsized>("unsized", "fills-its-stages"),
      strategy<Flaw::scribbles>("scribbles", "leaves-the-search-alone"),
      strategy<Flaw::overflows>("overflows", "explains-within-its-room")};
  static netloft_plugin plugin{};
  plugin.size = sizeof plugin, plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = "escaping_strategies", plugin.version = "1", plugin.doc = "", plugin.compiler = "";
  static const netloft_strategies list{sizeof list, 4, strategies};
  plugin.extension = [](const char* id) -> const void* {
    return std::strcmp(id, NETLOFT_EXT_STRATEGY) == 0 ? &list : nullptr;
  };
  return &plugin;
}
