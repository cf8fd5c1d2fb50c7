// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/registry/registry.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <netloft/parameters.hpp>

#include <filesystem>
#include <span>

namespace netloft::scenes {

/// How a scene goes through time.
struct Dynamics {
  std::string integrator = {};
  Values integrator_parameters = {};
  MarchSettings march = {};
  bool material_damping = true;           // loss factors of parts count
  double stiffness_damping = 0;           // β of Rayleigh's damping β K [s]; α is march.mass_damping
  bool from_equilibrium = false;          // otherwise from the sketch, or from start_file; always at rest
  std::filesystem::path start_file = {};  // a result; beside the scene unless it is absolute
};

/// Keys of `[analysis]` that speak of time.
std::span<const netloft_parameter> dynamics_keys();

/// Reads them, and the table of the integrator. Throws PluginRefused if there is no such integrator.
Dynamics read_dynamics(formats::TableReader& analysis, Registry& registry);

/// A solver's name that is an integrator's: it goes through time until everything is at rest.
bool is_integrator(Registry& registry, const std::string& name);

/// `displacement` or `velocity` of a `[[hold]]`: columns over `t`. A way is a smooth curve through its points
/// that begins and ends at rest; a velocity is straight between them, and goes on as it ends.
Course read_course(formats::TableReader& hold);

}  // namespace netloft::scenes
