// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "tests/fuzz/choices.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace netloft::fuzz {

/// Draws a net plan at random, as text: up to eight small panels of all shapes, sewn to each other and to
/// themselves along any of their edges, as a whole or in pieces, with ropes along any edges. Counts and
/// take-ups are drawn so that most seams fit, because the mesher is reached only by plans that pass the
/// check.
class TopologyDrawer {
 public:
  explicit TopologyDrawer(Choices& choices) : choices_(choices) {}

  std::string draw() {
    const int panels = choices_.in(1, 8);
    for (int k = 0; k < panels; ++k) draw_panel("p" + std::to_string(k));
    measure();
    for (std::size_t p = 1; p < panels_.size(); ++p) sew_to_earlier(p);
    for (int k = choices_.in(0, 2); k > 0; --k) sew_any();
    for (int k = choices_.in(0, 2); k > 0; --k) sew_to_itself();
    for (int k = choices_.in(0, 3); k > 0; --k) hang();
    if (rarely(4)) draw_tie();
    if (rarely(3)) draw_floats();
    if (rarely(3)) draw_catch();
    return text_of_panels(true) + rest_points_ + rest_;
  }

 private:
  /// An edge or a part of it, which is sewn as a whole.
  struct Edge {
    std::string name;  // "p0.fore"
    std::size_t panel = 0;
    bool is_sewn = false, is_hung = false;
    bool is_side = false, is_across_middle = false;
    int times = 0;
    double meshes = 0, stretched = 0, mesh = 0;
  };
  struct DrawnPanel {
    std::string name, stands, text;
    std::vector<std::string> edges;
  };

  bool rarely(int of) { return choices_.in(0, of - 1) == of - 1; }

  static constexpr const char* kNetting[] = {"mesh = \"100 mm\"\n", "mesh = \"50 mm\"\n",
                                             "mesh = \"100 mm\"\norientation = \"square\"\n",
                                             "mesh = \"100 mm\"\norientation = \"t90\"\n"};

  void draw_panel(const std::string& name) {
    DrawnPanel panel{name, choices_.pick({"middle", "pair", "middle", "pair", "alone"}), "", {}};
    panel.text = choices_.pick(kNetting);
    panel.text += "twine = { diameter = \"1 mm\", EA = \"3 kN\", density = 960 }\n";
    const int shape = choices_.in(0, 9);
    if (shape == 9)
      draw_round(panel);
    else if (shape == 8)
      draw_corners(panel);
    else
      draw_counts(panel);
    panel.text += "stands = \"" + panel.stands + "\"\n";
    panels_.push_back(std::move(panel));
  }

  void add_edge(DrawnPanel& panel, const std::string& edge) {
    panel.edges.push_back(panel.name + "." + edge);
  }

  void draw_round(DrawnPanel& panel) {
    panel.stands = "middle";
    panel.text += fmt::format("round = {}\ndepth = {}\n", 2 * choices_.in(3, 12), choices_.in(3, 20));
    add_edge(panel, "fore");
    add_edge(panel, "aft");
  }

  void draw_corners(DrawnPanel& panel) {
    const bool is_middle = panel.stands == "middle";
    const int a = choices_.in(4, 16), b = choices_.in(4, 16);
    const std::string inner = is_middle ? "" : fmt::format(", [{}, {}]", choices_.in(-4, 1), b / 2);
    panel.text += fmt::format("corners = [[0, 0], [{}, 0], [{}, {}], [{}, {}], [0, {}]{}]\n", a,
                              a + choices_.in(-2, 4), b / 2, choices_.in(1, 16), b, b, inner);
    for (const char* edge : {"fore", "aft"}) add_edge(panel, edge);
    const bool is_whole = choices_.flag();
    const char* outer = is_middle ? "sides" : "outer";
    if (is_whole) return add_edge(panel, outer);
    for (const char* part : {"-1", "-2"}) add_edge(panel, outer + std::string(part));
    if (!is_middle) add_edge(panel, "inner");
  }

  struct Cutting {
    const char* text;
    double rate;  // meshes across per mesh deep
  };

