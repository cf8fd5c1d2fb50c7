// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/imported_motion.hpp"

#include "io/formats/mesh/mesh.hpp"
#include "io/formats/units/degrees.hpp"
#include "io/scenes/import/scene_text.hpp"
#include "io/scenes/water/airy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::scenes::femnet {

namespace {

double number_of_waves(const Environment& e) {
  return wave_number(2 * std::numbers::pi / e.wave_period, kGravity, e.depth);
}

/// Converts a direction in degrees to radians from -π to π.
double wrapped_radians(double degrees) { return formats::in_radians(std::remainder(degrees, 360)); }

}  // namespace

std::string fault_of_waves(const Environment& e) {
  const auto is_within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!is_within(e.wave_period, 0.1, 100)) return "their period is not within 0.1 and 100 s";
  if (!is_within(e.wave_height, 1e-9, 40)) return "their height is not within 0 and 40 m";
  if (!is_within(e.depth, 1e-3, 20000)) return "the depth of the water is not within 0.001 and 20000 m";
  const double k = number_of_waves(e);
  if (e.wave_height >= highest_wave(k, e.depth))
    return "they would break at " + formats::spell_number(std::round(100 * highest_wave(k, e.depth)) / 100) +
           " m";
  return is_shallow(k, e.depth) ? "they are longer than 20 depths, and not linear" : "";
}

std::string waves_text(const Environment& e) {
  return "waves = " + InlineTable()
                          .add("height", e.wave_height)
                          .add("period", e.wave_period)
                          .add_unless_zero("direction", wrapped_radians(e.wave_direction))
                          .add("depth", e.depth)
                          .add("ramp", e.wave_period)
                          .add("stretching", quoted("none"))
                          .text();
}

double rise_of_second_order(const Environment& e) {
  const double a = e.wave_height / 2, k = number_of_waves(e), t = std::tanh(k * e.depth);
  return a * a * k * (3 - t * t) / (4 * t * t * t);
}

std::string motion_text(const Environment& e) {
  const bool has_end = e.end >= 1e-9 && e.end <= 1e9;
  const double end = has_end ? e.end : 10;
  const double interval = e.record_step > 0 && e.record_step <= end ? e.record_step : end / 100;
  return "\n[analysis]  # at rest: netloft run … --set analysis.kind=static\nkind = \"dynamic\"\nstart = "
         "\"equilibrium\"\nduration = " +
         formats::spell_number(end) + (has_end ? "" : "  # none in the file") +
         "\noutput_interval = " + formats::spell_number(interval) + "\n";
}

}  // namespace netloft::scenes::femnet
