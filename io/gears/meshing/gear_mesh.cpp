// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/gear_mesh.hpp"

#include "io/formats/work/long_work.hpp"
#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/gear_size.hpp"
#include "io/gears/meshing/knots.hpp"
#include "io/gears/meshing/seam_lines.hpp"
#include "io/gears/meshing/triangulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

namespace netloft::gears {

namespace {

constexpr double kNear = 0.05;   // accepted relative deviation from the requested number of nodes
constexpr int kTrials = 8;       // number of sizes that are tried to reach the requested number
constexpr double kGrid = 1e-10;  // grid to which positions are rounded, so that port is the exact mirror
                                 // image of starboard

// Two places on a middle line that are closer than this count as one [meshes].
constexpr double kSamePlace = 1e-6;

constexpr int kPartings = 20;  // largest number of rounds in which coincident sides are separated

/// The border of a cloth, a piece of netting: its nodes and their positions in the undeformed panel.
struct Border {
  std::vector<std::uint32_t> nodes;
  std::vector<PanelPoint> points;
  std::vector<std::size_t> side_starts;  // index in the border at which each side starts
};

/// Divides one gear with one element size; the member functions are steps in the order of execution.
class Divider {
 public:
  Divider(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size)
      : gear_(gear),
        cloths_(cloths),
        fineness_(fineness),
        size_(size),
        lines_(seam_lines(gear, cloths, fineness, size)) {}

  Divider(const Gear& gear, const Cloths& cloths, const Fineness& fineness, const MeshTopology& like)
      : gear_(gear),
        cloths_(cloths),
        fineness_(fineness),
        size_(like.size),
        lines_(seam_lines_alike(gear, cloths, fineness, like)) {}

  GearMesh divide() {
    begin();
    fill_cloths();
    for (int trial = 0; trial < kPartings && part_doubled_sides(); ++trial) continue;
    return finish();
  }

  GearMesh divide_alike(const MeshTopology& like) {
    begin();
    move_cloths(like);
    return finish();
  }

 private:
  void begin() {
    number_lines();
    find_senses();
    mesh_.panels.resize(gear_.panels.size());
  }

  GearMesh finish() {
    for (std::size_t c = 0; c < cloths_.cloths.size(); ++c) add_cloth(c);
    for (std::size_t r = 0; r < gear_.ropes.size(); ++r) add_rope(r);
    add_points();
    add_middle();
    mesh_.topology = topology();
    return std::move(mesh_);
  }

  std::shared_ptr<const MeshTopology> topology() const {
    auto all = std::make_shared<MeshTopology>();
    all->size = size_;
    all->points = lines_.number_of_points;
    for (const Line& line : lines_.lines) {
      all->ends.push_back(line.ends);
      all->fractions.push_back(line.fractions);
    }
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      all->cloths.push_back(planes_[c]);
      all->cloths.back().points = points_in_meshes(c);
      all->borders.push_back(borders_[c].nodes.size());
    }
    return all;
  }

  /// The points of a cloth, counted in meshes.
  std::vector<PlanePoint> points_in_meshes(std::size_t c) const {
    std::vector<PlanePoint> points;
    const PanelPoint unit = spread(*gear_.panels[cloths_.cloths[c].panel].panel, {1, 1});
    for (const PanelPoint& p : borders_[c].points) points.push_back({p.x, p.y});
    for (std::size_t k = points.size(); k < planes_[c].points.size(); ++k)
      points.push_back({planes_[c].points[k][0] / unit.x, planes_[c].points[k][1] / unit.y});
    return points;
  }

  std::uint32_t add_node() { return static_cast<std::uint32_t>(mesh_.nodes++); }

  /// Numbers the end points of the lines of knots first, then the nodes between them.
  void number_lines() {
    mesh_.nodes = lines_.number_of_points;
    for (const auto& line : lines_.lines) {
      auto& nodes = line_nodes_.emplace_back();
      nodes.push_back(static_cast<std::uint32_t>(line.ends[0]));
      for (std::size_t k = 0; k < line.fractions.size(); ++k) nodes.push_back(add_node());
      nodes.push_back(static_cast<std::uint32_t>(line.ends[1]));
    }
  }

