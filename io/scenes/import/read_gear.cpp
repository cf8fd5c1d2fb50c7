// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the first part of a .don: values after colons, in a fixed order.
#include "io/scenes/import/don_scanner.hpp"
#include "io/scenes/import/femnet_gear.hpp"
#include "io/scenes/import/keywords.hpp"

#include <algorithm>
#include <string>

namespace netloft::scenes::femnet {

namespace {

/// Rounds to single precision, in which FEMNET stores the numbers of panels.
double in_single(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Reads one gear file. The member functions are the steps, in the order of execution.
class GearReader {
 public:
  GearReader(const std::string& text, int file, formats::Diagnostics& diagnostics)
      : in_(text, file, diagnostics), diagnostics_(diagnostics) {}

  GearFile read() {
    const bool has_winches = begins_with_version();
    const int plane = in_.integer("the axis normal to the drawing");
    if (!in_.has_failed() && (plane < 1 || plane > 3))
      in_.fail(in_.place(),
               "the axis normal to the drawing is " + std::to_string(plane) + "; 1, 2 or 3 is expected");
    gear_.plane = plane;
    repeat("the number of panels", [&] { read_panel(); });
    refuse_any("hexagonal panels");
    repeat("the number of cables", [&] { read_cable(); });
    refuse_any("sliding cables");
    if (has_winches) refuse_any("winches");
    repeat("the number of links", [&] { read_link(); });
    read_order();
    repeat("the number of types of nodes", [&] { read_type(); });
    read_numbers();
    read_environment();
    read_wanted();
    if (!in_.has_failed()) read_keywords(in_, gear_, diagnostics_);
    return std::move(gear_);
  }

 private:
  bool begins_with_version() {
    const auto begin = in_.mark();
    if (in_.word() == "version_2") return true;
    in_.go_back(begin);
    return false;
  }

  template <class Read>
  void repeat(const char* what, Read&& read) {
    for (int left = in_.count(what); left > 0 && !in_.has_failed(); --left) read();
  }

  void refuse_any(const std::string& what) {
    const std::string number = "the number of " + what;
    if (in_.count(number.c_str()) > 0) in_.fail(in_.place(), "gears with " + what + " cannot be imported");
  }

  Triple read_triple(const char* what) {
    Triple t{in_.real(what), 0, 0};
    for (const std::size_t axis : {1u, 2u}) {
      const auto value = in_.try_real();
      if (!value && !in_.has_failed())
        diagnostics_.warning(
            in_.place(), std::string(what) + ": three numbers are expected; the missing one is taken as 0");
      t[axis] = value.value_or(0);
    }
    return t;
  }

  Triple read_place(const char* what) {
    Triple at{};
    for (double& x : at) x = in_.next_real(what);
    return at;
  }

  void read_panel() {
    in_.skip_colon("a panel");
    Panel p;
    p.place = in_.place();
    const int corners = in_.count("the number of corners");
    if (corners < 3)
      in_.fail(in_.place(), "a panel with " + std::to_string(corners) + " corners; it needs at least 3");
    in_.skip_worded_line();
    for (int i = 0; i < corners && !in_.has_failed(); ++i) p.corners.push_back(read_corner());
    if (in_.try_real()) diagnostics_.warning(in_.place(), "there are more rows of corners than corners");
    p.EA = in_single(in_.real("the stiffness of twines"));
    p.EA_compression = in_single(in_.real("the stiffness of twines in compression"));
    p.opening = in_single(in_.real("the opening stiffness of meshes"));
    p.side = in_single(in_.real("the length of a mesh side"));
    p.density = in_single(in_.real("the density of twines"));
    p.diameter = in_single(in_.real("the diameter of twines"));
    p.knot = in_single(in_.real("the size of knots"));
    p.cd = in_single(in_.real("the normal drag coefficient of twines"));
    p.friction = in_single(in_.real("the tangential drag coefficient of twines"));
    p.step = in_.real("the meshing step");
    p.inner_type = in_.integer("the type of inner nodes");
    p.mesh_type = in_.integer("the kind of mesh");
    gear_.panels.push_back(std::move(p));
  }

  Corner read_corner() {
    in_.next_real("the number of a corner");
    Corner c;
    c.at = read_place("a coordinate of a corner");
    c.U = in_.next_real("U of a corner");
    c.V = in_.next_real("V of a corner");
    c.type = in_.next_integer("the type of a corner");
    c.side_type = in_.next_integer("the type of the nodes that follow a corner");
    return c;
  }

  void read_cable() {
    in_.skip_colon("a cable");
    in_.skip_colon("the ends of a cable");
    Cable c;
    c.place = in_.place();
    for (auto& end : c.ends) {
      in_.next_real("the number of an end");
      end.at = read_place("a coordinate of an end");
      end.type = in_.next_integer("the type of an end");
    }
    c.EA = in_.real("the stiffness of a cable");
    c.EA_compression = in_.real("the stiffness of a cable in compression");
    c.length = in_.real("the length of a cable");
    c.density = in_.real("the density of a cable");
    c.diameter = in_.real("the diameter of a cable");
    c.cd = in_.real("the normal drag coefficient of a cable");
    c.friction = in_.real("the tangential drag coefficient of a cable");
    c.bars = in_.integer("the number of bars of a cable");
    c.inner_type = in_.integer("the type of the inner nodes of a cable");
    gear_.cables.push_back(std::move(c));
  }

  void read_link() {
    std::vector<LinkPoint> link;
    for (int left = in_.count("the number of points of a link"); left > 0 && !in_.has_failed(); --left) {
      const auto word = in_.word_before_colon();
      LinkPoint point;
      point.is_panel = word && word->starts_with("pa");
      if (!word) in_.skip_colon("a point of a link");
      point.place = in_.place();
      point.object = in_.next_integer("the number of a panel or cable") - 1;
      point.corner = in_.integer("the number of a corner or end") - 1;
      link.push_back(point);
    }
    gear_.links.push_back(std::move(link));
  }

  /// Reads the meshing order. The number of entries that the file states is not always correct. Therefore
  /// entries are read as long as they look like entries.
  void read_order() {
    in_.skip_colon("the meshing order");
    if (in_.try_word('a')) return;
    while (!in_.has_failed()) {
      const auto begin = in_.mark();
      const auto word = in_.word_before_colon();
      const bool is_entry =
          word && (word->starts_with("pa") || word->starts_with("el") || word->starts_with("he") ||
                   word->starts_with("co") || word->starts_with("wi"));
      const auto number = is_entry ? in_.try_real(true) : std::nullopt;
      if (!number) {
        in_.go_back(begin);
        break;
      }
      gear_.order.push_back(
          {word->starts_with("pa"), static_cast<int>(std::clamp(*number, -1e6, 1e6)) - 1, 0, in_.place()});
    }
    const std::size_t expected = gear_.panels.size() + gear_.cables.size();
    if (gear_.order.size() != expected && !in_.has_failed())
      diagnostics_.warning(in_.place(), "the meshing order has " + std::to_string(gear_.order.size()) +
                                            " entries for " + std::to_string(expected) +
                                            " panels and cables");
  }

  void read_type() {
    in_.skip_colon("a type of nodes");
    NodeType t;
    t.place = in_.place();
    t.mass = read_triple("the mass");
    t.added_mass = read_triple("the added mass");
    t.box = read_triple("the lengths of the box");
    t.drag = read_triple("the drag coefficients of the box");
    t.force = read_triple("the force");
    t.fixed = read_triple("what is fixed");
    t.limit = read_triple("the limits");
    t.sense = read_triple("the sense of the limits");
    t.symmetry = read_triple("the planes of symmetry");
    gear_.types.push_back(t);
  }

  void read_numbers() {
    in_.real("the divisor");
    gear_.environment.tolerance = in_.real("the convergence threshold");
    in_.real("the displacement limit");
    in_.real("the number of iterations");
    const auto time = [&](const char* what) { return in_.skip_colon(what), in_.real(what); };
    Environment& e = gear_.environment;
    e.time_step = time("the time step");
    e.record_step = time("the time step of the record");
    e.record_begin = time("the beginning of the record");
    e.end = time("the end of the record");
  }

  void read_environment() {
    Environment& e = gear_.environment;
    e.direction = in_.real("the direction of the current");
    e.speed = in_.real("the speed of the current");
    e.wave_period = in_.real("the period of waves");
    e.waves = in_.place();
    e.wave_height = in_.real("the height of waves");
    e.wave_direction = in_.real("the direction of waves");
    e.depth = in_.real("the depth of the water");
    e.catch_volume = in_.real("the volume of the catch");
    e.catch_accuracy = in_.real("the accuracy of the catch");
    e.catch_coefficient = in_.real("the pressure coefficient of the catch");
    e.bed_friction = in_.real("the friction of the bed");
    e.bed_stiffness = in_.real("the stiffness of the bed");
  }

  void read_wanted() {
    using Kind = Wanted::Kind;
    const auto read = [&](Kind kind, bool keep) {
      in_.skip_colon("a requested number");
      Wanted w{kind, in_.text_in_hashes("a text between #"), 0, 0};
      w.first = in_.integer("a node, or a cable");
      w.second = in_.integer("a node, or an axis");
      in_.integer("a number of decimals");
      if (keep) gear_.wanted.push_back(std::move(w));
    };
    repeat("the number of distances", [&] { read(Kind::distance, true); });
    repeat("the number of forces", [&] { read(Kind::force, true); });
    repeat("the number of tensions", [&] { read(Kind::tension, true); });
    repeat("the number of tensions of sliding cables", [&] { read(Kind::tension, false); });
    repeat("the number of positions", [&] { read(Kind::position, true); });
    for (int flag = 0; flag < 6; ++flag) in_.integer("a choice of what is displayed");
  }

  DonScanner in_;
  formats::Diagnostics& diagnostics_;
  GearFile gear_;
};

}  // namespace

GearFile read_gear(const std::string& text, int file, formats::Diagnostics& diagnostics) {
  return GearReader(text, file, diagnostics).read();
}

}  // namespace netloft::scenes::femnet
