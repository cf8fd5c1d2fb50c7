// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/drawing/drawing.hpp"

#include "io/formats/work/long_work.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/gears/drawing/lettering.hpp"
#include "io/gears/drawing/plan_layout.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace netloft::gears {

namespace {

constexpr double kWidth = 1100, kTallest = 1500, kMargin = 60, kLeftMargin = 130, kLineHeight = 16;
constexpr double kSmall = Lettering::kSmall, kNormal = Lettering::kNormal, kTitle = 16;
constexpr const char *kInk = "#222", *kPale = "#777", *kRope = "#0b5fa5";

/// Converts metres on the net to positions on the sheet.
struct Scale {
  double per_metre = 1, left = 0, top = 0;
  formats::PicturePoint operator()(PanelPoint p) const {
    return {kLeftMargin + per_metre * (p.x - left), kMargin + kLineHeight + per_metre * (p.y - top)};
  }
};

struct Box {
  double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
  void take(PanelPoint p) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
};

Box box_of(const std::vector<PlacedPanel>& panels) {
  Box box;
  for (const auto& placed : panels)
    for (const auto& corner : placed.outline.corners()) box.take(placed.on_sheet(corner));
  if (panels.empty()) box.take({0, 0});
  return box;
}

Scale scale_for(const Box& box) {
  const double across = std::max(1e-9, box.right - box.left), down = std::max(1e-9, box.bottom - box.top);
  return {std::min((kWidth - kLeftMargin - kMargin) / across, kTallest / down), box.left, box.top};
}

std::string cutting_of(const Panel& panel, const std::string& edge) {
  for (const auto* side : {&panel.outer, &panel.inner})
    for (const auto& cut : *side)
      if (cut.name == edge) return cut.written;
  return "";
}

std::string netting_of(const Panel& panel) {
  std::string text = fmt::format("{:.4g} mm", 1e3 * panel.mesh);
  if (panel.orientation != "diamond") text += " " + panel.orientation;
  if (panel.angle != 0) text += fmt::format(" turned {:.4g}°", formats::kDegreesPerRadian * panel.angle);
  return text;
}

std::string twine_of(const Panel& panel) {
  const std::string name =
      panel.twine_name.empty() ? fmt::format("{:.3g} mm", 1e3 * panel.twine_diameter) : panel.twine_name;
  return panel.twines > 1 ? fmt::format("{} x {}", panel.twines, name) : name;
}

std::string depth_of(const Panel& panel) {
  const std::string times = panel.pieces > 1 ? fmt::format("{} x ", panel.pieces) : "";
  return times + in_meshes(panel.depth / panel.pieces) + (panel.is_round ? " M deep, a tube" : " M deep");
}

formats::PicturePoint halfway(formats::PicturePoint a, formats::PicturePoint b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// Draws a plan; the member functions are steps in the order of execution.
class Draughtsman {
 public:
  Draughtsman(const NetPlan& plan, formats::LineDrawing& picture)
      : plan_(plan),
        panels_(lay_out(plan)),
        box_(box_of(panels_)),
        scale_(scale_for(box_)),
        picture_(picture),
        lettering_(picture, kWidth) {}

  formats::DrawingSize draw() {
    draw_title();
    for (const auto& panel : panels_) draw_border(panel);
    for (const auto& panel : panels_) draw_labels(panel);
    for (const auto& panel : panels_)
      if (panel.is_mirrored == (panel.panel->stands == Standing::pair)) draw_words(panel);
    line_ = scale_({box_.left, box_.bottom}).y + 3 * kLineHeight;
    draw_scale();
    list_ropes();
    list_pieces();
    list_joins();
    return {kWidth, line_ + kMargin / 2};
  }

  formats::DrawingSize draw(const Gear& gear, const GearMesh& mesh) {
    draw_title();
    for (std::size_t p = 0; p < gear.panels.size(); ++p) draw_triangles(gear.panels[p], mesh.panels[p]);
    for (const auto& panel : panels_) draw_border(panel);
    line_ = scale_({box_.left, box_.bottom}).y + 3 * kLineHeight;
    draw_scale();
    say_quality(mesh.nodes, quality_of(gear, mesh));
    return {kWidth, line_ + kMargin / 2};
  }

 private:
  void draw_title() {
    picture_.text({kMargin, kMargin / 2}, plan_.title.empty() ? "Net plan" : plan_.title, kTitle, kInk,
                  formats::Anchor::start);
  }

  void draw_triangles(const GearPanel& panel, const PanelMesh& mesh) {
    const auto placed = std::find_if(panels_.begin(), panels_.end(), [&](const PlacedPanel& one) {
      return one.panel == panel.panel && one.is_mirrored == panel.is_mirrored;
    });
    if (placed == panels_.end()) return;
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        sides.insert(std::minmax(mesh.triangles[t + k], mesh.triangles[t + (k + 1) % 3]));
    for (const auto& [a, b] : sides)
      picture_.line(place(*placed, {mesh.meshes[a][0], mesh.meshes[a][1]}),
                    place(*placed, {mesh.meshes[b][0], mesh.meshes[b][1]}), kPale, 0.4);
  }

  void say_quality(std::size_t nodes, const MeshQuality& quality) {
    say(fmt::format("{} nodes, {} triangles, angles {:.0f} to {:.0f}° where meshes are opened by one half",
                    nodes, quality.triangles, formats::kDegreesPerRadian * quality.least_angle,
                    formats::kDegreesPerRadian * quality.greatest_angle),
        kInk);
  }

  void draw_border(const PlacedPanel& placed) {
    for (const auto& edge : placed.outline.edges) {
      if (edge.kind == EdgeKind::middle) continue;
      const Hanging* hung = hanging_of(placed, edge);
      picture_.line(place(placed, edge.from), place(placed, edge.to), hung ? kRope : kInk, hung ? 3.0 : 1.2);
    }
  }

  const Hanging* hanging_of(const PlacedPanel& placed, const OutlineEdge& edge) const {
    formats::Diagnostics silent;
    for (const auto& h : plan_.hangings) {
      const EdgeSet set = find_edge(plan_, h.edge, {}, "", silent);
      if (set.panel != placed.panel || is_selvedge(h)) continue;
      for (const auto& one : set.edges)
        if (one.name == edge.name && one.kind == edge.kind) return &h;
    }
    return nullptr;
  }

  bool is_selvedge(const Hanging& h) const {
    const Rope* rope = plan_.find_rope(h.rope);
    return rope && rope->is_selvedge;
  }

  formats::PicturePoint place(const PlacedPanel& placed, PanelPoint p) const {
    return scale_(placed.on_sheet(p));
  }

  /// Writes the labels of the netting on the port half and the labels of the cuttings on the starboard half.
  void draw_labels(const PlacedPanel& placed) {
    if (placed.is_mirrored) return;
    for (const auto& edge : placed.outline.edges) draw_edge_label(placed, edge);
    draw_counts(placed);
  }

  /// Puts a label beside the middle of an edge. If the panel becomes wider towards aft, the label is above
  /// the middle, because the edge then runs below it.
  void draw_edge_label(const PlacedPanel& placed, const OutlineEdge& edge) {
    if (edge.kind != EdgeKind::outer && edge.kind != EdgeKind::inner) return;
    const formats::PicturePoint from = place(placed, edge.from), to = place(placed, edge.to),
                                at = halfway(from, to);
    const bool is_outer = edge.kind == EdgeKind::outer, falls_right = (to.x - from.x) * (to.y - from.y) > 0;
    const double aside = is_outer ? 7 : -7, y = falls_right == is_outer ? at.y - 12 : at.y;
    const formats::Anchor anchor = is_outer ? formats::Anchor::start : formats::Anchor::end;
    const std::string cutting = cutting_of(*placed.panel, edge.name);
    if (!cutting.empty()) lettering_.write({at.x + aside, y}, cutting, kSmall, kInk, anchor);
    lettering_.write({at.x + aside, y + 11}, in_meshes(edge.meshes) + " M", kSmall, kPale, anchor);
  }

  void draw_counts(const PlacedPanel& placed) {
    draw_counts_of(placed, placed.panel->fore, EdgeKind::fore, 12);
    draw_counts_of(placed, placed.panel->aft, EdgeKind::aft, -5);
  }

  void draw_counts_of(const PlacedPanel& placed, const std::vector<MeshCount>& counts, EdgeKind kind,
                      double below) {
    for (const auto& edge : placed.outline.edges) {
      if (edge.kind != kind) continue;
      formats::PicturePoint at = halfway(place(placed, edge.from), place(placed, edge.to));
      const bool in_middle = placed.panel->stands == Standing::middle && edge.name == counts.front().name;
      if (in_middle) at.x = place(placed, {0, 0}).x;
      const bool is_short = std::abs(place(placed, edge.to).x - place(placed, edge.from).x) < 12;
      lettering_.write({at.x, at.y + (is_short ? -4 : below)}, in_meshes((in_middle ? 2 : 1) * edge.meshes),
                       kSmall, kInk, formats::Anchor::middle);
    }
  }

  /// Puts the text where it overlaps no other text: in the middle of the panel, in two lines if the panel is
  /// short; beside the middle; or to port at one of three heights, as for narrow panels.
  void draw_words(const PlacedPanel& placed) {
    const std::vector<TextBlock> places = places_of_words(placed);
    const TextBlock* best = &places.back();
    double least = INFINITY;
    for (const TextBlock& place : places)
      if (const double area = lettering_.overlap(place); area < least) {
        least = area;
        best = &place;
      }
    lettering_.write(*best, kInk);
  }

  std::vector<TextBlock> places_of_words(const PlacedPanel& placed) const {
    const Panel& panel = *placed.panel;
    const std::vector<std::string> tall = {panel.name, netting_of(panel), twine_of(panel), depth_of(panel)};
    const std::vector<std::string> flat = {panel.name, fmt::format("{}, {}, {}", tall[1], tall[2], tall[3])};
    std::vector<TextBlock> places;
    for (const auto& lines : {tall, flat})
      for (const double along : {0.5, 0.25, 0.75}) add_place_inside(placed, lines, along, places);
    for (const double down : {0.5, 0.25, 0.75}) add_place_to_port(placed, tall, down, places);
    return places;
  }

  /// Adds a place for the label at half the height of a panel, at the fraction `along` of its width from
  /// port, if the panel is wide and high enough there.
  void add_place_inside(const PlacedPanel& placed, const std::vector<std::string>& lines, double along,
                        std::vector<TextBlock>& places) const {
    const Box box = box_of({placed});
    const double middle = (box.top + box.bottom) / 2;
    const double height = height_of(lines), half = height / 2 / scale_.per_metre;
    if (middle - half < box.top || middle + half > box.bottom) return;
    Box across = across_at(placed, middle);
    for (const double end : {middle - half, middle + half}) {
      across.left = std::max(across.left, across_at(placed, end).left);
      across.right = std::min(across.right, across_at(placed, end).right);
    }
    const double left = scale_({across.left, middle}).x, right = scale_({across.right, middle}).x;
    const double x = std::lerp(left, right, along);
    if (std::min(x - left, right - x) < length_of(lines) / 2 + 4) return;
    places.push_back({{x, first_line(middle, lines)}, lines, formats::Anchor::middle});
  }

  void add_place_to_port(const PlacedPanel& placed, const std::vector<std::string>& lines, double down,
                         std::vector<TextBlock>& places) const {
    const Box box = box_of({placed});
    const double middle = std::lerp(box.top, box.bottom, down),
                 half = height_of(lines) / 2 / scale_.per_metre;
    double left = across_at(placed, middle).left;
    for (const double end : {middle - half, middle + half})
      left = std::min(left, across_at(placed, end).left);
    places.push_back(
        {{scale_({left, middle}).x - 8, first_line(middle, lines)}, lines, formats::Anchor::end});
  }

  static double height_of(const std::vector<std::string>& lines) {
    return kNormal + Lettering::kLeading * static_cast<double>(lines.size() - 1);
  }
  static double length_of(const std::vector<std::string>& lines) {
    double longest = Lettering::length_of(lines.front(), kNormal);
    for (const auto& line : lines) longest = std::max(longest, Lettering::length_of(line, kSmall));
    return longest;
  }
  /// The base line of the first of several lines of text that are centred at a height of the sheet.
  double first_line(double middle, const std::vector<std::string>& lines) const {
    return scale_({0, middle}).y - height_of(lines) / 2 + 0.8 * kNormal;
  }

  /// The extent of a panel across the sheet at the height y, from border to border. For a middle panel, it
  /// includes both halves.
  Box across_at(const PlacedPanel& placed, double y) const {
    Box box;
    for (const auto& edge : placed.outline.edges) {
      const PanelPoint a = placed.on_sheet(edge.from), b = placed.on_sheet(edge.to);
      if ((a.y - y) * (b.y - y) > 0 || a.y == b.y) continue;
      const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
      box.take({x, y});
      if (placed.panel->stands == Standing::middle) box.take({2 * placed.x - x, y});
    }
    return box;
  }

  /// Draws a scale bar. Its length is a round number of metres, about an eighth of the width of the sheet.
  /// Across the gear, the same bar represents half of the stretched width.
  void draw_scale() {
    const double wanted = kWidth / 8 / scale_.per_metre, power = std::pow(10, std::floor(std::log10(wanted)));
    const double metres = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
    const double y = line_ - 6, end = kMargin + metres * scale_.per_metre;
    picture_.line({kMargin, y}, {end, y}, kInk, 2);
    for (const double x : {kMargin, end}) picture_.line({x, y - 4}, {x, y + 4}, kInk, 1);
    picture_.text({end + 8, line_ - 2},
                  in_metres(metres) + " m, stretched length and half of the stretched width", kSmall, kInk,
                  formats::Anchor::start);
    line_ += 1.4 * kLineHeight;
  }

  void say(const std::string& text, const char* colour) {
    for (const auto& line : broken_into_lines(text, kNormal, kWidth - 1.5 * kMargin)) {
      picture_.text({kMargin, line_}, line, kNormal, colour, formats::Anchor::start);
      line_ += kLineHeight;
    }
  }

  void list_ropes() {
    for (const auto& rope : plan_.ropes) {
      if (rope.is_selvedge) continue;
      std::string text = fmt::format("{}: {} m {}", rope.name, in_metres(rope.length), rope.part_name);
      if (rope.stands == Standing::pair) text += ", to port and to starboard";
      if (!rope.between[0].empty()) text += ", from " + rope.between[0] + " to " + rope.between[1];
      say(text + hangings_on(rope), kRope);
    }
  }

  std::string hangings_on(const Rope& rope) const {
    std::string text;
    for (const auto& h : plan_.hangings)
      if (h.rope == rope.name)
        text += fmt::format("; {} {}", h.edge,
                            h.length > 0 ? in_metres(h.length) + " m" : fmt::format("ratio {:.3g}", h.ratio));
    return text;
  }

  void list_pieces() {
    for (const auto& pieces : plan_.pieces)
      say(fmt::format("{}: {:g} {} {} {}", pieces.name, pieces.number, pieces.part_name,
                      pieces.at.empty() ? "along" : "at", pieces.at.empty() ? pieces.along : pieces.at),
          kInk);
  }

  void list_joins() {
    for (const auto& join : plan_.joins) {
      const auto row = [](const std::vector<std::string>& names) {
        return fmt::format("{}", fmt::join(names, " + "));
      };
      std::string others;
      for (std::size_t k = 1; k < join.edges.size(); ++k)
        others += (k > 1 ? ", and to " : "") + row(join.edges[k]) +
                  (join.take_up_of(k) > 0 ? fmt::format(", take-up {:.4g}", join.take_up_of(k)) : "");
      say(fmt::format("seam: {} to {}{}", row(join.edges[0]), others,
                      join.selvedge > 0 ? fmt::format(", {:g} M of either gathered", join.selvedge) : ""),
          kPale);
    }
  }

  const NetPlan& plan_;
  std::vector<PlacedPanel> panels_;
  Box box_;
  Scale scale_;
  formats::LineDrawing& picture_;
  Lettering lettering_;
  double line_ = 0;
};

}  // namespace

formats::DrawingSize draw_plan(const NetPlan& plan, formats::LineDrawing& picture) {
  return Draughtsman(plan, picture).draw();
}

formats::DrawingSize draw_mesh(const NetPlan& plan, const Gear& gear, const GearMesh& mesh,
                               formats::LineDrawing& picture) {
  const formats::LongWork drawing({"drawing", "the mesh"});
  return Draughtsman(plan, picture).draw(gear, mesh);
}

}  // namespace netloft::gears
