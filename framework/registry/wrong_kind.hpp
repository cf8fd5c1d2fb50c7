// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

namespace netloft {

/// Thrown if a name belongs to a component of another kind, for example to a solver where an element is
/// needed. The input is at fault then, not the plugin.
struct WrongKind : UnknownComponent {
  using UnknownComponent::UnknownComponent;
};

/// Whether an error is the fault of a plugin, not of an input that names a component of the wrong kind.
inline bool blames_plugin(const PluginRefused& error) {
  return dynamic_cast<const WrongKind*>(&error) == nullptr;
}

}  // namespace netloft
