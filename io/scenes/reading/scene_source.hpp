// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/document.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// A scene file that is read once and instantiated many times, each time with different changes.
///
/// The file and those it includes are read at the first instance. Intermediate results of an instance
/// (catalogue, net plan, division of the gear, initial shape, parameters of parts) are stored with their
/// inputs, and reused if the inputs are equal. The bits of an instance do not depend on earlier instances.
/// Copies of this object share the stored data. A registry given to instance() has to outlive all copies. Not
/// safe for several threads.
class SceneSource {
 public:
  explicit SceneSource(std::filesystem::path file);

  const std::filesystem::path& file() const;

  /// The same scene, but with these texts instead of files; the texts have the names in LoadedScene::files.
  /// Files without a text are opened. Both scenes share stored results.
  SceneSource with_texts(std::filesystem::path file, formats::StoredTexts texts) const;

  /// The tables of the file and of the files that it includes, with `changes` applied. Names of catalogue
  /// parts are not replaced by their numbers.
  formats::Value tables(const std::vector<formats::Change>& changes, formats::Diagnostics& diagnostics) const;

  /// The scene with `changes` applied in their order. All errors go to the diagnostics with their place in a
  /// file or the change that caused them; use the result only if there are no errors. Opens the plugins that
  /// the scene names; sets `refused` if one of them is missing or was rejected.
  /// `like` is the division of another instance (GearInScene::division), whose mesh topology is used, so that
  /// the mesh is a smooth function of the numbers of the net plan; nullptr: the gear is divided anew.
  LoadedScene instance(const std::vector<formats::Change>& changes, Registry& registry,
                       formats::Diagnostics& diagnostics, bool& refused,
                       const std::shared_ptr<gears::Division>& like = nullptr) const;

  /// The net plan with `changes` applied: checks whether the net can be sewn, and reads all tables of the
  /// scene that need no mesh. A file without a net plan is an error. For the other arguments see instance().
  gears::NetPlan check_plan(const std::vector<formats::Change>& changes, Registry& registry,
                            formats::Diagnostics& diagnostics, bool& refused) const;

 private:
  class Texts;
  class Memory;
  std::shared_ptr<Texts> texts_;
  std::shared_ptr<Memory> memory_;
};

}  // namespace netloft::scenes
