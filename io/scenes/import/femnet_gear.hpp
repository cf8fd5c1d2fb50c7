// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes::femnet {

/// Gravity of FEMNET [m/s²]: its answers to the same files are found with it.
inline constexpr double kGravity = 9.81;

using Triple = std::array<double, 3>;

/// A corner of a panel in the drawing.
struct Corner {
  Triple at{};
  double U = 0, V = 0;  // [meshes]
  int type = 0, side_type = 0;
};

/// A piece of diamond netting; numbers in the precision in which FEMNET keeps them.
struct Panel {
  formats::Place place;
  std::vector<Corner> corners;
  double EA = 0, EA_compression = 0, opening = 0, side = 0, density = 0, diameter = 0, knot = 0, cd = 0,
         friction = 0;  // `side` is half a mesh [m]; `friction` is a fraction of cd
  double step = 0;      // wanted sides of elements [m]
  int inner_type = 0, mesh_type = 0;
  // set by keywords of the tail:
  double knot_size = 0, EI = 0, neutral_angle = 0;
  double twines = 0, bars = 0;  // netting2ropes: twines of a bar, bars to as many mesh sides; 0: triangles
};

/// A rope, numbers as they are after all keywords.
struct Cable {
  struct End {
    Triple at{};
    int type = 0;
  };
  formats::Place place;
  std::array<End, 2> ends;
  double EA = 0, EA_compression = 0, length = 0, density = 0, diameter = 0, cd = 0, friction = 0;
  int bars = 0, inner_type = 0;
  double EI = 0;
  double constant_tension = 0;
  std::string floats;  // what was smeared on it, in words
};

/// The properties of all nodes of a type.
struct NodeType {
  formats::Place place;
  Triple mass{}, added_mass{}, box{}, drag{}, force{}, fixed{}, limit{}, sense{}, symmetry{};
};

/// A point of a link: corner of a panel or end of a cable, counted from 0.
struct LinkPoint {
  bool is_panel = false;
  int object = 0, corner = 0;
  formats::Place place = {};
};

/// Nodes strictly within a box of the drawing get a type, counted from 0.
struct TypeBox {
  formats::Place place;
  Triple low{}, high{};
  int type = 0;
};

/// Two cables clamped to one another.
struct Clamp {
  formats::Place place;
  int first = 0, second = 0;  // cables, counted from 0
  double angle = 180;         // [degrees], 180 in line
};

/// A drum at one end of a cable: it hauls at a speed that is straight between the times, and pays out below
/// zero.
struct Drum {
  formats::Place place;
  int cable = 0;                      // counted from 0
  double shortest = 0, longest = 0;   // lengths of bars that it leaves behind [m]
  std::vector<double> times, speeds;  // [s], [m/s]
  std::vector<int> ends;              // of the cable, 1 or 2, where it is from each time on
};

/// Nodes of a type that move at velocities that are straight between the times, and stand still after them.
struct NodeMotion {
  formats::Place place;
  int type = 0;  // counted from 0
  std::vector<double> times;
  std::array<std::vector<double>, 3> velocity;
};

/// A number that the file requests as output.
struct Wanted {
  enum class Kind { distance, force, tension, position } kind = Kind::position;
  std::string text;
  int first = 0, second = 0;  // nodes, or cable and node; or node and axis, as in the file
};

struct Environment {
  double direction = 0, speed = 0, depth = 0;                        // [degrees], [m/s], [m]
  double wave_period = 0, wave_height = 0, wave_direction = 0;       // [s], [m], [degrees]
  double time_step = 0, record_step = 0, record_begin = 0, end = 0;  // of motion [s]
  double catch_volume = 0, catch_accuracy = 0, catch_coefficient = 0;
  double bed_friction = 0, bed_stiffness = 0;  // stiffness of every limit [N/m]
  double tolerance = 0;                        // [N]
  double water_density = 1025;
  bool bed_moves = false;
  int drag_type = 1;
  int wave_model = 1;    // 1 of first order, 2 and 3 of higher
  formats::Place waves;  // where they are described
};

/// Something in the file that the import changes or leaves out.
struct Finding {
  enum class Kind { note, left_out };  // left_out: results differ from FEMNET's
  formats::Place place;
  Kind kind = Kind::note;
  std::string what;  // "keyword tarp"
  std::string text;
};

/// The contents of a .don file.
struct GearFile {
  std::vector<Panel> panels;
  std::vector<Cable> cables;
  std::vector<NodeType> types;
  std::vector<std::vector<LinkPoint>> links;
  std::vector<LinkPoint> order;  // of meshing; `corner` is not used
  std::vector<Clamp> clamps;
  std::vector<Wanted> wanted;
  std::vector<Drum> drums;
  std::vector<NodeMotion> motions;
  Environment environment;
  double link_distance = 0;  // corners nearer than this in the drawing are one [m]
  int plane = 3;             // axis normal to the drawing
  std::vector<TypeBox> type_boxes;
  std::vector<Finding> of_mesher;  // keywords that change nothing where there is a mesh
  std::vector<Finding> of_motion;  // keywords that change nothing at rest
  std::vector<Finding> findings;
};

/// The contents of a .mdg file; everything counted from 0.
struct MeshFile {
  struct Node {
    Triple at{};
    int type = 0;
  };
  struct Bar {
    std::array<std::uint32_t, 2> nodes{};
    std::array<double, 2> shares{};
    int cable = 0;  // of the file: k > 0 rope, -p twines of a panel
  };
  struct Triangle {
    std::array<std::uint32_t, 3> nodes{};
    std::array<double, 6> UV{};
    int panel = 0;  // from 0
  };
  std::vector<Node> nodes;
  std::vector<Bar> bars;
  std::vector<Triangle> triangles;
  bool is_of_another_gear = false;  // rows speak of what the .don has not: the mesh is older
};

/// The features of FEMNET that a gear uses, in words, for a table of many gears.
std::vector<std::string> features_of(const GearFile& gear);

/// Reads a .don. Lines end with LF, CR LF or CR. Errors and warnings are located in source `file`; after an
/// error the result contains whatever could be read.
GearFile read_gear(const std::string& text, int file, formats::Diagnostics& diagnostics);

/// Reads the .mdg of a gear, whose numbers of types, cables and panels its rows must keep to.
MeshFile read_mesh_file(const std::string& text, int file, const GearFile& gear,
                        formats::Diagnostics& diagnostics);

/// Divides a gear that has no mesh: panels into triangles on a lattice of their meshing step, as FEMNET does,
/// cables into bars; linked corners and ends are connected. Netting for which FEMNET would use bars becomes
/// triangles, too. Errors have the place of the panel, cable or link; more than `most_nodes` nodes are an
/// error.
MeshFile divide_gear(const GearFile& gear, formats::Diagnostics& diagnostics, double most_nodes = 1e6);

}  // namespace netloft::scenes::femnet
