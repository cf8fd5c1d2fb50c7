// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/scenes/import/drums.hpp"

namespace netloft::scenes::femnet {

/// Names of files in the scene that is made.
struct Names {
  std::string gear, mesh;  // read: "b1.don", "b1.mdg"; the second is empty if the gear was divided here
  std::string own_mesh;    // written beside the scene: "b1.mesh"
};

/// A gear file and its mesh as a scene and a mesh of ours.
struct Imported {
  std::string scene;
  formats::InputMesh mesh;
  std::vector<Finding> findings;  // those of the gear, and what could not be carried over
};

/// The equilibrium or the motion: FEMNET has a solver for each, with the same file.
enum class Sought { rest, motion };

/// Numbers that a scene would not accept are errors at their place in the gear file.
Imported import_gear(const GearFile& gear, const MeshFile& mesh, const Names& names,
                     formats::Diagnostics& diagnostics, Sought sought = Sought::rest);

/// The mesh of a gear: a region for each panel and cable that has elements, sets of nodes by type, for the
/// types that are held or loaded. Corners of triangles are turned round, because FEMNET counts them
/// clockwise as seen from outside. Bars that drums haul have regions of their own.
formats::InputMesh make_mesh(const GearFile& gear, const MeshFile& file,
                             const std::vector<HauledBar>& hauled = {});

/// "panel-3", "cable-12", "type-4", from numbers that begin with 0.
std::string panel_name(std::size_t panel);
std::string cable_name(std::size_t cable);
/// "cable-12-bar-3": one that a drum hauls, by its place along the cable.
std::string bar_name(std::size_t cable, std::size_t number);
std::string type_name(std::size_t type);
/// "plane-y": nodes of cables that bend, in the plane of symmetry across an axis.
std::string plane_name(std::size_t axis);

/// Whether nodes of the type are held, loaded or limited.
bool is_special(const NodeType& type);

/// Length of a bar of netting2ropes, and its mesh sides [m]; stiffness of all its twines [N]. In the
/// precision in which FEMNET keeps them.
struct TwineBar {
  explicit TwineBar(const Panel& panel);
  double length, sides, EA, EA_compression;
};

/// For each connected piece of the gear that the file does not hold along some axes: a node that is held
/// there.
struct Loose {
  std::uint32_t node;
  std::array<bool, 3> axes;
};
std::vector<Loose> find_loose(const GearFile& gear, const MeshFile& file);

}  // namespace netloft::scenes::femnet
