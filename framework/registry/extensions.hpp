// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/ground.h>
#include <netloft/ext/laws.h>
#include <netloft/ext/memory.h>
#include <netloft/ext/shared_unknowns.h>
#include <netloft/ext/waves.h>

#include <span>
#include <string_view>
#include <vector>

namespace netloft {

/// Whether this program supports an extension of the plugin interface, such as "netloft.waves/1".
bool has_extension(std::string_view id);

/// The extensions whose data an element may list as inputs of its tiles.
enum class ExtensionInput { none, ground, waves, memory };

/// Returns the input with this identifier, or `none` if this program does not know it.
ExtensionInput find_extension_input(std::string_view id);
/// Returns the identifier of the input that a trait of a term reads, or nullptr if the trait reads none.
const char* input_of_trait(std::uint32_t trait);

/// The data of extensions for one tile.
struct ExtensionInputs {
  netloft_ground ground{sizeof(netloft_ground), 0, nullptr, nullptr};
  netloft_waves waves{sizeof(netloft_waves), 0, nullptr, nullptr};
  netloft_remembered memory{sizeof(netloft_remembered), 0, nullptr, nullptr};

  /// Sets the input pointers of a tile, in the order in which its element lists the inputs. The pointers
  /// point into this object.
  void hand_to(netloft_tile& tile, std::span<const ExtensionInput> listed) {
    if (places_.size() < listed.size()) places_.resize(listed.size());
    for (std::size_t k = 0; k < listed.size(); ++k) places_[k] = find(listed[k]);
    tile.inputs = listed.empty() ? nullptr : places_.data();
  }

 private:
  const void* find(ExtensionInput input) const {
    if (input == ExtensionInput::ground && (ground.velocity || ground.bed)) return &ground;
    if (input == ExtensionInput::waves && waves.acceleration) return &waves;
    if (input == ExtensionInput::memory && (memory.state || memory.state_new)) return &memory;
    return nullptr;
  }
  std::vector<const void*> places_ = std::vector<const void*>(8);  // enlarged for longer lists
};

/// The data of extensions for `create`.
struct CreationInputs {
  netloft_bound_laws laws{sizeof(netloft_bound_laws), 0, nullptr};
  netloft_global_starts globals{sizeof(netloft_global_starts), 0, nullptr};

  /// Attaches the data to the argument of a call of `create`. The call must end before this object is
  /// destroyed.
  void hand_to(netloft_create& in);
};

}  // namespace netloft
