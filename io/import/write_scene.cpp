// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/femnet_scene.hpp"
#include "io/import/motion.hpp"
#include "io/import/scene_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace netloft::io::femnet {

namespace {

constexpr double kGravity = 9.81, kMostMass = 1e6;

/// "Warp tension (N)" as warp-tension-n.
std::string word_of(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_capital = c >= 'A' && c <= 'Z', is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (is_capital || is_plain)
      out += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!out.empty() && out.back() != '-')
      out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out.substr(0, 60);
}

/// Writes one scene; members are tables in the order of the file.
class SceneWriter {
 public:
  SceneWriter(const GearFile& gear, const MeshFile& file, const Names& names, Diagnostics& diagnostics,
              Sought sought)
      : gear_(gear), file_(file), names_(names), diagnostics_(diagnostics), moves_(sought == Sought::motion) {
    out_.findings = gear.findings;
    if (moves_) find_hauled();
    out_.mesh = make_mesh(gear, file, hauled_);
  }

  Imported write() {
    for (std::size_t p = 0; p < gear_.panels.size(); ++p) write_panel(p);
    for (std::size_t c = 0; c < gear_.cables.size(); ++c) write_cable(c);
    for (std::size_t t = 0; t < gear_.types.size(); ++t) write_loads(t);
    write_clamps();
    write_catch();
    for (std::size_t t = 0; t < gear_.types.size(); ++t) write_hold(t);
    hold_what_is_loose();
    write_results();
    moves_ ? note_differences_of_motion() : note_motion();
    if (moves_) body_.add(motion_text(environment()));
    out_.scene = header() + water() + body_.text();
    return std::move(out_);
  }

 private:
  const Environment& environment() const { return gear_.environment; }
  bool has_current() const { return environment().speed != 0; }
  /// Whether there are waves that the scene can have.
  bool has_waves() const {
    return moves_ && environment().wave_height != 0 && fault_of_waves(environment()).empty();
  }
  /// Whether water ever passes what is in it.
  bool has_flow() const { return has_current() || moves_; }

  void find(Finding::Kind kind, const Place& place, const std::string& what, const std::string& text) {
    out_.findings.push_back({place, kind, what, text});
  }
  void note(const Place& place, const std::string& what, const std::string& text) {
    find(Finding::Kind::note, place, what, text);
  }
  void leave_out(const Place& place, const std::string& what, const std::string& text) {
    find(Finding::Kind::left_out, place, what, text);
  }

  /// A number that the scene will accept; else an error where it stands.
  double within(double value, double lo, double hi, const Place& place, const std::string& what) {
    if (!(value >= lo && value <= hi))
      diagnostics_.error(place, what + " = " + spell_number(value) + " is outside [" + spell_number(lo) +
                                    ", " + spell_number(hi) + "]");
    return value;
  }

  std::string header() const {
    const bool is_divided = names_.mesh.empty();
    std::string text = "# Imported from " + in_ascii(names_.gear) +
                       (is_divided ? ", a file" : " and " + in_ascii(names_.mesh) + ", files") +
                       " of FEMNET. Names have the numbers " +
                       (is_divided ? "of that file" : "of those files") + ".\n";
    text += "# Numbers of netting are kept in single precision there, and stand here as they are kept.\n";
    for (const auto& f : out_.findings)
      text += std::string("# ") + (f.kind == Finding::Kind::note ? "note" : "left out") + ", line " +
              std::to_string(f.place.line) + ", " + in_ascii(f.what) + ": " + in_ascii(f.text) + "\n";
    return text;
  }

  std::string water() const {
    const Environment& e = environment();
    std::string text = "\n[water]\ndensity = " + spell_number(e.water_density) + "\ngravity = 9.81\n";
    if (has_waves()) text += waves_text(e) + "\n";
    if (!has_current()) return text;
    if (is_towed())
      return text + "\n[tow]  # the bed passes with the water\nspeed = " + spell_number(std::abs(e.speed)) +
             "\nleeway = " + spell_number(heading()) + "\n";
    const double psi = e.direction * std::numbers::pi / 180;
    const double x = e.speed * std::cos(psi), y = e.direction == 180 ? 0 : e.speed * std::sin(psi);
    return text + "current = [" + spell_number(x) + ", " + spell_number(y) + ", 0]\n";
  }

