// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/keys.hpp"

#include "framework/balance/static_problem.hpp"
#include "framework/scene/standard_gravity.hpp"

namespace netloft::scenes {

std::span<const netloft_parameter> water_keys() {
  static const auto table = [] {
    ParameterTable<WaterKeys> t;
    t.real("density", &WaterKeys::density, "kg/m3", "density of the water; 0 is air",
           {.lo = 0, .hi = 3000, .fallback = 1025});
    t.real("gravity", &WaterKeys::gravity, "m/s2", "acceleration of gravity, downwards",
           {.lo = 0, .hi = 100, .fallback = kStandardGravity});
    t.real("viscosity", &WaterKeys::viscosity, "m2/s", "kinematic viscosity of the water",
           {.lo = 1e-9, .hi = 1, .fallback = 1.19e-6});
    t.real(
        "model_scale", &WaterKeys::model_scale, "1",
        "lengths of the gear over those of its model in a tank, which is computed; without model_twine_scale "
        "by Froude's rule: Reynolds numbers are smaller by this to the power 1.5",
        {.lo = 1, .hi = 1000, .fallback = 1});
    t.real("model_twine_scale", &WaterKeys::model_twine_scale, "1",
           "bars and twines of the gear over those of a model by Tauti's rule, not above model_scale; 0: the "
           "model is by Froude's rule",
           {.lo = 0, .hi = 1000, .fallback = 0});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> wave_keys() {
  static const auto table = [] {
    ParameterTable<WaveKeys> t;
    t.choice("spectrum", &WaveKeys::spectrum, "regular: one wave; jonswap: a sea of that spectrum",
             {"regular", "jonswap"});
    t.real("height", &WaveKeys::height, "m", "from trough to crest; of a spectrum, the significant height",
           {.lo = 1e-9, .hi = 40});
    t.real("period", &WaveKeys::period, "s", "in water that does not flow; of a spectrum, that of its peak",
           {.lo = 0.1, .hi = 100});
    t.real("direction", &WaveKeys::direction, "rad", "into which they travel, from x towards y",
           {.lo = -6.2832, .hi = 6.2832, .fallback = 0});
    t.real("phase", &WaveKeys::phase, "rad", "of a regular wave; 0: a crest at x = y = 0 at time zero",
           {.lo = -6.2832, .hi = 6.2832, .fallback = 0});
    t.real("depth", &WaveKeys::depth, "m", "of the water; 0: that of [bed], or deep water",
           {.lo = 0, .hi = 2e4, .fallback = 0});
    t.real("ramp", &WaveKeys::ramp, "s", "time in which they grow from nothing, from time zero on",
           {.lo = 0, .hi = 1e6, .fallback = 0});
    t.choice(
        "stretching", &WaveKeys::stretching,
        "wheeler: what linear waves have at z = 0 is at the surface; none: at z = 0, and as there above it",
        {"wheeler", "none"});
    t.real("peakedness", &WaveKeys::peakedness, "1",
           "of the spectrum, its gamma; 1 is that of Pierson and Moskowitz",
           {.lo = 1, .hi = 10, .fallback = 3.3});
    t.integer("components", &WaveKeys::components, "waves that a spectrum is made of", 1, 2000, 100);
    t.integer("seed", &WaveKeys::seed, "another one is another sea of the same spectrum", 0, 4294967295, 1);
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> tow_keys() {
  static const auto table = [] {
    ParameterTable<TowKeys> t;
    t.real("speed", &TowKeys::speed, "m/s",
           "speed over the ground, at which water and ground pass the gear, aft; 0: the ground stands",
           {.lo = 0, .hi = 50});
    t.real("leeway", &TowKeys::leeway, "rad", "angle at which they pass it, from x towards y",
           {.lo = -3.1416, .hi = 3.1416, .fallback = 0});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> bed_keys() {
  static const auto table = [] {
    ParameterTable<BedKeys> t;
    t.real("depth", &BedKeys::depth, "m", "depth of the bed below z = 0, at x = y = 0", {.lo = 0, .hi = 2e4});
    t.real("slope_x", &BedKeys::slope_x, "1", "rise of the bed along x",
           {.lo = -10, .hi = 10, .fallback = 0});
    t.real("slope_y", &BedKeys::slope_y, "1", "rise of the bed along y",
           {.lo = -10, .hi = 10, .fallback = 0});
    t.grid("relief", &BedKeys::relief, "height above that plane on a grid, for beds of any shape",
           {{"x", "m"}, {"y", "m"}, {"height", "m"}});
    t.grid("bottom", &BedKeys::bottom,
           "what the bed is made of on a grid: its stiffness, friction and resistance to ploughing over "
           "those of "
           "the parts that rest on it",
           {{"x", "m"}, {"y", "m"}, {"stiffness", "1"}, {"friction", "1"}, {"ploughing", "1"}});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> analysis_keys() {
  static const auto table = [] {
    ParameterTable<AnalysisKeys> t;
    t.choice("kind", &AnalysisKeys::kind, "what is looked for: the static equilibrium, or the motion in time",
             {"static", "dynamic"});
    t.text("strategy", &AnalysisKeys::strategy,
           "strategy plugin, how an equilibrium is found; its own parameters stand in a table of its name; "
           "where only a solver is named: direct",
           kStrategy);
    t.text("solver", &AnalysisKeys::solver,
           "solver plugin, for the stages of the strategy or the steps of a motion; its own parameters stand "
           "in a "
           "table of its name",
           kSolver);
    t.real("tolerance", &AnalysisKeys::tolerance, "1", "largest nodal residual over the largest nodal load",
           {.lo = 1e-16, .hi = 1, .fallback = Limits{}.tolerance});
    t.integer("max_iterations", &AnalysisKeys::max_iterations,
              "iterations after which a solver gives up a stage, or a step of a motion", 0, 1000000,
              Limits{}.iterations);
    t.real("work", &AnalysisKeys::work, "1",
           "budget of all stages together, in Newton iterations of the scene as it is written; the same on "
           "every "
           "machine",
           {.lo = 0, .hi = 1e12, .fallback = 20000});
    t.real("max_seconds", &AnalysisKeys::max_seconds, "s",
           "processor time after which the search is given up", {.lo = 0, .hi = 1e9, .fallback = 1e9});
    t.choice(
        "tangent", &AnalysisKeys::tangent,
        "what counts of the tangent of forces without an energy (drag): all, its symmetric part, nothing",
        {"exact", "symmetric", "elastic"});
    t.choice("swinging", &AnalysisKeys::swinging,
             "what an equilibrium is about which something swings, more and more, as an empty cod-end may: "
             "refused as unstable, or accepted as the middle of a small motion",
             {"refused", "accepted"});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> gear_keys() {
  static const auto table = [] {
    ParameterTable<GearKeys> t;
    t.text("title", &GearKeys::title, "what the gear is", "");
    t.text("source", &GearKeys::source, "where its plan comes from", "");
    t.choice("extent", &GearKeys::extent,
             "the whole gear, or its starboard half, for gears and currents that are symmetric about y = 0",
             {"whole", "half"});
    t.integer(
        "nodes", &GearKeys::nodes,
        "about as many nodes in all that is modelled, at least 20; what is finer than its neighbours adds to "
        "them; 0: by size; \"knots\": every knot of the netting",
        0, 1000000, 2000);
    t.real("size", &GearKeys::size, "m", "instead: length of the sides of triangles; 0: by nodes",
           {.lo = 0, .hi = 1000, .fallback = 0});
    return t;
  }();
  return table.rows();
}

std::span<const GearElements> gear_elements() {
  static constexpr GearElements all[] = {
      {"netting", "twine", "priour/triangle", "panels of the net plan", NETLOFT_TRIANGLE},
      {"ropes", "rope", "rope/bar", "ropes, wires and chains of the net plan", NETLOFT_BAR},
      {"floats", "float", "float/float", "floats, weights and ground gear of the net plan", NETLOFT_NODE},
      {kContact, "seabed", "seabed/bed",
       "that touches the bed: footrope, bridles, sweeps and legs by their roles, points toe and heel of "
       "boards",
       NETLOFT_NODE},
  };
  return all;
}

}  // namespace netloft::scenes
