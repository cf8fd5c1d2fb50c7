// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// A scene file that is read once and instantiated many times, each time with other changes.
///
/// The file and what it includes are read at the first instance. What an instance computes is kept, with its
/// inputs, for the next: the catalogue, the net plan, the division of the gear, and its initial shape. An
/// instance is the same, bit by bit, whichever came before it. Copies share what they have read. For one
/// thread.
class SceneSource {
 public:
  explicit SceneSource(std::filesystem::path file);

  const std::filesystem::path& file() const;

  /// The scene with `changes` applied, one after the other. Everything wrong is put into the diagnostics,
  /// with its place in a file or with the change; use the result only if there are no errors. Opens the
  /// plugins that the scene names; `refused` is set if one of them is missing or must not run.
  LoadedScene instance(const std::vector<formats::Change>& changes, Registry& registry,
                       formats::Diagnostics& diagnostics, bool& refused) const;

 private:
  class Memory;
  std::shared_ptr<Memory> memory_;
};

}  // namespace netloft::scenes
