// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// The catalogue of a scene, which is loaded at its first use. It consists of the folders that the scene
/// names, the folders of the user, and the library.
class SceneCatalogue {
 public:
  /// The key `catalogue` of the scene names folders relative to `folder`.
  SceneCatalogue(gears::KeptCatalogue& kept, const formats::Value& scene, const std::filesystem::path& folder,
                 formats::Diagnostics& diagnostics);

  std::shared_ptr<const gears::Catalogue> load();
  /// The catalogue if it has been loaded, else nullptr.
  const gears::Catalogue* loaded() const { return catalogue_.get(); }

 private:
  gears::KeptCatalogue& kept_;
  formats::Diagnostics& diagnostics_;
  std::vector<std::filesystem::path> own_;
  std::shared_ptr<const gears::Catalogue> catalogue_;
};

/// Replaces the names of catalogue parts in a scene, such as `twine = "pe-braided-4mm"`, by their numbers,
/// and stores their breaking loads in `strengths`. Does not load the catalogue if the scene names no
/// catalogue part.
void put_catalogue_parts(formats::Value& scene, SceneCatalogue& catalogue, Registry& registry,
                         formats::Diagnostics& diagnostics, std::map<std::string, Strength>& strengths);

}  // namespace netloft::scenes