  /// Whether water and bed pass together, and nodes lie on the bed.
  bool is_towed() const {
    const Environment& e = environment();
    if (!e.bed_moves || e.bed_friction == 0 || !has_current()) return false;
    for (std::size_t t = 0; t < gear_.types.size(); ++t)
      if (gear_.types[t].sense[2] == 1 && has_nodes(t)) return true;
    return false;
  }
  /// Direction to which the water flows, from -180 to 180 degrees [rad].
  double heading() const { return std::remainder(flow_angle(), 2 * std::numbers::pi); }

  void begin_part(const std::string& name, const std::string& type, const std::string& comment = {}) {
    body_.begin_part(name, type, comment);
  }
  template <class Value>
  void line(const std::string& key, const Value& value) {
    body_.line(key, value);
  }
  void stands_on_mesh() { line("mesh", quoted(names_.own_mesh)); }

  void write_drag(double cd, double friction, const Place& place) {
    if (!has_flow()) return;
    line("drag",
         InlineTable()
             .add("law", quoted("hydro/morison"))
             .add("normal", within(cd, 0, 100, place, "the normal drag coefficient"))
             .add("tangential", within(cd * friction, 0, 100, place, "the tangential drag coefficient"))
             .text());
  }

  void write_panel(std::size_t number) {
    const Panel& p = gear_.panels[number];
    const std::string name = panel_name(number);
    const MeshRegion* region = out_.mesh.find(name);
    if (!region) return note(p.place, "panel " + std::to_string(number + 1), "has no elements in the mesh");
    if (region->kind == RegionKind::twines) return write_twines(number, name);
    begin_part(name, "priour/triangle");
    stands_on_mesh();
    line("panel", InlineTable().add("bar", within(p.side, 1e-6, 100, p.place, "the mesh side")).text());
    line("twine", twine_of(p, p.EA, p.EA_compression).text());
    const bool has_drag = environment().drag_type != 3 && environment().drag_type != 4;
    write_drag(has_drag ? p.cd : 0, p.friction, p.place);
    note_of_meshes(p, number);
    if (out_.mesh.find(name + "-twines")) write_twines(number, name + "-twines");
  }

  InlineTable twine_of(const Panel& p, double EA, double EA_compression) {
    InlineTable twine;
    twine.add("diameter", within(p.diameter, 0, 1, p.place, "the diameter of twines"));
    twine.add("EA", within(EA, 0, 1e12, p.place, "the stiffness of twines"));
    twine.add("EA_compression", within(EA_compression, 0, 1e12, p.place, "their stiffness in compression"));
    twine.add("density", within(p.density, 0, 1e6, p.place, "the density of twines"));
    if (p.opening > 0) {
      const double H = p.EI != 0 ? 6 * p.EI / p.side : p.opening;
      twine.add("opening_stiffness", within(H, 0, 1e6, p.place, "the opening stiffness"));
      twine.add("opening_angle", within(p.neutral_angle, 0, 1.5707, p.place, "the neutral angle"));
    }
    twine.add_unless_zero("knot_size", within(p.knot_size, 0, 10, p.place, "the size of knots"));
    return twine.add("surface", 1);
  }

  void note_of_meshes(const Panel& p, std::size_t number) {
    const std::string what = "panel " + std::to_string(number + 1);
    if (p.opening > 0)
      note(
          p.place, what,
          "meshes resist opening with the gradient of an energy, FEMNET's with 2 cos(half angle) times that");
    if (p.knot_size > 0) note(p.place, what, "knots that touch push with an energy of their own here");
  }

  /// One bar for several twines. FEMNET makes one thick twine of them, whose friction is √n too large; here
  /// the coefficient is.
  void write_twines(std::size_t number, const std::string& region) {
    const Panel& p = gear_.panels[number];
    const TwineBar bar(p);
    begin_part(region, "lumped/net", "one bar for " + spell_number(p.twines) + " twines");
    stands_on_mesh();
    line(
        "panel",
        InlineTable().add("bar", within(bar.length / bar.sides, 1e-6, 100, p.place, "the mesh side")).text());
    InlineTable twine;
    twine.add("diameter", within(p.diameter, 0, 1, p.place, "the diameter of twines"));
    twine.add("EA", within(bar.EA / p.twines, 0, 1e12, p.place, "the stiffness of twines"));
    twine.add("EA_compression",
              within(bar.EA_compression / p.twines, 0, 1e12, p.place, "their stiffness in compression"));
    twine.add("density", within(p.density, 0, 1e6, p.place, "the density of twines"));
    line("twine", twine.add("surface", 1).text());
    write_drag(p.cd, p.friction * std::sqrt(p.twines), p.place);
  }

