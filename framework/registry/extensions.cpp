// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/extensions.hpp"

#include <netloft/ext/bodies.h>
#include <netloft/ext/convex.h>
#include <netloft/ext/flow.h>
#include <netloft/ext/integrator.h>
#include <netloft/ext/members.h>
#include <netloft/ext/pairs.h>
#include <netloft/ext/solver.h>
#include <netloft/ext/strategy.h>

#include <algorithm>

namespace netloft {

namespace {

constexpr std::string_view kExtensions[] = {NETLOFT_EXT_BODIES,     NETLOFT_EXT_CONVEX,
                                            NETLOFT_EXT_FLOW,       NETLOFT_EXT_GROUND,
                                            NETLOFT_EXT_INTEGRATOR, NETLOFT_EXT_LAWS,
                                            NETLOFT_EXT_MEMBERS,    NETLOFT_EXT_MEMORY,
                                            NETLOFT_EXT_PAIRS,      NETLOFT_EXT_SHARED_UNKNOWNS,
                                            NETLOFT_EXT_SOLVER,     NETLOFT_EXT_STRATEGY,
                                            NETLOFT_EXT_WAVES};

struct InputOfTraits {
  std::uint32_t traits;
  const char* id;
  ExtensionInput input;
};

constexpr InputOfTraits kInputs[] = {
    {NETLOFT_READS_GROUND | NETLOFT_READS_BED, NETLOFT_EXT_GROUND, ExtensionInput::ground},
    {NETLOFT_READS_WAVES, NETLOFT_EXT_WAVES, ExtensionInput::waves},
    {NETLOFT_READS_STATE, NETLOFT_EXT_MEMORY, ExtensionInput::memory}};

}  // namespace

bool has_extension(std::string_view id) {
  return std::ranges::find(kExtensions, id) != std::end(kExtensions);
}

ExtensionInput find_extension_input(std::string_view id) {
  for (const auto& one : kInputs)
    if (id == one.id) return one.input;
  return ExtensionInput::none;
}

const char* input_of_trait(std::uint32_t trait) {
  for (const auto& one : kInputs)
    if (one.traits & trait) return one.id;
  return nullptr;
}

void CreationInputs::hand_to(netloft_create& in) {
  in.host = this;
  in.extension = [](void* host, const char* id) -> const void* {
    const auto& inputs = *static_cast<const CreationInputs*>(host);
    if (std::string_view(id) == NETLOFT_EXT_LAWS) return &inputs.laws;
    if (std::string_view(id) == NETLOFT_EXT_SHARED_UNKNOWNS) return &inputs.globals;
    return nullptr;
  };
}

}  // namespace netloft
