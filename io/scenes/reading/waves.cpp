// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/waves.hpp"

#include "io/formats/units/in_metres.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/parameter_reader.hpp"
#include "io/scenes/water/jonswap.hpp"

#include <cmath>
#include <numbers>

namespace netloft::scenes {

namespace {

double depth_of(const WaveKeys& keys, const Scene& scene) {
  if (keys.depth > 0) return keys.depth;
  return scene.bed.is_there && scene.bed.depth > 0 ? scene.bed.depth
                                                   : std::numeric_limits<double>::infinity();
}

bool is_drawn(const WaveKeys& keys) { return keys.spectrum != 0; }

/// Reports keys of the other kind of waves as errors, because they have no effect. The two kinds are regular
/// waves and spectra.
void refuse_idle(const WaveKeys& keys, formats::TableReader& waves) {
  if (is_drawn(keys)) {
    if (waves.has("phase"))
      waves.error("phase", "is chosen at random for each wave of a spectrum",
                  "leave phase out; another seed gives other phases");
    return;
  }
  for (const char* key : {"peakedness", "components", "seed"})
    if (waves.has(key))
      waves.error(key, "belongs to a spectrum, and these waves are regular", "spectrum = \"jonswap\"");
}

/// Reports breaking waves as an error. Waves break if their height (for a spectrum, the significant height at
/// the peak period) is too large.
void check_height(const WaveKeys& keys, double k, double depth, formats::TableReader& waves) {
  const double length = 2 * std::numbers::pi / k, highest = highest_wave(k, depth);
  if (keys.height >= highest)
    waves.error("height",
                "= " + formats::in_metres(keys.height) + " breaks: waves of this period are " +
                    formats::in_metres(length) + " long and at most " + formats::in_metres(highest) + " high",
                "a smaller height or a longer period");
}

void check_depth(double k, double depth, bool is_own, formats::TableReader& waves) {
  if (!is_shallow(k, depth)) return;
  waves.error(is_own ? "depth" : "period",
              "makes waves of " + formats::in_metres(2 * std::numbers::pi / k) + " in " +
                  formats::in_metres(depth) +
                  " of water, longer than 20 times the depth: linear wave theory does not describe them",
              "a shorter period or deeper water");
}

AiryWaves::Sea sea_of(const WaveKeys& keys, double depth) {
  AiryWaves::Sea sea{{}, keys.direction, depth, keys.ramp, keys.stretching == 0};
  if (is_drawn(keys))
    sea.components = sample({keys.height, keys.period, keys.peakedness, keys.components, keys.seed});
  else
    sea.components = {{keys.height / 2, 2 * std::numbers::pi / keys.period, keys.phase}};
  return sea;
}

}  // namespace

std::shared_ptr<const WaterField> read_waves(formats::TableReader& water, const Scene& scene) {
  if (!water.has("waves")) return nullptr;
  formats::TableReader waves = water.table("waves");
  const int before = waves.diagnostics().errors();
  const Values values = read_parameters(wave_keys(), waves);
  std::vector<std::string> faults;
  const ParameterBlock block(wave_keys(), sizeof(WaveKeys), values, faults);
  if (!faults.empty() || waves.diagnostics().errors() > before) return nullptr;
  const auto& keys = *static_cast<const WaveKeys*>(block.data());
  refuse_idle(keys, waves);
  if (scene.water.gravity == 0) {
    waves.error("height", "is given in water without gravity, which has no waves", "water.gravity = 9.80665");
    return nullptr;
  }
  const double depth = depth_of(keys, scene), omega = 2 * std::numbers::pi / keys.period;
  const double k = wave_number(omega, scene.water.gravity, depth);
  check_height(keys, k, depth, waves);
  check_depth(k, depth, keys.depth > 0, waves);
  if (waves.diagnostics().errors() > before) return nullptr;
  return std::make_shared<AiryWaves>(sea_of(keys, depth), scene.water.gravity, scene.current);
}

}  // namespace netloft::scenes
