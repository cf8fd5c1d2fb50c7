// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/plan_drawing.hpp"

#include "io/formats/svg/svg.hpp"
#include "io/gears/drawing/drawing.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/results/figures/merged_scene.hpp"

#include <set>
#include <vector>

namespace netloft::pictures {

namespace {

/// The catalogue of a result: its files except those of the scene itself.
gears::Catalogue catalogue_of(const results::Origins& origins, const std::set<std::string>& of_scene,
                              formats::Diagnostics& diagnostics) {
  std::vector<formats::SourceFile> files;
  for (const auto& file : origins.files)
    if (!of_scene.contains(file.path)) files.push_back({file.path, file.text, file.hash});
  return gears::Catalogue::recall(files, diagnostics);
}

}  // namespace

std::string plan_drawing(const results::Result& result) {
  std::set<std::string> of_scene;
  const auto scene = results::merged_scene(result.origins, of_scene);
  if (!scene || !gears::holds_plan(*scene)) return "";
  formats::Diagnostics unheard;
  const gears::Catalogue catalogue = catalogue_of(result.origins, of_scene, unheard);
  gears::NetPlan plan = gears::read_plan(gears::tables_of_plan(*scene), catalogue, unheard);
  if (unheard.errors() == 0) gears::check_plan(plan, unheard);
  if (unheard.errors()) return "";
  formats::SvgPicture picture;
  const formats::DrawingSize size = gears::draw_plan(plan, picture);
  return picture.finish(size, size.width);
}

}  // namespace netloft::pictures