  /// What the author called the cable in what was to be printed.
  std::string called(std::size_t cable) const {
    std::string names;
    for (const auto& w : gear_.wanted)
      if (w.kind == Wanted::Kind::tension && w.first == static_cast<int>(cable) + 1)
        names += (names.empty() ? "" : ", ") + in_ascii(w.text);
    const std::string& floats = gear_.cables[cable].floats;
    return names + (names.empty() || floats.empty() ? "" : "; ") + floats;
  }

  void write_cable(std::size_t number) {
    const Cable& c = gear_.cables[number];
    const std::string what = "cable " + std::to_string(number + 1);
    bool is_there = out_.mesh.find(cable_name(number));
    if (is_there) write_bars(c, cable_name(number), called(number), nullptr);
    for (const auto& h : hauled_) {
      if (file_.bars[h.bar].cable != static_cast<int>(number) + 1) continue;
      write_bars(c, bar_name(number, h.number), is_there ? "" : called(number), &h);
      is_there = true;
    }
    if (!is_there) return note(c.place, what, "has no bars in the mesh");
    if (c.EI > 0) write_mirrors(c, number);
    if (c.constant_tension > 0)
      note(c.place, what, "its tension is constant, also where FEMNET lets it fall");
  }

  /// Bars of a cable: all that nothing hauls, or one that a drum does.
  void write_bars(const Cable& c, const std::string& name, const std::string& comment,
                  const HauledBar* hauled) {
    begin_part(name, "rope/bar", comment);
    stands_on_mesh();
    line("length", within(c.length, 1e-6, 1e6, c.place, "the length of the cable"));
    InlineTable rope;
    rope.add("diameter", within(c.diameter, 0, 10, c.place, "the diameter of the cable"));
    rope.add("EA", within(c.EA, 0, 1e15, c.place, "the stiffness of the cable"));
    rope.add("EA_compression", within(c.EA_compression, 0, 1e15, c.place, "its stiffness in compression"));
    rope.add("density", within(c.density, 0, 1e6, c.place, "the density of the cable"));
    if (c.EI > 0)
      rope.add("EI", within(c.EI, 0, 1e12, c.place, "its bending stiffness"))
          .add("curvature", quoted("nodes"));
    rope.add_unless_zero("constant_tension", within(c.constant_tension, 0, 1e12, c.place, "its tension"));
    rope.add("surface", 1);
    if (hauled)
      rope.add("length_share",
               InlineTable().add("t", list_of(hauled->times)).add("share", list_of(hauled->shares)).text());
    line("rope", rope.text());
    write_drag(c.cd, c.friction, c.place);
  }

  /// "[0, 1.5]", to nine decimals: times are sums of steps.
  static std::string list_of(const std::vector<double>& numbers) {
    std::string list;
    for (const double x : numbers)
      list += (list.empty() ? "" : ", ") + spell_number(std::round(x * 1e9) / 1e9);
    return "[" + list + "]";
  }

  /// Lengths over time of bars that drums haul. They are parts of their own, and bend against no other.
  void find_hauled() {
    const auto hauled = haul(gear_, file_);
    if (hauled) hauled_ = *hauled;
    for (const Drum& d : gear_.drums) {
      const std::string what = "the drum of cable " + std::to_string(d.cable + 1);
      if (!hauled) leave_out(d.place, what, "takes too many steps");
      if (gear_.cables[static_cast<std::size_t>(d.cable)].EI > 0)
        leave_out(d.place, what, "the cable bends, but not where the drum shortens it");
    }
  }

