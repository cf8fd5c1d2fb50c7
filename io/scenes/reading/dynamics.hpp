// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/registry/registry.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <netloft/parameters.hpp>

#include <filesystem>
#include <span>

namespace netloft::scenes {

/// How a scene is integrated in time.
struct Dynamics {
  std::string integrator = {};
  Values integrator_parameters = {};
  MarchSettings march = {};
  bool material_damping = true;           // whether loss factors of parts are used
  double stiffness_damping = 0;           // β of Rayleigh's damping β K [s]; α is march.mass_damping
  bool from_equilibrium = false;          // start; otherwise from the sketch or start_file. Always at rest
  std::filesystem::path start_file = {};  // a result file; relative to the scene unless absolute
};

/// The keys of `[analysis]` about motions.
std::span<const netloft_parameter> dynamics_keys();

/// Reads dynamics_keys(). Throws PluginRefused if there is no such integrator.
Dynamics read_dynamics(formats::TableReader& analysis, Registry& registry);

/// Whether the name of a solver is that of an integrator, which marches in time until everything is at rest.
bool is_integrator(Registry& registry, const std::string& name);

/// Reads `displacement` or `velocity` of a `[[hold]]`: columns over `t`. Displacements are interpolated by a
/// smooth curve that begins and ends at rest. Velocities are interpolated linearly, and the last velocity
/// continues after the last time.
Course read_course(formats::TableReader& hold);

}  // namespace netloft::scenes