  /// Draws one side of a panel, made of one or two cuts; returns the number of meshes that they add to the
  /// panel's width.
  double draw_side(DrawnPanel& panel, const char* key, int depth, double room, bool must_widen = false) {
    static constexpr Cutting kCuttings[] = {
        {"AN", 0}, {"AN", 0}, {"1N2B", 0.5}, {"AB", 1}, {"1N4B", 2.0 / 3}};
    const bool is_in_two = depth >= 6 && !must_widen && rarely(3);
    const Cutting cut = must_widen ? kCuttings[3] : choices_.pick(kCuttings);
    const double reach = cut.rate * (is_in_two ? depth - depth / 2 : depth);
    const bool goes_in = reach > 0 && reach <= room && choices_.flag();
    const std::string written = cut.text + std::string(reach == 0 ? "" : goes_in ? " in" : " out");
    if (!is_in_two) {
      panel.text += fmt::format("{} = \"{}\"\n", key, written);
      add_edge(panel, key);
      return goes_in ? -reach : reach;
    }
    panel.text += fmt::format(
        "{} = [{{ name = \"{}-a\", cut = \"AN\", depth = {} }}, {{ name = \"{}-b\", cut = \"{}\" }}]\n", key,
        key, depth / 2, key, written);
    add_pieces(panel, key, {key + std::string("-a"), key + std::string("-b")});
    return goes_in ? -reach : reach;
  }

  /// Adds the parts of an edge, either each alone or all together.
  void add_pieces(DrawnPanel& panel, const std::string& whole, const std::vector<std::string>& parts) {
    if (choices_.flag()) return add_edge(panel, whole);
    for (const auto& part : parts) add_edge(panel, part);
  }

  void draw_counts(DrawnPanel& panel) {
    const bool is_middle = panel.stands == "middle";
    const double sides = is_middle ? 2 : 1;
    const int depth = choices_.in(2, 20);
    const double fore = rarely(8) ? 0 : 2 * choices_.in(1, 12);
    panel.text += fmt::format("depth = {}\n", depth);
    double aft = fore + sides * draw_side(panel, is_middle ? "sides" : "outer", depth, fore / 4, fore == 0);
    if (!is_middle) aft += draw_side(panel, "inner", depth, fore / 4);
    draw_count(panel, "fore", fore);
    if (aft >= 2 && rarely(2))
      draw_count(panel, "aft", aft);
    else if (aft > 0.5)
      add_edge(panel, "aft");
  }

  void draw_count(DrawnPanel& panel, const std::string& key, double meshes) {
    if (meshes >= 4 && rarely(3)) {
      const double part = meshes / 4, first = panel.stands == "middle" ? meshes - 2 * part : meshes - part;
      panel.text +=
          fmt::format("{0} = [{{ name = \"{0}-a\", meshes = {1} }}, {{ name = \"{0}-b\", meshes = {2} }}]\n",
                      key, first, part);
      return add_pieces(panel, key, {key + "-a", key + "-b"});
    }
    panel.text += fmt::format("{} = {}\n", key, meshes);
    if (meshes > 0) add_edge(panel, key);
  }

