// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

namespace netloft {

/// Thrown for a name that is that of a component of another kind, such as a solver where an element belongs:
/// no plugin is at fault, the input is.
struct WrongKind : UnknownComponent {
  using UnknownComponent::UnknownComponent;
};

/// Whether a plugin is at fault, and not only the kind of component that was named.
inline bool blames_plugin(const PluginRefused& error) {
  return dynamic_cast<const WrongKind*>(&error) == nullptr;
}

}  // namespace netloft
