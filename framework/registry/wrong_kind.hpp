// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

namespace netloft {

/// Thrown if an input names a component of the wrong kind, for example a solver where an element is needed.
/// This is a fault of the input, not of the plugin.
struct WrongKind : UnknownComponent {
  using UnknownComponent::UnknownComponent;
};

/// Whether an error is the fault of a plugin, and not of an input that names a component of the wrong kind.
inline bool blames_plugin(const PluginRefused& error) {
  return dynamic_cast<const WrongKind*>(&error) == nullptr;
}

}  // namespace netloft
