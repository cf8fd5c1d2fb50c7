// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_scene.hpp"
#include "io/scenes/import/scene_text.hpp"

namespace netloft::scenes::femnet {

inline constexpr const char* kAxis[] = {"x", "y", "z"};
inline constexpr double kMostMass = 1e6;  // largest mass of a node that a scene accepts [kg]

/// A scene that is being written: the gear from which it is made, and its text so far. The functions note()
/// and leave_out() record features of the gear that a scene cannot represent.
class SceneDraft {
 public:
  SceneDraft(const GearFile& of, const MeshFile& its_mesh, const Names& own_names,
             formats::Diagnostics& diagnostics, Sought sought)
      : gear(of),
        file(its_mesh),
        names(own_names),
        moves(sought == Sought::motion),
        diagnostics_(diagnostics) {
    out.findings = gear.findings;
  }

  const GearFile& gear;
  const MeshFile& file;
  const Names& names;
  bool moves;
  std::vector<HauledBar> hauled;  // bars that drums haul; empty if the scene is at rest
  Imported out;
  SceneText body;

  const Environment& environment() const { return gear.environment; }
  bool has_current() const { return environment().speed != 0; }
  /// Whether the file has waves that a scene can represent.
  bool has_waves() const;
  /// Whether water may move relative to the gear: there is a current or a motion.
  bool has_flow() const { return has_current() || moves; }
  /// Whether the gear is towed: water and bed pass it with the same velocity, and the mesh has nodes that
  /// rest on the bed.
  bool is_towed() const;
  /// The direction in which the water flows [rad], not wrapped.
  double flow_angle() const;
  /// The direction in which the water flows [rad], wrapped to the interval from -180 to 180 degrees.
  double heading() const;
  /// Whether the mesh has nodes of a type.
  bool has_nodes(std::size_t type) const;

  void note(const formats::Place& place, const std::string& what, const std::string& text) {
    out.findings.push_back({place, Finding::Kind::note, what, text});
  }
  void leave_out(const formats::Place& place, const std::string& what, const std::string& text) {
    out.findings.push_back({place, Finding::Kind::left_out, what, text});
  }
  /// Returns `value` if it is between `lo` and `hi`, as a scene requires; otherwise adds an error at its
  /// place.
  double within(double value, double lo, double hi, const formats::Place& place, const std::string& what);

  void begin_part(const std::string& name, const std::string& type, const std::string& comment = {}) {
    body.begin_part(name, type, comment);
  }
  template <class Value>
  void line(const std::string& key, const Value& value) {
    body.line(key, value);
  }
  void stands_on_mesh() { line("mesh", quoted(names.own_mesh)); }
  void write_drag(double cd, double friction, const formats::Place& place);

 private:
  formats::Diagnostics& diagnostics_;
};

/// Writes a list such as "[0, 1.5]" with nine decimals. Times are sums of time steps, whose rounding errors
/// are smaller.
std::string list_of(const std::vector<double>& numbers);

/// Finds the bars that drums haul, and their lengths over time. Each of these bars becomes a part of its own,
/// and loses its bending stiffness towards its neighbours.
void find_hauled(SceneDraft& to);

void write_netting(SceneDraft& to);
void write_cables(SceneDraft& to);
void write_clamps(SceneDraft& to);
/// Writes everything that node types make act on nodes: masses, boxes of buoyancy, forces and beds.
void write_loads(SceneDraft& to);
void write_catch(SceneDraft& to);
void write_holds(SceneDraft& to);
/// Writes a hold for one node of every connected piece of the gear that nothing in the file holds.
void hold_what_is_loose(SceneDraft& to);
/// Writes the results that the file requests.
void write_results(SceneDraft& to);

}  // namespace netloft::scenes::femnet