  std::vector<std::uint32_t> nodes_of(const Run& run) const {
    auto nodes = line_nodes_[run.line];
    if (!run.is_forward) std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  std::vector<double> fractions_of(const Run& run) const {
    auto fractions = lines_.lines[run.line].fractions;
    fractions.insert(fractions.begin(), 0);
    fractions.push_back(1);
    if (run.is_forward) return fractions;
    std::reverse(fractions.begin(), fractions.end());
    for (auto& fraction : fractions) fraction = 1 - fraction;
    return fractions;
  }

  /// Finds for each cloth whether its counter-clockwise triangles are also counter-clockwise seen from
  /// outside the net. The first panel is assumed to be the upper one. Seen from above, the rotation from
  /// outwards to aft is clockwise on its starboard side.
  void find_senses() {
    std::map<std::size_t, int> senses;  // by the representative of connected pieces (faces.hpp)
    for (std::size_t c = 0; c < cloths_.cloths.size(); ++c) {
      const auto [root, is_turned] = lines_.faces.root(c);
      const int turn = is_turned ? -1 : 1;
      const auto sense = senses.emplace(root, turn * (cloths_.cloths[c].is_port ? 1 : -1)).first;
      senses_.push_back(turn * sense->second);
    }
  }

  Border border_of(const Cloth& cloth) const {
    Border border;
    for (const std::size_t s : cloth.sides) {
      border.side_starts.push_back(border.nodes.size());
      for (const auto& run : lines_.sides[s]) append(border, cloths_.sides[s], run);
    }
    return border;
  }

  /// Appends the nodes of a run, a part of a side along one line, except its last node.
  void append(Border& border, const ClothSide& side, const SideRun& run) const {
    const auto nodes = nodes_of(run);
    const auto fractions = fractions_of(run);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const double t = run.from + fractions[k] * (run.to - run.from);
      border.nodes.push_back(nodes[k]);
      border.points.push_back(
          {side.from.x + t * (side.to.x - side.from.x), side.from.y + t * (side.to.y - side.from.y)});
    }
  }

  void report(const Cloth& cloth, std::size_t inside) const {
    formats::report({"meshing", gear_.panels[cloth.panel].name, mesh_.nodes + inside, "nodes"});
  }

  void fill_cloths() {
    std::size_t inside = 0;
    for (const auto& cloth : cloths_.cloths) {
      report(cloth, inside);
      borders_.push_back(border_of(cloth));
      planes_.push_back(fill(cloth, borders_.back()));
      inside += planes_.back().points.size() - borders_.back().nodes.size();
    }
  }

  /// Fills the cloths with the triangles of another gear, whose inner nodes are moved with the borders.
  void move_cloths(const MeshTopology& like) {
    for (std::size_t c = 0; c < cloths_.cloths.size(); ++c) {
      const Panel& panel = *gear_.panels[cloths_.cloths[c].panel].panel;
      borders_.push_back(border_of(cloths_.cloths[c]));
      std::vector<PlanePoint> border;
      for (const PanelPoint& p : borders_[c].points) border.push_back({p.x, p.y});
      planes_.push_back(moved_with_border(like.cloths[c], border));
      for (PlanePoint& p : planes_[c].points) {
        const PanelPoint there = spread(panel, {p[0], p[1]});
        p = {there.x, there.y};
      }
    }
  }

  PlaneMesh fill(const Cloth& cloth, const Border& border) const {
    const GearPanel& panel = gear_.panels[cloth.panel];
    const auto points = on_plane(*panel.panel, border);
    try {
      return fineness_.knots ? connect_points(points, knots_within(*panel.panel, cloth.sign, points))
                             : triangulate(points, size_of(cloth));
    } catch (const std::invalid_argument& e) {
      throw CannotDivide::panel(
          panel.panel->name, std::string("the border of the panel encloses no netting, because ") + e.what(),
          "its cuttings may meet: shorten a cut, or give the panel more meshes");
    }
  }

  double size_of(const Cloth& cloth) const {
    const GearPanel& panel = gear_.panels[cloth.panel];
    return fineness_.knots ? panel.panel->mesh / 2 : size_ / finer(fineness_, panel);
  }

