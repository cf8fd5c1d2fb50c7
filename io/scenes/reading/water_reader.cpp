// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/water_reader.hpp"

#include "io/formats/units/in_quotes.hpp"
#include "io/formats/units/units.hpp"
#include "io/scenes/reading/parameter_reader.hpp"
#include "io/scenes/reading/tow.hpp"
#include "io/scenes/reading/waves.hpp"
#include "io/scenes/water/current.hpp"

#include <cmath>

namespace netloft::scenes {

void WaterReader::read() {
  formats::TableReader water = root_.table("water", formats::Presence::optional);
  const Values values = read_parameters(water_keys(), water);
  std::vector<std::string> faults;
  const ParameterBlock block(water_keys(), sizeof(WaterKeys), values, faults);
  if (faults.empty()) take_water(*static_cast<const WaterKeys*>(block.data()), water);
  out_.scene.current = read_current(water);
  if ((says_tow_ = root_.has("tow"))) read_tow(root_.table("tow"), out_.scene);
  if (root_.has("bed")) bottom_ = read_bed(root_.table("bed"), out_.scene);
  read_ship();
  out_.scene.waves = read_waves(water, out_.scene);
}

void WaterReader::check_waves() {
  if (!out_.scene.waves ||
      diagnostics_.where(root_.table("analysis", formats::Presence::optional).place("kind"))
          .starts_with("--set"))
    return;
  formats::TableReader water = root_.table("water");
  water.error("waves", "have no effect in a static analysis",
              "kind = \"dynamic\" in [analysis], or leave them out");
}

/// Sets the velocity at which water and ground pass the gear of a net plan, from the speed of its ship.
void WaterReader::read_ship() {
  if (!root_.has("ship")) return;
  const gears::Ship* ship = gear_.ship();
  if (!ship)
    return root_.error("ship", "needs a net plan, but the scene has none",
                       "use [tow] speed and a [[hold]] to tow a gear made of parts");
  if (says_tow_)
    diagnostics_.error(ship->speed_place, "ship.speed is given beside [tow], and each of them tows the gear",
                       "leave out one of them");
  says_tow_ = true;
  out_.scene.ground = {ship->speed, 0, 0};
  out_.scene.current.tow = out_.scene.ground;
}

/// Sets the water of the scene, with the viscosity of a model test. By Froude's rule (W. Froude), velocities
/// of a model at the scale 1 : s are smaller by √s. In water of viscosity ν, the model has the Reynolds
/// numbers that the gear has in water of viscosity ν s^1.5; if nothing stretches, model and gear are similar
/// in all other respects.
void WaterReader::take_water(const WaterKeys& keys, formats::TableReader& water) {
  out_.scene.water = keys;
  if (keys.model_twine_scale == 0) {
    out_.scene.water.viscosity *= std::pow(keys.model_scale, 1.5);
    return;
  }
  const bool is_whole = keys.model_twine_scale >= 1;
  if (!is_whole || keys.model_twine_scale > keys.model_scale)
    water.error("model_twine_scale",
                "is outside [1, " + formats::format(keys.model_scale) +
                    "]: by Tauti's rule twines are scaled less than lengths",
                is_whole ? "model_scale = " + formats::format(keys.model_twine_scale) + ", or more"
                         : "give model_twine_scale = 1 or more, or leave it out for Froude's rule");
  tauti_ = TautiModel{keys.model_scale, keys.model_twine_scale};
  out_.scene.water.viscosity *= tauti_->viscosity_of_netting();
}

void WaterReader::take_model() {
  if (!tauti_ || diagnostics_.errors() > 0) return;
  if (const Part* dry = find_part_above_water(out_.scene))
    root_.table("water").error("model_twine_scale", "Tauti's rule is for what is under water, and " +
                                                        formats::in_quotes(dry->name) + " may be above it");
  if (out_.analysis.kind == AnalysisKind::dynamics)
    root_.table("water").error("model_twine_scale",
                               "Tauti's rule knows no masses: it is for kind = \"static\"");
  tauti_->scale_ropes_and_floats(out_.scene);
}

void WaterReader::lay_bottom() {
  if (bottom_.empty()) return;
  bool is_felt = false;
  for (std::size_t p = 0; p < draft_.types.size(); ++p)
    is_felt |= bottom_.lay_under(*draft_.types[p], out_.scene.parts[p]);
  if (!is_felt)
    root_.table("bed").error("bottom", "has no effect, because nothing that rests on the bed uses it",
                             "a part of the type seabed/bed, or a board that ploughs");
}

const char* WaterReader::uneven_key() const {
  const SeaBed& bed = out_.scene.bed;
  if (bed.slope_y != 0) return "slope_y";
  if (!bed.relief.empty() && !bed.relief.is_even_in_y()) return "relief";
  return bottom_.is_symmetric() ? nullptr : "bottom";
}

}  // namespace netloft::scenes
