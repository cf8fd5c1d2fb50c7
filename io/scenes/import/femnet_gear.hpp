// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes::femnet {

/// Gravity in FEMNET [m/s²], inferred from its results for .don files.
inline constexpr double kGravity = 9.81;

using Triple = std::array<double, 3>;

/// A corner of a panel: its position in the drawing of the gear, and its panel coordinates.
struct Corner {
  Triple at{};
  double U = 0, V = 0;  // [meshes]
  int type = 0, side_type = 0;
};

/// A piece of diamond netting. Its numbers have single precision, as in FEMNET.
struct Panel {
  formats::Place place;
  std::vector<Corner> corners;
  double EA = 0, EA_compression = 0, opening = 0, side = 0, density = 0, diameter = 0, knot = 0, cd = 0,
         friction = 0;  // `side` is half a mesh [m]; `friction` is a fraction of cd
  double step = 0;      // requested side of elements [m]
  int inner_type = 0, mesh_type = 0;
  // The next members are set by keywords in the tail of the file.
  double knot_size = 0, EI = 0, neutral_angle = 0;
  // With the keyword netting2ropes, the panel is modelled by bars instead of triangles. Along a twine, `bars`
  // bars replace `twines` mesh sides; each bar also stands for `twines` parallel twines. 0: triangles.
  double twines = 0, bars = 0;
};

/// A rope; its numbers include the effects of all keywords.
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
  std::string floats;  // floats that were spread over the rope, as text
};

/// The properties of all nodes of a type.
struct NodeType {
  formats::Place place;
  Triple mass{}, added_mass{}, box{}, drag{}, force{}, fixed{}, limit{}, sense{}, symmetry{};
};

/// A corner of a panel or an end of a cable, which a link connects to others. Panels, cables and corners are
/// counted from 0.
struct LinkPoint {
  bool is_panel = false;
  int object = 0, corner = 0;
  formats::Place place = {};
};

/// A box in the drawing. Nodes strictly within it get the node type `type`, counted from 0.
struct TypeBox {
  formats::Place place;
  Triple low{}, high{};
  int type = 0;
};

/// Two cables clamped to one another.
struct Clamp {
  formats::Place place;
  int first = 0, second = 0;  // cables, counted from 0
  double angle = 180;         // angle between the cables [degrees]; 180: in line
};

/// A drum (winch) at one end of a cable. Its hauling speed is linear between the times; a negative speed pays
/// out.
struct Drum {
  formats::Place place;
  int cable = 0;                      // number of the cable, from 0
  double shortest = 0, longest = 0;   // limits of the length of a bar [m]
  std::vector<double> times, speeds;  // [s], [m/s]
  std::vector<int> ends;              // end of the cable (1 or 2) that has the drum from each time on
};

/// The motion of all nodes of a type. Velocities are linear between the times, and zero after the last time.
struct NodeMotion {
  formats::Place place;
  int type = 0;  // number of the type, from 0
  std::vector<double> times;
  std::array<std::vector<double>, 3> velocity;
};

/// A number that the file requests as output.
struct Wanted {
  enum class Kind { distance, force, tension, position } kind = Kind::position;
  std::string text;
  int first = 0, second = 0;  // two nodes, cable and node, or node and axis, numbered as in the file
};

struct Environment {
  // Direction [degrees] and speed [m/s] of the current, depth [m].
  double direction = 0, speed = 0, depth = 0;
  double wave_period = 0, wave_height = 0, wave_direction = 0;       // [s], [m], [degrees]
  double time_step = 0, record_step = 0, record_begin = 0, end = 0;  // times of the motion [s]
  double catch_volume = 0, catch_accuracy = 0, catch_coefficient = 0;
  double bed_friction = 0, bed_stiffness = 0;  // stiffness of the bed and of other limits of positions [N/m]
  double tolerance = 0;                        // [N]
  double water_density = 1025;
  bool bed_moves = false;
  int drag_type = 1;
  int wave_model = 1;    // 1: first order; 2 and 3: higher orders
  formats::Place waves;  // place of the waves in the file
};

/// A feature of the gear file that the import changes or leaves out.
struct Finding {
  enum class Kind { note, left_out };  // left_out: results differ from those of FEMNET
  formats::Place place;
  Kind kind = Kind::note;
  std::string what;  // such as "keyword tarp"
  std::string text;
};

/// The contents of a .don file, the gear file of FEMNET.
struct GearFile {
  std::vector<Panel> panels;
  std::vector<Cable> cables;
  std::vector<NodeType> types;
  std::vector<std::vector<LinkPoint>> links;
  std::vector<LinkPoint> order;  // order in which panels and cables are meshed; `corner` is not used
  std::vector<Clamp> clamps;
  std::vector<Wanted> wanted;
  std::vector<Drum> drums;
  std::vector<NodeMotion> motions;
  Environment environment;
  double link_distance = 0;  // corners closer than this in the drawing are the same point [m]
  int plane = 3;             // axis normal to the drawing
  std::vector<TypeBox> type_boxes;
  std::vector<Finding> of_mesher;  // keywords that have no effect if there is a mesh
  std::vector<Finding> of_motion;  // keywords that have no effect at rest
  std::vector<Finding> findings;
};

/// The contents of a .mdg file, the mesh of a gear; indices count from 0.
struct MeshFile {
  struct Node {
    Triple at{};
    int type = 0;
  };
  struct Bar {
    std::array<std::uint32_t, 2> nodes{};
    std::array<double, 2> shares{};
    int cable = 0;  // as in the file, from 1: k > 0 is cable k, -p the twines of panel p
  };
  struct Triangle {
    std::array<std::uint32_t, 3> nodes{};
    std::array<double, 6> UV{};
    int panel = 0;  // index of the panel, from 0
  };
  std::vector<Node> nodes;
  std::vector<Bar> bars;
  std::vector<Triangle> triangles;
  bool is_of_another_gear = false;  // true: rows name parts that the .don does not have
};

/// The features of FEMNET that a gear uses, in words, for a table that compares many gears.
std::vector<std::string> features_of(const GearFile& gear);

/// Reads a .don. Lines end with LF, CR LF or CR. Errors and warnings are reported at their line and column;
/// `file` is the index of `text` among the sources of `diagnostics`. After an error the result contains
/// whatever could be read.
GearFile read_gear(const std::string& text, int file, formats::Diagnostics& diagnostics);

/// Reads the .mdg of a gear. A row that names a node type, cable or panel that the gear lacks is an error.
MeshFile read_mesh_file(const std::string& text, int file, const GearFile& gear,
                        formats::Diagnostics& diagnostics);

/// Divides a gear without a mesh: panels into triangles on a lattice whose spacing is their meshing step, as
/// in FEMNET, and cables into bars; linked corners and ends become one node. Panels with netting2ropes, which
/// FEMNET divides into bars, are divided into triangles, too. Errors are reported at the panel, cable or
/// link. A gear with more than `most_nodes` nodes is an error.
MeshFile divide_gear(const GearFile& gear, formats::Diagnostics& diagnostics, double most_nodes = 1e6);

}  // namespace netloft::scenes::femnet