  using PlaneSide = std::array<std::uint32_t, 2>;

  /// Triangle sides that end on the border but do not lie along it. Each side is listed once.
  std::vector<PlaneSide> inner_sides(std::size_t c) const {
    const auto n = static_cast<std::uint32_t>(borders_[c].nodes.size());
    std::set<PlaneSide> sides;
    for (const auto& t : planes_[c].triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        const bool is_border = b < n && (b == a + 1 || (a == 0 && b == n - 1));
        if (a < n && !is_border) sides.insert({a, b});
      }
    return {sides.begin(), sides.end()};
  }

  /// Identifies a node before the nodes within cloths are numbered: {0, node} for a node on a line, {cloth +
  /// 1, index} for a node within a cloth.
  using Tag = std::array<std::size_t, 2>;
  Tag tag(std::size_t c, std::uint32_t point) const {
    const auto& nodes = borders_[c].nodes;
    return point < nodes.size() ? Tag{0, nodes[point]} : Tag{c + 1, point};
  }
  std::pair<Tag, Tag> tags(std::size_t c, const PlaneSide& side) const {
    return std::minmax(tag(c, side[0]), tag(c, side[1]));
  }

  /// Separates triangle sides that connect the same two nodes of the gear without being sewn together, and
  /// sides whose two ends are the same node. Such sides occur near sharp corners and where seams end in a
  /// point. Each of them gets a node in its middle. Returns whether there were any.
  bool part_doubled_sides() {
    std::map<std::pair<Tag, Tag>, int> times;
    for (const auto& nodes : line_nodes_)
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
        ++times[std::minmax(Tag{0, nodes[k]}, Tag{0, nodes[k + 1]})];
    std::vector<std::vector<PlaneSide>> sides;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      sides.push_back(inner_sides(c));
      for (const auto& side : sides[c]) ++times[tags(c, side)];
    }
    bool was_any = false;
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      std::erase_if(sides[c], [&](const PlaneSide& side) {
        const auto [from, to] = tags(c, side);
        return from != to && times[{from, to}] < 2;
      });
      if (sides[c].empty()) continue;
      planes_[c] = split_sides(planes_[c], borders_[c].nodes.size(), size_of(cloths_.cloths[c]), sides[c],
                               fineness_.knots ? Smoothing::none : Smoothing::all);
      was_any = true;
    }
    return was_any;
  }

  void add_cloth(std::size_t c) {
    const Cloth& cloth = cloths_.cloths[c];
    report(cloth, 0);
    const PlaneMesh& plane = planes_[c];
    const auto own = add_own_nodes(c);
    for (auto t : plane.triangles) {
      if (senses_[c] < 0) std::swap(t[1], t[2]);
      for (const auto v : t) mesh_.panels[cloth.panel].triangles.push_back(own[v]);
    }
    add_sets(cloth, borders_[c], own);
  }

  /// The border as positions in half-open netting [m]. Positions are rounded to a grid, because rounding
  /// errors would otherwise depend on the direction in which a line is divided.
  static std::vector<PlanePoint> on_plane(const Panel& panel, const Border& border) {
    std::vector<PlanePoint> points;
    double extent = 0;
    for (const auto& point : border.points) {
      const PanelPoint p = spread(panel, point);
      points.push_back({p.x, p.y});
      extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
    }
    const double grid = std::exp2(std::ceil(std::log2(kGrid * extent)));
    for (auto& p : points)
      for (auto& x : p) x = grid * std::round(x / grid);
    return points;
  }

  /// Adds the nodes of a cloth; both halves of a panel use the same nodes on the line between them.
  std::vector<std::uint32_t> add_own_nodes(std::size_t c) {
    const Cloth& cloth = cloths_.cloths[c];
    const auto& border = borders_[c].nodes;
    const std::vector<PlanePoint> points = points_in_meshes(c);
    std::vector<std::uint32_t> own;
    for (std::size_t k = 0; k < points.size(); ++k)
      own.push_back(own_node(cloth, k < border.size() ? border[k] : add_node(),
                             {cloth.sign * points[k][0], points[k][1]}));
    return own;
  }

  std::uint32_t own_node(const Cloth& cloth, std::uint32_t node, std::array<double, 2> meshes) {
    PanelMesh& panel = mesh_.panels[cloth.panel];
    const auto own = static_cast<std::uint32_t>(panel.nodes.size());
    if (meshes[0] == 0) {
      auto& places = in_middle_[cloth.panel][node];
      if (cloth.sign < 0)
        if (const auto same = std::ranges::find_if(
                places,
                [&](std::uint32_t o) { return std::abs(panel.meshes[o][1] - meshes[1]) < kSamePlace; });
            same != places.end())
          return *same;
      places.push_back(own);
    }
    panel.nodes.push_back(node);
    panel.meshes.push_back({meshes[0] == 0 ? 0 : meshes[0], meshes[1]});
    return own;
  }

  void add_sets(const Cloth& cloth, const Border& border, const std::vector<std::uint32_t>& own) {
    for (std::size_t k = 0; k < cloth.sides.size(); ++k) {
      const ClothSide& side = cloths_.sides[cloth.sides[k]];
      if (side.is_inside) continue;
      std::vector<std::uint32_t> nodes;
      const std::size_t last = k + 1 < cloth.sides.size() ? border.side_starts[k + 1] : border.nodes.size();
      for (std::size_t i = border.side_starts[k]; i <= last; ++i)
        nodes.push_back(own[i % border.nodes.size()]);
      add_to_edge(cloth, side, std::move(nodes));
    }
    for (const auto& [name, s] : cloth.corners) add_corner(cloth, border, own, name, s);
  }

  /// Adds the nodes of a side to the set of its edge. The halves of an edge follow each other in its
  /// direction.
  void add_to_edge(const Cloth& cloth, const ClothSide& side, std::vector<std::uint32_t> nodes) {
    if (side.is_reversed) std::reverse(nodes.begin(), nodes.end());
    auto& set = mesh_.panels[cloth.panel].sets[gear_.panels[cloth.panel].outline.edges[side.edge.edge].name];
    if (set.empty())
      set = std::move(nodes);
    else if (set.back() == nodes.front())
      set.insert(set.end(), nodes.begin() + 1, nodes.end());
    else
      set.insert(set.begin(), nodes.begin(), nodes.end() - 1);
  }

  void add_corner(const Cloth& cloth, const Border& border, const std::vector<std::uint32_t>& own,
                  const std::string& name, std::size_t side) {
    const auto k = static_cast<std::size_t>(std::find(cloth.sides.begin(), cloth.sides.end(), side) -
                                            cloth.sides.begin());
    const std::uint32_t node = own[border.side_starts[k]];
    // In half a middle panel, the corner "fore-outer" may have a name with a side, such as
    // "body.port-fore-outer".
    for (const std::string& corner : {name, (cloth.is_port ? "port-" : "starboard-") + name})
      if (const auto known = lines_.points.find(gear_.panels[cloth.panel].name + "." + corner);
          known != lines_.points.end() && known->second == border.nodes[border.side_starts[k]])
        mesh_.panels[cloth.panel].sets[corner] = {node};
  }

  void add_rope(std::size_t r) {
    RopeMesh rope;
    rope.nodes.push_back(static_cast<std::uint32_t>(lines_.rope_ends[r][0]));
    for (const auto& run : lines_.ropes[r]) {
      const auto nodes = nodes_of(run);
      const auto fractions = fractions_of(run);
      for (std::size_t k = 1; k < nodes.size(); ++k) {
        rope.nodes.push_back(nodes[k]);
        rope.rest_lengths.push_back(run.length * (fractions[k] - fractions[k - 1]));
      }
    }
    const auto last = static_cast<std::uint32_t>(rope.nodes.size() - 1);
    rope.sets["end"] = {last};
    if (gear_.ropes[r].rope->stands == Standing::middle) {
      rope.sets["starboard"] = {last};
      rope.sets[gear_.extent == Extent::whole ? "port" : "middle"] = {0};
    } else {
      rope.sets["start"] = {0};
    }
    const auto middle = std::find(rope.nodes.begin(), rope.nodes.end(), lines_.rope_middles[r]);
    if (lines_.rope_middles[r] != kNoPoint && middle != rope.nodes.end())
      rope.sets["middle"] = {static_cast<std::uint32_t>(middle - rope.nodes.begin())};
    mesh_.ropes.push_back(std::move(rope));
  }

  void add_points() {
    for (const auto& [name, point] : lines_.points)
      mesh_.points.emplace(name, static_cast<std::uint32_t>(point));
  }

  /// In half a gear, collects the nodes on the plane of symmetry: those on sides of cloths, the starts of
  /// ropes across the plane, and points in the middle.
  void add_middle() {
    if (gear_.extent != Extent::half) return;
    std::set<std::uint32_t> middle;
    for (std::size_t l = 0; l < lines_.lines.size(); ++l)
      if (lines_.is_on_plane[l]) middle.insert(line_nodes_[l].begin(), line_nodes_[l].end());
    for (std::size_t r = 0; r < gear_.ropes.size(); ++r)
      if (gear_.ropes[r].rope->stands == Standing::middle) middle.insert(mesh_.ropes[r].nodes.front());
    for (const auto& point : gear_.points)
      if (const auto at = mesh_.points.find(point.name);
          point.point->stands == Standing::middle && at != mesh_.points.end())
        middle.insert(at->second);
    mesh_.middle.assign(middle.begin(), middle.end());
  }

  const Gear& gear_;
  const Cloths& cloths_;
  const Fineness& fineness_;
  double size_;
  SeamLines lines_;
  std::vector<std::vector<std::uint32_t>> line_nodes_;
  std::vector<Border> borders_;    // border of each cloth
  std::vector<PlaneMesh> planes_;  // triangles of each cloth
  // For each panel, its nodes on the middle line: their numbers within the panel, by their number in the
  // gear. One node of the gear may have several numbers in a panel, because seams and ropes may join places
  // on the middle line.
  std::map<std::size_t, std::map<std::uint32_t, std::vector<std::uint32_t>>> in_middle_;
  std::vector<int> senses_;  // orientation of each cloth
  GearMesh mesh_;
};

}  // namespace

