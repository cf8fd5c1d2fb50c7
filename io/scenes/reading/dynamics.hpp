// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/registry/registry.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <netloft/parameters.hpp>

#include <filesystem>
#include <span>

namespace netloft::scenes {

/// Settings for a motion from the table `[analysis]`.
struct Dynamics {
  std::string integrator = {};
  Values integrator_parameters = {};
  MarchSettings march = {};
  bool material_damping = true;  // whether loss factors of parts are used
  double stiffness_damping = 0;  // β of Rayleigh damping α M + β K [s]; α is march.mass_damping
  // Whether the motion starts from the equilibrium. Otherwise it starts at rest from the positions in
  // start_file or, without this file, from the initial positions.
  bool from_equilibrium = false;
  std::filesystem::path start_file = {};  // result file of the start; relative to the scene unless absolute
};

/// The keys of `[analysis]` for motions.
std::span<const netloft_parameter> dynamics_keys();

/// Reads dynamics_keys(). Throws PluginRefused if there is no such integrator.
Dynamics read_dynamics(formats::TableReader& analysis, Registry& registry);

/// Reads the motion of a hold, the key `displacement` or `velocity` of `[[hold]]`: a table with a column `t`
/// of times. Displacements are interpolated by a smooth curve that begins and ends at rest. Velocities are
/// interpolated linearly, and the last velocity continues after the last time.
Course read_course(formats::TableReader& hold);

}  // namespace netloft::scenes
