// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/scenes/import/drums.hpp"

namespace netloft::scenes::femnet {

/// The names of the files of an import.
struct Names {
  // Files that were read, "b1.don" and "b1.mdg"; `mesh` is empty if the import divided the gear.
  std::string gear, mesh;
  std::string own_mesh;  // mesh file that the import writes beside the scene, "b1.mesh"
};

/// The scene and the mesh made from a gear file and its mesh.
struct Imported {
  std::string scene;
  formats::InputMesh mesh;
  std::vector<Finding> findings;  // features of the gear that the import changes or leaves out
};

/// The kind of analysis that the scene is for. FEMNET has two solvers for the same file, one for the
/// equilibrium and one for the motion.
enum class Sought { rest, motion };

/// Converts a gear and its mesh. A number that a scene does not accept is reported as an error at its place
/// in the gear file.
Imported import_gear(const GearFile& gear, const MeshFile& mesh, const Names& names,
                     formats::Diagnostics& diagnostics, Sought sought = Sought::rest);

/// The mesh of a gear: a region for each panel and cable that has elements, and a set of nodes for each node
/// type that is held or loaded. The corners of each triangle are put in reverse order, because in FEMNET they
/// are clockwise seen from outside. Each bar that a drum hauls has its own region.
formats::InputMesh make_mesh(const GearFile& gear, const MeshFile& file,
                             const std::vector<HauledBar>& hauled = {});

/// The names of parts, such as "panel-3", "cable-12" and "type-4", from indices that count from 0.
std::string panel_name(std::size_t panel);
std::string cable_name(std::size_t cable);
/// The name of a bar that a drum hauls, such as "cable-12-bar-3", by its position along the cable.
std::string bar_name(std::size_t cable, std::size_t number);
std::string type_name(std::size_t type);
/// The name of a set of nodes, such as "plane-y". It contains the nodes in the plane of symmetry normal to
/// `axis` that belong to cables with bending stiffness.
std::string plane_name(std::size_t axis);

/// Whether nodes of the type are held, loaded or limited in their position.
bool is_special(const NodeType& type);

/// A bar that stands for twines of a panel with netting2ropes: its length [m], the number of mesh sides along
/// it, and the stiffness of all its twines [N]. The numbers have single precision, as in FEMNET.
struct TwineBar {
  explicit TwineBar(const Panel& panel);
  double length, sides, EA, EA_compression;
};

/// A node that the scene must hold along `axes`, because nothing in the file stops the connected piece of
/// gear with this node from drifting along these axes.
struct Loose {
  std::uint32_t node;
  std::array<bool, 3> axes;
};
std::vector<Loose> find_loose(const GearFile& gear, const MeshFile& file);

}  // namespace netloft::scenes::femnet
