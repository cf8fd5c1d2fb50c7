// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace netloft::real_gears {

using Vector = std::array<double, 3>;

/// A node of a gear in FEMNET; z is up, the surface is at z = 0, all units are SI.
struct NeutralNode {
  Vector initial{}, force{}, box{}, limit{}, sense{};
  double mass = 0;
  std::uint8_t fixed = 0, symmetry = 0;  // axes along which the node is held at `initial`, and those normal
                                         // to a plane of symmetry on which it lies
};

struct NeutralBar {
  std::array<std::uint32_t, 2> nodes{};
  double rest_length = 0, EA = 0, EA_compression = 0, diameter = 0, density = 0;
  double cd_normal = 0, cd_tangent = 0;  // the latter multiplies the former
};

struct NeutralBend {
  std::array<std::uint32_t, 3> nodes{};
  double EI = 0;
};

struct NeutralMaterial {
  double bar_length = 0, EA = 0, EA_compression = 0, diameter = 0, density = 0;
  double cd_normal = 0, cd_tangent = 0;
};

struct NeutralTriangle {
  std::array<std::uint32_t, 3> nodes{};
  std::array<std::array<double, 2>, 3> twine_uv{};
  std::size_t material = 0;
};

/// FEMNET's answer, and the forces out of balance there, by an independent evaluation of FEMNET's formulas.
struct NeutralReference {
  std::vector<Vector> positions;
  std::vector<double> bar_tensions;                   // [N]
  std::vector<std::array<double, 2>> twine_tensions;  // [N] of u, v per triangle
  double mean_residual = 0, largest_component = 0;    // [N]
  struct Reaction {
    std::uint32_t node = 0;
    Vector force{};
  };
  std::vector<Reaction> reactions;  // at fixed nodes [N]
};

/// A run of FEMNET from the flat drawing, with the settings of the file.
struct NeutralRun {
  int iterations = 0;
  double cpu_seconds = 0, mean_residual = 0,
         distance = 0;  // true residual [N]; largest distance from the reference [m]
};

/// A static equilibrium problem in the format femnet-neutral/1, with its answer.
struct NeutralCase {
  std::string name, title;
  double gravity = 0, water_density = 0;
  Vector current{};
  bool drags_netting = false;
  double bed_stiffness = 0, bed_friction = 0;  // for limits on coordinates; friction is zero if the bed is at
                                               // rest
  std::vector<NeutralNode> nodes;
  std::vector<NeutralBar> bars;
  std::vector<NeutralBend> bends;
  std::vector<NeutralMaterial> materials;
  std::vector<NeutralTriangle> triangles;
  NeutralReference reference;
  NeutralRun femnet;
};

/// Throws std::runtime_error that names the file and its wrong or unknown entry.
NeutralCase read_neutral_case(const std::filesystem::path& file);

/// The cases of a folder, by name. Throws if there is none.
std::vector<std::filesystem::path> neutral_files(const std::filesystem::path& folder);

}  // namespace netloft::real_gears