GearMesh divide(const Gear& gear, const Fineness& fineness) {
  const formats::LongWork meshing({"meshing", "the gear"});
  const Cloths cloths = cloths_of(gear);
  if (fineness.knots) {
    check_knots(gear);
    return Divider(gear, cloths, fineness, shortest_bar(gear)).divide();
  }
  if (fineness.size > 0) {
    check_size(gear, fineness);
    return Divider(gear, cloths, fineness, fineness.size).divide();
  }
  double size = size_for(gear, fineness);
  GearMesh best;
  double nearest = 1e300;
  for (int trial = 0; trial < kTrials && nearest > std::log1p(kNear); ++trial) {
    GearMesh mesh = Divider(gear, cloths, fineness, size).divide();
    const double ratio =
        static_cast<double>(mesh.nodes) / static_cast<double>(std::max<std::size_t>(fineness.nodes, 3));
    size *= std::sqrt(ratio);
    if (std::abs(std::log(ratio)) >= nearest) continue;
    nearest = std::abs(std::log(ratio));
    best = std::move(mesh);
  }
  return best;
}

MeshQuality quality_of(const Gear& gear, const GearMesh& mesh) {
  MeshQuality quality{std::numbers::pi, 0, 0};
  for (std::size_t p = 0; p < mesh.panels.size(); ++p) {
    std::vector<PlanePoint> points;
    for (const auto& [U, V] : mesh.panels[p].meshes) {
      const PanelPoint at = spread(*gear.panels[p].panel, {U, V});
      points.push_back({at.x, at.y});
    }
    const auto& corners = mesh.panels[p].triangles;
    quality.triangles += corners.size() / 3;
    for (std::size_t t = 0; t < corners.size(); t += 3)
      for (const double angle :
           angles_of(points[corners[t]], points[corners[t + 1]], points[corners[t + 2]])) {
        quality.least_angle = std::min(quality.least_angle, angle);
        quality.greatest_angle = std::max(quality.greatest_angle, angle);
      }
  }
  return quality;
}

GearMesh divide_alike(const Gear& gear, const Fineness& fineness, const MeshTopology& like) {
  return Divider(gear, cloths_of(gear), fineness, like).divide_alike(like);
}

}  // namespace netloft::gears
