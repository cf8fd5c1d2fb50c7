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
        "length of the full-scale gear over that of the model in the tank; the scene is at full scale, and "
        "Reynolds numbers are those of the model: divided by this to the power 1.5 if model_twine_scale is 0",
        {.lo = 1, .hi = 1000, .fallback = 1});
    t.real("model_twine_scale", &WaterKeys::model_twine_scale, "1",
           "bars and twines of the full-scale gear over those of a model scaled by Tauti's rule, at most "
           "model_scale; 0: the model is scaled by Froude's rule",
           {.lo = 0, .hi = 1000, .fallback = 0});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> wave_keys() {
  static const auto table = [] {
    ParameterTable<WaveKeys> t;
    t.choice("spectrum", &WaveKeys::spectrum,
             "regular: one wave; jonswap: an irregular sea with that spectrum", {"regular", "jonswap"});
    t.real("height", &WaveKeys::height, "m",
           "height from trough to crest; for a spectrum, the significant height", {.lo = 1e-9, .hi = 40});
    t.real("period", &WaveKeys::period, "s", "period in still water; for a spectrum, its peak period",
           {.lo = 0.1, .hi = 100});
    t.real("direction", &WaveKeys::direction, "rad", "direction in which the waves travel, from x towards y",
           {.lo = -6.2832, .hi = 6.2832, .fallback = 0});
    t.real("phase", &WaveKeys::phase, "rad",
           "phase of a regular wave; 0: a crest is at x = y = 0 at time zero",
           {.lo = -6.2832, .hi = 6.2832, .fallback = 0});
    t.real("depth", &WaveKeys::depth, "m",
           "depth of the water; 0: the depth of [bed], or deep water without one",
           {.lo = 0, .hi = 2e4, .fallback = 0});
    t.real("ramp", &WaveKeys::ramp, "s", "time over which the waves grow from zero, from time zero on",
           {.lo = 0, .hi = 1e6, .fallback = 0});
    t.choice("stretching", &WaveKeys::stretching,
             "wheeler: velocities at z = 0 are moved to the instantaneous surface; none: they stay at z = 0 "
             "and are constant above it",
             {"wheeler", "none"});
    t.real("peakedness", &WaveKeys::peakedness, "1",
           "gamma of the spectrum; 1 gives the spectrum of Pierson and Moskowitz",
           {.lo = 1, .hi = 10, .fallback = 3.3});
    t.integer("components", &WaveKeys::components, "number of regular waves that make up the spectrum", 1,
              2000, 100);
    t.integer("seed", &WaveKeys::seed, "each seed gives another sea of the same spectrum", 0, 4294967295, 1);
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> tow_keys() {
  static const auto table = [] {
    ParameterTable<TowKeys> t;
    t.real("speed", &TowKeys::speed, "m/s",
           "speed over the ground: water and ground pass the gear aft at this speed; 0: the ground does not "
           "move",
           {.lo = 0, .hi = 50});
    t.real("leeway", &TowKeys::leeway, "rad",
           "direction in which water and ground pass the gear, from x towards y",
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
    t.grid("relief", &BedKeys::relief, "height of the bed above the plane of depth and slopes, on a grid",
           {{"x", "m"}, {"y", "m"}, {"height", "m"}});
    t.grid("bottom", &BedKeys::bottom,
           "factors on the stiffness, friction and ploughing resistance of the parts that rest on the bed, "
           "on a grid",
           {{"x", "m"}, {"y", "m"}, {"stiffness", "1"}, {"friction", "1"}, {"ploughing", "1"}});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> analysis_keys() {
  static const auto table = [] {
    ParameterTable<AnalysisKeys> t;
    t.choice("kind", &AnalysisKeys::kind, "what is computed: the static equilibrium, or the motion in time",
             {"static", "dynamic"});
    t.text("strategy", &AnalysisKeys::strategy,
           "strategy plugin that searches for the equilibrium; a table of its name has its parameters; the "
           "default is direct if the scene names a solver",
           kStrategy);
    t.text("solver", &AnalysisKeys::solver,
           "solver plugin for the stages of the strategy or the steps of a motion; a table of its name has "
           "its parameters",
           kSolver);
    t.real("tolerance", &AnalysisKeys::tolerance, "1", "largest nodal residual over the largest nodal load",
           {.lo = 1e-16, .hi = 1, .fallback = Limits{}.tolerance});
    t.integer("max_iterations", &AnalysisKeys::max_iterations,
              "largest number of iterations of one stage, or of one step of a motion", 0, 1000000,
              Limits{}.iterations);
    t.real("work", &AnalysisKeys::work, "1",
           "budget of all stages, in Newton iterations of the full scene; the same on every machine",
           {.lo = 0, .hi = 1e12, .fallback = 20000});
    t.real("max_seconds", &AnalysisKeys::max_seconds, "s", "processor time after which the search stops",
           {.lo = 0, .hi = 1e9, .fallback = 1e9});
    t.choice("tangent", &AnalysisKeys::tangent,
             "which part of the tangent of forces without an energy (drag) is used: all of it, its symmetric "
             "part, none",
             {"exact", "symmetric", "elastic"});
    t.choice("swinging", &AnalysisKeys::swinging,
             "an equilibrium about which a part swings with growing amplitude, such as an empty cod-end, is "
             "refused as unstable, or accepted as the middle of the swing",
             {"refused", "accepted"});
    return t;
  }();
  return table.rows();
}

std::span<const netloft_parameter> gear_keys() {
  static const auto table = [] {
    ParameterTable<GearKeys> t;
    t.text("title", &GearKeys::title, "name of the gear for reports", "");
    t.text("source", &GearKeys::source, "where the net plan comes from", "");
    t.choice("extent", &GearKeys::extent,
             "the whole gear, or its starboard half if gear and current are symmetric about y = 0",
             {"whole", "half"});
    t.integer("nodes", &GearKeys::nodes,
              "approximate number of nodes of the whole model, at least 20; finer parts add to it; 0: size "
              "decides; \"knots\": a node at every knot of the netting",
              0, 1000000, 2000);
    t.real("size", &GearKeys::size, "m", "side length of the triangles, instead of nodes; 0: nodes decides",
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
       "contact with the bed: footrope, bridles, sweeps and legs by their roles, points toe and heel of "
       "boards",
       NETLOFT_NODE},
  };
  return all;
}

}  // namespace netloft::scenes