  std::string text_of_panels(bool with_open) const {
    std::string text;
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      text += "[panels." + panels_[p].name + "]\n" + panels_[p].text;
      std::string open;
      for (const Edge& edge : edges_)
        if (with_open && edge.panel == p && !edge.is_sewn && !edge.is_hung)
          open +=
              fmt::format("{}\"{}\"", open.empty() ? "" : ", ", edge.name.substr(edge.name.find('.') + 1));
      if (!open.empty()) text += "open = [" + open + "]\n";
    }
    return text;
  }

  /// Lists the edges with their numbers of meshes. Names that are no edge of their panel are left out.
  void measure() {
    formats::Diagnostics silent;
    const gears::NetPlan plan = gears::read_plan_text(text_of_panels(false), "panels.toml", {}, silent);
    for (std::size_t p = 0; p < panels_.size(); ++p)
      for (const auto& name : panels_[p].edges) {
        const gears::EdgeSet set = gears::find_edge(plan, name, {}, "", silent);
        if (!set.edges.empty() && set.stretched() > 0)
          edges_.push_back({name, p, false, false, set.is_side(), set.is_across_middle(), set.times(),
                            set.meshes(), set.stretched(), set.panel->mesh});
      }
  }

  template <class Wanted>
  Edge* pick_edge(const Wanted& is_wanted) {
    std::vector<Edge*> found;
    for (Edge& edge : edges_)
      if (is_wanted(edge)) found.push_back(&edge);
    return found.empty() ? nullptr : found[choices_.in<std::size_t>(0, found.size() - 1)];
  }

  /// Picks an edge to sew to `edge`, usually one that exists as many times as `edge` (once or twice), because
  /// such edges fit most often.
  Edge* pick_partner(const Edge& edge, std::size_t before) {
    const bool any = rarely(5);
    Edge* like = pick_edge([&](const Edge& e) {
      return !e.is_sewn && e.panel < before && &e != &edge && (any || e.times == edge.times);
    });
    return like ? like
                : pick_edge([&](const Edge& e) { return !e.is_sewn && e.panel < before && &e != &edge; });
  }

  using EdgeRow = std::vector<Edge*>;

  static std::string names_of(const EdgeRow& row) {
    std::string names;
    for (const Edge* edge : row) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", edge->name);
    return row.size() == 1 ? names : "[" + names + "]";
  }

  static double size_of(const EdgeRow& row, bool is_counted) {
    double sum = 0;
    for (const Edge* edge : row) sum += edge->times * (is_counted ? edge->meshes : edge->stretched);
    return sum;
  }

  static bool is_counted(const EdgeRow& a, const EdgeRow& b) {
    bool is_one_mesh = true;
    for (const auto* row : {&a, &b})
      for (const Edge* edge : *row) is_one_mesh = is_one_mesh && edge->mesh == a[0]->mesh;
    return a[0]->is_side == b[0]->is_side && (!a[0]->is_side || is_one_mesh);
  }

  void sew(const EdgeRow& a, const EdgeRow& b) {
    const bool counted = is_counted(a, b);
    const double ratio = size_of(b, counted) / size_of(a, counted);
    rest_ += fmt::format("[[join]]\nedges = [{}, {}]\n", names_of(a), names_of(b));
    if (std::abs(ratio - 1) > 0.02 && ratio > 0.05 && ratio < 20 && !rarely(200))
      rest_ += fmt::format("take_up = {:.4g}\n", ratio);
    if (a[0]->is_side && b[0]->is_side && rarely(12)) rest_ += "selvedge = 1\n";
    for (const auto* row : {&a, &b})
      for (Edge* edge : *row) edge->is_sewn = true;
  }

  /// Sews an edge of the panel to an edge of an earlier panel, or sometimes to a row of two edges.
  void sew_to_earlier(std::size_t panel) {
    Edge* own = pick_edge([&](const Edge& e) { return !e.is_sewn && e.panel == panel; });
    Edge* other = own ? pick_partner(*own, panel) : nullptr;
    if (!other) return;
    EdgeRow a{other}, b{own};
    own->is_sewn = other->is_sewn = true;
    if (rarely(6)) {
      Edge* more = pick_edge(
          [&](const Edge& e) { return !e.is_sewn && e.panel <= panel && e.is_side == other->is_side; });
      if (more) a.push_back(more);
    }
    sew(a, b);
  }

  void sew_any() {
    Edge* one = pick_edge([](const Edge& e) { return !e.is_sewn; });
    if (!one) return;
    one->is_sewn = true;
    if (Edge* other = pick_partner(*one, panels_.size())) return sew({one}, {other});
    one->is_sewn = false;
  }

  void sew_to_itself() {
    Edge* edge = pick_edge([](const Edge& e) { return !e.is_sewn && (e.times == 2 || e.is_across_middle); });
    if (!edge) return;
    edge->is_sewn = true;
    rest_ += fmt::format("[[join]]\nedges = [\"{0}\", \"{0}\"]\n", edge->name);
  }

  /// Adds a rope and hangs up to three edges on it. The rope may be tied to corners, points or other ropes.
  void hang() {
    const std::string name = "r" + std::to_string(ropes_.size());
    std::string hangings;
    double length = 0;
    bool are_all_twice = true, are_all_once = true;
    EdgeRow row;
    for (int k = choices_.in(1, 3); k > 0; --k)
      if (Edge* edge = pick_edge([](const Edge& e) { return !e.is_hung; })) {
        edge->is_hung = true;
        row.push_back(edge);
        (edge->times == 2 ? are_all_once : are_all_twice) = false;
      }
    if (row.empty()) return;
    const std::string stands = are_all_twice && choices_.flag() ? "pair"
                               : are_all_once && rarely(3)      ? "alone"
                                                                : "middle";
    const double ratio = choices_.pick({0.5, 0.8, 1.0, 0.3});
    for (Edge* edge : row) {
      length += ratio * edge->stretched * (stands == "middle" ? edge->times : 1);
      hangings += fmt::format("[[hang]]\nedge = \"{}\"\non = \"{}\"\nratio = {}\n", edge->name, name, ratio);
    }
    length *= choices_.pick({1.0, 1.5, 3.0});
    rest_ += fmt::format(
        "[ropes.{}]\nstands = \"{}\"\nrope = {{ diameter = \"2 mm\", EA = \"100 kN\", density = 1000 }}\n"
        "length = {:.6g}\n",
        name, stands, std::max(length, 0.01));
    if (rarely(3))
      rest_ +=
          fmt::format("between = [\"{}\", \"{}\"]\n", stands == "middle" ? middle_end() : any_end(stands),
                      any_end(stands == "middle" ? "pair" : stands));
    rest_ += hangings;
    ropes_.push_back({name, stands});
  }

  /// A point in the middle, which exists only once, for the end of a rope that stands in the middle.
  std::string middle_end() {
    for (const auto& panel : panels_)
      if (panel.stands == "middle" && choices_.flag())
        return panel.name + (choices_.flag() ? ".fore-inner" : ".aft-inner");
    return add_point("middle");
  }

  /// A point for the end of a rope with this value of `stands`.
  std::string any_end(const std::string& stands) {
    static constexpr const char* kCorners[] = {".fore-outer", ".aft-outer", ".fore-inner", ".aft-inner"};
    const auto& panel = panels_[choices_.in<std::size_t>(0, panels_.size() - 1)];
    if (choices_.flag() && (stands == "pair") == (panel.stands != "alone"))
      return panel.name + kCorners[choices_.in(0, panel.stands == "middle" ? 1 : 3)];
    if (!ropes_.empty() && choices_.flag()) {
      const auto& rope = ropes_[choices_.in<std::size_t>(0, ropes_.size() - 1)];
      return rope.name + (choices_.flag() ? ".end" : ".middle");
    }
    return add_point(stands);
  }

  std::string add_point(const std::string& stands) {
    const std::string name = "q" + std::to_string(points_++);
    rest_points_ += "[points." + name + "]\nstands = \"" + stands + "\"\n";
    return name;
  }

  /// Adds a rope without netting between two points.
  void draw_tie() {
    const std::string stands = choices_.pick({"pair", "pair", "middle"}),
                      name = "t" + std::to_string(ropes_.size());
    const std::string from = stands == "middle" ? middle_end() : any_end(stands), to = any_end("pair");
    rest_ += fmt::format(
        "[ropes.{}]\nstands = \"{}\"\nrope = {{ diameter = \"2 mm\", EA = \"100 kN\", density = 1000 }}\n"
        "length = {}\nbetween = [\"{}\", \"{}\"]\n",
        name, stands, choices_.in(1, 20), from, to);
    ropes_.push_back({name, stands});
  }

  void draw_floats() {
    std::string where;
    if (!ropes_.empty() && choices_.flag())
      where = "along " + ropes_.front().name;
    else if (Edge* edge = pick_edge([](const Edge&) { return true; }))
      where = "along " + edge->name;
    if (!where.empty()) rest_ += "[floats.f]\nfloat = { buoyancy = \"5 N\" }\nspread = \"6 " + where + "\"\n";
  }

  void draw_catch() {
    rest_ += "[parts.catch]\ntype = \"catch/pressure\"\non = \"" +
             panels_[choices_.in<std::size_t>(0, panels_.size() - 1)].name +
             "\"\ncatch = { pressure = \"100 Pa\", meshes = 3 }\n";
  }

  struct DrawnRope {
    std::string name, stands;
  };

  Choices& choices_;
  std::vector<DrawnPanel> panels_;
  std::vector<Edge> edges_;
  std::vector<DrawnRope> ropes_;
  int points_ = 0;
  std::string rest_, rest_points_;
};

}  // namespace netloft::fuzz
