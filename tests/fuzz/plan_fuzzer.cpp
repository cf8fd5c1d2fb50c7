// SPDX-License-Identifier: BSD-3-Clause
// Tries random input in all code for net plans: each input is read, checked, corrected, drawn and meshed.
#include "io/formats/toml/accepted_warnings.hpp"
#include "io/gears/drawing/drawing.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/gear.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/gears/plan/tried_cures.hpp"
#include "tests/folders.hpp"

#include <cstdint>
#include <string>

namespace {

using namespace netloft;

/// The catalogue of the library, which is read once.
const gears::Catalogue& catalogue() {
  static const gears::Catalogue parts = [] {
    formats::Diagnostics diagnostics;
    return gears::Catalogue::load({netloft::test::source_folder() + "/gear-library/catalogue"}, diagnostics);
  }();
  return parts;
}

/// Makes the compiler compute `size`, although nothing needs it.
void use(std::size_t size) {
  static volatile std::size_t sink = 0;
  sink = size;
}

void try_gear(const gears::NetPlan& plan, gears::Extent extent) {
  const gears::Gear gear = gears::make_gear(plan, extent);
  use(gear.panels.size());
  for (const auto& panel : gear.panels)
    if (panel.has_sketch())
      for (const auto& corner : panel.outline.corners()) use(panel.sketched(corner).size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  formats::Diagnostics diagnostics;
  const auto document =
      formats::Document::parse({reinterpret_cast<const char*>(data), size}, "plan.toml", {}, diagnostics);
  use(diagnostics.render(false).size());
  if (diagnostics.errors()) return 0;
  gears::NetPlan plan = gears::read_plan(document.root(), catalogue(), diagnostics);
  if (diagnostics.errors() == 0) gears::check_plan(plan, diagnostics);
  formats::accept_warnings(document.root(), diagnostics);
  gears::try_cures(document.root(), catalogue(), diagnostics, {.most = 12});
  if (diagnostics.errors() == 0) gears::check_seams(plan, diagnostics);
  use(diagnostics.render(false).size());
  if (diagnostics.errors()) return 0;
  formats::SvgPicture picture;
  use(static_cast<std::size_t>(gears::draw_plan(plan, picture).width));
  try_gear(plan, gears::Extent::whole);
  try_gear(plan, gears::Extent::half);
  return 0;
}