  /// Bars that end in a plane of symmetry bend against their mirror images.
  void write_mirrors(const Cable& c, std::size_t number) {
    const MeshRegion* region = out_.mesh.find(cable_name(number));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto plane = std::find_if(out_.mesh.sets.begin(), out_.mesh.sets.end(),
                                      [&](const auto& set) { return set.name == plane_name(axis); });
      const double side =
          plane == out_.mesh.sets.end() || !region ? 0 : side_of_bars(region->nodes, plane->nodes, axis);
      if (side == 0) continue;
      begin_part("mirror-" + std::to_string(number + 1) + kAxis[axis], "rope/mirror");
      line("on", quoted(cable_name(number) + "." + plane_name(axis)));
      line("mirror", InlineTable()
                         .add("EI", c.EI)
                         .add("axis", quoted(kAxis[axis]))
                         .add("side", quoted(side > 0 ? "positive" : "negative"))
                         .add("curvature", quoted("nodes"))
                         .text());
    }
  }

  /// How far the bars that have one end in a plane reach to one side of it [m]; zero if there are none.
  double side_of_bars(const std::vector<std::uint32_t>& bars, const std::vector<std::uint32_t>& plane,
                      std::size_t axis) const {
    const auto is_there = [&](auto n) { return std::find(plane.begin(), plane.end(), n) != plane.end(); };
    double side = 0;
    for (std::size_t b = 0; b + 1 < bars.size(); b += 2)
      if (is_there(bars[b]) != is_there(bars[b + 1]))
        side += (is_there(bars[b]) ? 1 : -1) *
                (file_.nodes[bars[b + 1]].at[axis] - file_.nodes[bars[b]].at[axis]);
    return side;
  }

  /// Of what stands at a node on planes of symmetry, so much is of this half of the gear.
  static double share_of(const NodeType& t) {
    double share = 1;
    for (const double plane : t.symmetry) share *= plane != 0 ? 0.5 : 1;
    return share;
  }

  bool has_nodes(std::size_t type) const {
    return std::any_of(out_.mesh.sets.begin(), out_.mesh.sets.end(),
                       [&](const auto& set) { return set.name == type_name(type); });
  }

  void begin_load(const std::string& name, const std::string& type, std::size_t on) {
    const double share = share_of(gear_.types[on]);
    begin_part(name + "-" + std::to_string(on + 1), type);
    line("on", quoted("*." + type_name(on)));
    body_.line("each", spell_number(share) +
                           (share == 1 ? "" : "  # of each, what is on this side of the plane of symmetry"));
  }

  void write_loads(std::size_t number) {
    if (!has_nodes(number)) return;
    const NodeType& t = gear_.types[number];
    const bool has_box = t.box[0] != 0 && t.box[1] != 0 && t.box[2] != 0;
    const bool has_mass = t.mass[2] > 0 && t.mass[2] <= kMostMass;
    Triple force = t.force;
    if (!has_mass) force[2] -= t.mass[2] * kGravity;
    const bool has_added_mass = moves_ && added_mass_of(t) > 0;
    if (has_box || has_added_mass)
      write_box(number, has_mass);
    else if (has_mass) {
      begin_load("mass", "float/float", number);
      line("float", InlineTable().add("mass", t.mass[2]).text());
    }
    if (force != Triple{}) {
      begin_load("force", "force/constant", number);
      InlineTable table;
      for (std::size_t axis = 0; axis < 3; ++axis)
        table.add_unless_zero(kAxis[axis], within(force[axis], -1e9, 1e9, t.place, "the force"));
      line("force", table.text());
    }
    write_limits(number);
  }

  /// Added mass is the same along all axes here.
  static double added_mass_of(const NodeType& t) {
    return (t.added_mass[0] + t.added_mass[1] + t.added_mass[2]) / 3;
  }

  void write_box(std::size_t number, bool has_mass) {
    const NodeType& t = gear_.types[number];
    const auto side = [&](std::size_t axis) {
      return within(std::abs(t.box[axis]), 0, 1e3, t.place, "a length of the box");
    };
    const auto drag = [&](std::size_t axis) {
      return within(t.drag[axis], 0, 1e4, t.place, "a drag coefficient of the box");
    };
    begin_load("box", "float/box", number);
    InlineTable box;
    if (has_mass) box.add("mass", t.mass[2]);
    if (moves_)
      box.add_unless_zero("added_mass", within(added_mass_of(t), 0, 1e7, t.place, "the added mass"));
    box.add("length_x", side(0)).add("length_y", side(1)).add("height", side(2));
    if (t.box[2] < 0) box.add("hangs", std::string("true"));
    if (has_flow()) box.add("drag_x", drag(0)).add("drag_y", drag(1)).add("drag_z", drag(2));
    line("box", box.text());
  }

  void write_limits(std::size_t number) {
    const NodeType& t = gear_.types[number];
    const double k = environment().bed_stiffness;
    if (t.sense == Triple{} || k == 0) return;
    const std::string what = "type " + std::to_string(number + 1);
    if (t.sense[0] != 0 || t.sense[1] != 0 || t.sense[2] < 0 || t.sense[2] == 2)
      leave_out(t.place, what, "limits other than a bed below the node are not modelled here");
    if (t.sense[2] != 1) return;
    begin_load("bed", "seabed/plane", number);
    InlineTable bed;
    bed.add("depth", within(-t.limit[2], -1e6, 1e6, t.place, "the depth of the bed"));
    bed.add("stiffness", within(k, 0, 1e12, t.place, "the stiffness of the bed")).add("softness", 0);
    if (is_towed())
      bed.add("friction", within(environment().bed_friction, 0, 10, t.place, "the friction of the bed"));
    line("seabed", bed.text());
  }

  /// Clamps are as stiff as the weaker cable, and act where the first bends.
  void write_clamps() {
    for (std::size_t i = 0; i < gear_.clamps.size(); ++i) {
      const Clamp& clamp = gear_.clamps[i];
      const auto first = static_cast<std::size_t>(clamp.first),
                 second = static_cast<std::size_t>(clamp.second);
      const std::string what = "cables " + std::to_string(first + 1) + " and " + std::to_string(second + 1);
      const double EI = std::min(gear_.cables[first].EI, gear_.cables[second].EI);
      if (!do_meet(first, second) || !(EI > 0)) {
        note(clamp.place, what,
             EI > 0 ? "do not meet: they cannot be clamped" : "do not bend: their clamp does nothing");
        continue;
      }
      begin_part("clamp-" + std::to_string(i + 1), "rope/clamp");
      line("on", quoted_list({cable_name(first), cable_name(second)}));
      const double turn =
          within(180 - clamp.angle, 0, 180, clamp.place, "180 degrees less the angle of the clamp");
      line("clamp", InlineTable()
                        .add("EI", within(EI, 0, 1e12, clamp.place, "the stiffness of the clamp"))
                        .add("angle", turn * std::numbers::pi / 180)
                        .add("curvature", quoted("nodes"))
                        .text());
    }
  }

  bool do_meet(std::size_t first, std::size_t second) const {
    const MeshRegion *a = out_.mesh.find(cable_name(first)), *b = out_.mesh.find(cable_name(second));
    return a && b && first != second && std::any_of(a->nodes.begin(), a->nodes.end(), [&](auto node) {
             return std::find(b->nodes.begin(), b->nodes.end(), node) != b->nodes.end();
           });
  }

  void write_catch() {
    const Environment& e = environment();
    std::vector<std::string> on;
    for (std::size_t p = 0; p < gear_.panels.size(); ++p)
      if (const auto* region = out_.mesh.find(panel_name(p)); region && region->kind == RegionKind::triangles)
        on.push_back(region->name);
    if (e.catch_volume <= e.catch_accuracy || !has_current()) return;
    if (on.empty()) return note({}, "the catch", "there is no netting in triangles for it to press on");
    begin_part("catch", "catch/front", "on all netting behind a plane across the current");
    line("on", quoted_list(on));
    line("catch",
         InlineTable()
             .add("volume", within(e.catch_volume, 0, 1e5, {}, "the volume of the catch"))
             .add("speed", std::abs(e.speed))
             .add("drag_coefficient", within(e.catch_coefficient, 0, 1e3, {}, "the coefficient of the catch"))
             .add("direction", heading())
             .add("front", first_front())
             .text());
    note({}, "the catch",
         "netting behind it has drag here as elsewhere; FEMNET leaves that away, and turns the drag of other "
         "netting towards x");
  }

  /// Direction to which the water flows [rad].
  double flow_angle() const {
    return environment().direction * std::numbers::pi / 180 +
           (environment().speed < 0 ? std::numbers::pi : 0);
  }

  /// A plane that leaves a fifth of the drawing behind it, for a start.
  double first_front() const {
    double low = 1e6, high = -1e6;
    for (const auto& t : file_.triangles)
      for (const auto node : t.nodes) {
        const auto& at = file_.nodes[node].at;
        const double along = at[0] * std::cos(flow_angle()) + at[1] * std::sin(flow_angle());
        low = std::min(low, along), high = std::max(high, along);
      }
    return high - 0.2 * (high - low);
  }

  void write_hold(std::size_t number) {
    if (!has_nodes(number)) return;
    const NodeType& t = gear_.types[number];
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (t.fixed[axis] != 0 || t.symmetry[axis] != 0) axes += kAxis[axis];
    const auto moved = std::find_if(gear_.motions.begin(), gear_.motions.end(),
                                    [&](const auto& m) { return m.type == static_cast<int>(number); });
    const bool is_moved = moves_ && moved != gear_.motions.end();
    if (axes.empty() && !is_moved) return;
    write_hold(type_name(number), is_moved ? "xyz" : axes);
    if (is_moved) write_velocity(*moved, axes == "xyz");
    std::string planes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (t.symmetry[axis] != 0) planes += std::string(planes.empty() ? "" : ", ") + kAxis[axis];
    if (!planes.empty()) body_.comment("on the plane of symmetry across " + planes);
  }

  /// After its times the nodes stand still, and before them if they are held: a step later and earlier.
  void write_velocity(const NodeMotion& m, bool is_held) {
    const double dt = environment().time_step > 0 ? environment().time_step : 0.01;
    const auto with_rests = [&](std::vector<double> all, double before, double after) {
      if (m.times.front() > 0) all.insert(all.begin(), before);
      all.push_back(after);
      return all;
    };
    InlineTable table;
    table.add("t", list_of(with_rests(m.times, m.times.front() - dt, m.times.back() + dt)));
    for (std::size_t axis = 0; axis < 3; ++axis)
      table.add(kAxis[axis], list_of(with_rests(m.velocity[axis], 0, 0)));
    line("velocity", table.text());
    if (!is_held && m.times.front() > 0)
      note(m.place, "keyword speed_type_node2", "its nodes are held here before they are moved, too");
  }

  void write_hold(const std::string& set, const std::string& axes) { body_.hold("*." + set, set, axes); }

  void hold_what_is_loose() {
    const auto loose = find_loose(gear_, file_);
    for (std::size_t i = 0; i < loose.size(); ++i) {
      std::string axes;
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (loose[i].axes[axis]) axes += kAxis[axis];
      write_hold("loose-" + std::to_string(i + 1), axes);
      note({}, "node " + std::to_string(loose[i].node + 1),
           "is held along " + axes +
               ", because nothing in the file holds it there; in balance nothing pulls at the hold");
    }
  }

  /// "cable-3.node-5": a node of the mesh as the first part that has it knows it.
  std::string node_name(int number) const {
    for (const auto& region : out_.mesh.regions) {
      const std::set<std::uint32_t> own(region.nodes.begin(), region.nodes.end());
      const auto at = own.find(static_cast<std::uint32_t>(number - 1));
      if (number > 0 && at != own.end())
        return region.name + ".node-" + std::to_string(std::distance(own.begin(), at));
    }
    return {};
  }

  bool is_held(int node, int axis) const {
    if (node < 1 || static_cast<std::size_t>(node) > file_.nodes.size() || axis < 1 || axis > 3) return false;
    const auto type = static_cast<std::size_t>(file_.nodes[static_cast<std::size_t>(node) - 1].type);
    const auto a = static_cast<std::size_t>(axis) - 1;
    return gear_.types[type].fixed[a] != 0 || gear_.types[type].symmetry[a] != 0;
  }

  void write_results() {
    std::string lines;
    std::set<std::string> used;
    for (const auto& w : gear_.wanted) {
      const std::string entry = result_of(w);
      std::string name = word_of(w.text);
      if (entry.empty()) continue;
      if (name.empty()) name = "result";
      for (int i = 2; !used.insert(name).second; ++i) name = word_of(w.text) + "-" + std::to_string(i);
      lines += name + " = " + entry + "\n";
    }
    if (!lines.empty()) body_.add("\n[results]\n" + lines);
  }

  /// The bars of a cable that nothing hauls, else the first.
  std::string part_of_cable(std::size_t cable) const {
    for (const auto& region : out_.mesh.regions)
      if (region.name == cable_name(cable) || region.name.starts_with(cable_name(cable) + "-bar-"))
        return region.name;
    return {};
  }

  std::string result_of(const Wanted& w) const {
    const auto entry = [](const std::string& of, const std::string& take) {
      return "{ of = " + quoted(of) + ", take = " + quoted(take) + " }";
    };
    const std::string node = node_name(w.first);
    const bool has_axis = w.second >= 1 && w.second <= 3;
    const std::string axis = has_axis ? kAxis[static_cast<std::size_t>(w.second) - 1] : "";
    if (w.kind == Wanted::Kind::position && !node.empty() && has_axis) return entry(node, axis);
    if (w.kind == Wanted::Kind::force && !node.empty() && is_held(w.first, w.second))
      return entry(node, "reaction " + axis);
    const std::string cable = w.first > 0 ? part_of_cable(static_cast<std::size_t>(w.first) - 1) : "";
    return w.kind == Wanted::Kind::tension && !cable.empty() ? entry(cable, "max tension") : std::string();
  }

  void note_motion() {
    const std::string cure = "of motion, which --motion writes; the scene is at rest";
    if (environment().wave_height != 0) note(environment().waves, "waves", "are " + cure);
    for (const auto& f : gear_.of_motion) note(f.place, f.what, "is of motion; the scene is at rest");
    for (const auto& d : gear_.drums) note(d.place, "keyword hauling_cable4", "is " + cure);
    for (const auto& m : gear_.motions) note(m.place, "keyword speed_type_node2", "is " + cure);
  }

  void note_differences_of_motion() {
    out_.findings.insert(out_.findings.end(), gear_.of_motion.begin(), gear_.of_motion.end());
    note_waves();
    note({}, "the motion",
         "added mass of ropes is across them alone, FEMNET's along them, too; its steps damp what is fast, "
         "these hardly");
    const Environment& e = environment();
    if (e.record_begin > 0) note({}, "the record", "begins at 0 here");
    for (std::size_t t = 0; t < gear_.types.size(); ++t)
      if (has_nodes(t)) note_masses(t);
  }

  void note_waves() {
    const Environment& e = environment();
    if (e.wave_height == 0) return;
    if (const auto fault = fault_of_waves(e); !fault.empty()) return leave_out(e.waves, "waves", fault);
    note(e.waves, "waves",
         "grow over one period as in FEMNET, but smoothly; in deep water (more than half a wave length) they "
         "are those of this depth");
    if (e.wave_model != 1)
      note(e.waves, "waves",
           "are linear ones here; of a higher order their crests would rise by " +
               spell_number(std::round(1e4 * rise_of_second_order(e)) / 1e4) + " m more");
    if (is_towed()) note(e.waves, "waves", "are carried by the water that passes, and FEMNET's are not");
  }

  void note_masses(std::size_t number) {
    const NodeType& t = gear_.types[number];
    const std::string what = "type " + std::to_string(number + 1);
    const auto differ = [](const Triple& m) { return m[0] != m[2] || m[1] != m[2]; };
    if (differ(t.mass) || !(t.mass[2] >= 0 && t.mass[2] <= kMostMass))
      note(t.place, what, "its inertia is that of the mass along z, if that is above zero");
    if (differ(t.added_mass)) note(t.place, what, "its added mass is the mean of all axes");
    if (t.sense[2] == 1 && environment().bed_friction != 0 && !is_towed())
      leave_out(t.place, what,
                "friction of a bed that stands, on nodes that slide over it, is not carried over");
  }

  static constexpr const char* kAxis[] = {"x", "y", "z"};

  const GearFile& gear_;
  const MeshFile& file_;
  const Names& names_;
  Diagnostics& diagnostics_;
  bool moves_;
  std::vector<HauledBar> hauled_;
  Imported out_;
  SceneText body_;
};

}  // namespace

Imported import_gear(const GearFile& gear, const MeshFile& mesh, const Names& names, Diagnostics& diagnostics,
                     Sought sought) {
  return SceneWriter(gear, mesh, names, diagnostics, sought).write();
}

}  // namespace netloft::io::femnet
