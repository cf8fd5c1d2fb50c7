// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/seam_lines.hpp"

#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/gear_size.hpp"
#include "io/gears/meshing/knots.hpp"
#include "io/gears/meshing/rope_course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace netloft::gears {

namespace {

// Corners on opposite sides of a seam are merged if they are closer than this fraction of an element.
constexpr double kSnap = 0.3;
constexpr double kGrowth = 0.4;  // increase of the element size per length along a line

double finer(const Fineness& fineness, const std::string& name, const std::string& plan_name) {
  auto at = fineness.finer.find(name);
  if (at == fineness.finer.end()) at = fineness.finer.find(plan_name);
  return at == fineness.finer.end() ? 1 : at->second;
}

/// Makes the lines of knots of one gear; the member functions are steps in the order of execution.
class LineMaker {
 public:
  LineMaker(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size)
      : gear_(gear),
        cloths_(cloths),
        fineness_(fineness),
        size_(size),
        borders_(sew(gear, cloths, kSnap * size)) {}

  SeamLines make() {
    connect();
    divide_all();
    return std::move(all_);
  }

  SeamLines make_alike(const MeshTopology& like) {
    connect();
    if (!std::ranges::equal(all_.lines, like.ends, {}, &Line::ends) || all_.number_of_points != like.points)
      throw std::invalid_argument("the corners along a seam follow each other in another order");
    for (std::size_t l = 0; l < all_.lines.size(); ++l) all_.lines[l].fractions = like.fractions[l];
    return std::move(all_);
  }

 private:
  void connect() {
    const RopeCourses ropes = run_ropes(gear_, borders_);
    number_points(ropes);
    add_side_lines();
    for (std::size_t r = 0; r < gear_.ropes.size(); ++r) add_rope(r, ropes.courses[r]);
  }

  std::size_t number_of(std::size_t point) { return numbers_[borders_.points.root(point)]; }

  void number_points(const RopeCourses& ropes) {
    numbers_.assign(borders_.points.size(), kNoPoint);
    for (const auto& breaks : borders_.breaks)
      for (const auto& b : breaks) number(b.point);
    for (const auto& course : ropes.courses)
      for (const auto& stretch : course) {
        number(stretch.from);
        number(stretch.to);
      }
    for (const auto& [name, point] : ropes.points)
      if (number_of(point) != kNoPoint) all_.points.emplace(name, number_of(point));
  }

  void number(std::size_t point) {
    auto& n = numbers_[borders_.points.root(point)];
    if (n == kNoPoint) n = all_.number_of_points++;
  }

  double size_of(const ClothSide& side) const {
    const GearPanel& panel = gear_.panels[cloths_.cloths[side.cloth].panel];
    return size_ / finer(fineness_, panel.name, panel.panel->name);
  }

  double knots_of(const ClothSide& side) const {
    const Cloth& cloth = cloths_.cloths[side.cloth];
    return knots_along(*gear_.panels[cloth.panel].panel, cloth.sign, side.from, side.to);
  }

  void add_side_lines() {
    all_.sides.resize(cloths_.sides.size());
    all_.faces = Faces(cloths_.cloths.size());
    for (std::size_t s = 0; s < cloths_.sides.size(); ++s) {
      const auto& breaks = borders_.breaks[s];
      for (std::size_t b = 0; b + 1 < breaks.size(); ++b)
        all_.sides[s].push_back({{kNoPoint, true}, breaks[b].fraction, breaks[b + 1].fraction});
    }
    for (const auto& seam : borders_.seams) share_lines(seam);
    for (std::size_t s = 0; s < cloths_.sides.size(); ++s)
      for (std::size_t b = 0; b < all_.sides[s].size(); ++b)
        if (all_.sides[s][b].line == kNoPoint) use(add_line(), {s, true}, b);
  }

  std::size_t add_line() {
    all_.lines.push_back({{}, 0, std::numeric_limits<double>::infinity(), 0, true, {}});
    all_.is_on_plane.push_back(false);
    return all_.lines.size() - 1;
  }

  /// A run (a part of a side along one line), given by its index along the side.
  struct RunOfSide {
    DirectedSide side;
    std::size_t run;
  };

  std::vector<RunOfSide> runs_of(const Row& row) const {
    std::vector<RunOfSide> runs;
    for (const auto& s : row) {
      const std::size_t n = all_.sides[s.side].size();
      for (std::size_t k = 0; k < n; ++k) runs.push_back({s, s.is_forward ? k : n - 1 - k});
    }
    return runs;
  }

  void share_lines(const SewnRows& seam) {
    const auto a = runs_of(seam.rows[0]), b = runs_of(seam.rows[1]);
    if (a.size() != b.size()) refuse_seam(gear_, cloths_, seam);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const std::size_t line = line_of(a[k], seam.is_of_layer);
      const auto ends = all_.lines[line].ends;
      use(line, b[k].side, b[k].run);
      if (all_.lines[line].ends != ends) refuse_seam(gear_, cloths_, seam);
      state_faces(seam, a[k].side, b[k].side);
    }
  }

  /// The line of a run of a first row: a new one, or, for a further layer, that of the layers before it.
  std::size_t line_of(const RunOfSide& run, bool is_of_layer) {
    if (is_of_layer) return all_.sides[run.side.side][run.run].line;
    const std::size_t line = add_line();
    use(line, run.side, run.run);
    return line;
  }

  /// Two cloths show the same face outwards if their borders run along their common seam in opposite
  /// directions.
  void state_faces(const SewnRows& seam, const DirectedSide& a, const DirectedSide& b) {
    const std::size_t one = cloths_.sides[a.side].cloth, other = cloths_.sides[b.side].cloth;
    if (!all_.faces.state(one, other, a.is_forward == b.is_forward)) refuse_twist(seam, one, other);
    neighbours_.push_back({one, other, &seam});
  }

  struct Neighbours {
    std::size_t one, other;
    const SewnRows* seam;
  };

  /// The seams on the shortest way between two cloths.
  std::vector<const SewnRows*> way_between(std::size_t from, std::size_t to) const {
    std::map<std::size_t, const Neighbours*> reached{{from, nullptr}};
    std::vector<std::size_t> next{from};
    for (std::size_t k = 0; k < next.size() && !reached.contains(to); ++k)
      for (const auto& n : neighbours_)
        if (n.one == next[k] || n.other == next[k])
          if (const auto at = n.one == next[k] ? n.other : n.one; reached.emplace(at, &n).second)
            next.push_back(at);
    std::vector<const SewnRows*> way;
    for (std::size_t at = to; at != from;) {
      const Neighbours& n = *reached.at(at);
      if (n.seam->join) way.push_back(n.seam);
      at = n.one == at ? n.other : n.one;
    }
    return way;
  }

  [[noreturn]] void refuse_twist(const SewnRows& seam, std::size_t one, std::size_t other) const {
    const auto name = [&](const SewnRows& s) {
      return fmt::format("{} and {}", gears::name_of(gear_, cloths_, s.rows[0]),
                         gears::name_of(gear_, cloths_, s.rows[1]));
    };
    std::string others;
    for (const SewnRows* s : way_between(one, other)) others += (others.empty() ? "" : ", ") + name(*s);
    throw CannotDivide::seam(
        seam.join.value_or(0),
        fmt::format("the seam of {}{} would twist the net, so that its outside becomes its inside",
                    name(seam), others.empty() ? "" : ", together with those of " + others + ","),
        "seams run outwards along fore and aft edges, and aft along sides: sew one of these edges to another "
        "edge, or turn its panel in the plan");
  }

  /// Makes a run of a side use a line. If two sides give the line different lengths, for instance because of
  /// different mesh sizes, the line gets the geometric mean of both lengths.
  void use(std::size_t l, DirectedSide s, std::size_t k) {
    const ClothSide& side = cloths_.sides[s.side];
    const auto& breaks = borders_.breaks[s.side];
    SideRun& run = all_.sides[s.side][k];
    run.line = l;
    run.is_forward = s.is_forward;
    Line& line = all_.lines[l];
    line.ends = {number_of(breaks[s.is_forward ? k : k + 1].point),
                 number_of(breaks[s.is_forward ? k + 1 : k].point)};
    const double length = side.length * (run.to - run.from);
    line.length = line.length > 0 ? std::sqrt(line.length * length) : length;
    line.size = std::min(line.size, size_of(side));
    if (fineness_.knots) line.knots = std::max(line.knots, knots_of(side) * (run.to - run.from));
    if (side.is_on_plane) all_.is_on_plane[l] = true;
  }

  void add_rope(std::size_t r, const RopeCourse& course) {
    const GearRope& rope = gear_.ropes[r];
    const double size = std::max(size_, coarsest(rope)) / finer(fineness_, rope.name, rope.rope->name);
    auto& runs = all_.ropes.emplace_back();
    for (const auto& stretch : course)
      if (stretch.is_free)
        runs.push_back(free_run(stretch, size));
      else
        for (const auto& run : runs_of({stretch.along})) runs.push_back(hung_run(run, stretch.length, size));
    all_.rope_ends.push_back({number_of(course.front().from), number_of(course.back().to)});
    const auto middle = all_.points.find(rope.name + ".middle");
    all_.rope_middles.push_back(middle == all_.points.end() ? kNoPoint : middle->second);
  }

  /// The largest length of bars of a warp [m]; 0 for other ropes. Along its length, a warp changes its
  /// direction by some tenths of a radian. With 32 bars, its tension is accurate to a thousandth, whatever
  /// the size of elements in the netting.
  static double coarsest(const GearRope& rope) {
    constexpr double kBarsOfWarps = 32;
    return rope.rope->role == kWarp ? rope.length / kBarsOfWarps : 0;
  }

  RopeRun free_run(const RopeStretch& stretch, double size) {
    all_.lines.push_back(
        {{number_of(stretch.from), number_of(stretch.to)}, stretch.length, size, 0, false, {}});
    all_.is_on_plane.push_back(false);
    return {{all_.lines.size() - 1, true}, stretch.length};
  }

  RopeRun hung_run(const RunOfSide& of, double length, double size) {
    const SideRun& run = all_.sides[of.side.side][of.run];
    all_.lines[run.line].size = std::min(all_.lines[run.line].size, size);
    return {{run.line, run.is_forward == of.side.is_forward}, length * (run.to - run.from)};
  }

  void divide_all() {
    std::vector<double> smallest(all_.number_of_points, std::numeric_limits<double>::infinity());
    for (const auto& line : all_.lines)
      for (const std::size_t end : line.ends)
        if (line.is_netting) smallest[end] = std::min({smallest[end], line.size, line.length});
    for (auto& line : all_.lines)
      if (line.knots > 0)
        divide_evenly(line);
      else
        divide_line(line, line.is_netting ? smallest[line.ends[0]] : line.size,
                    line.is_netting ? smallest[line.ends[1]] : line.size);
    part_parallel_lines();
  }

  /// Rounds the number of elements of a line to a whole number, at least 1, or 3 if the line is closed.
  /// Throws if all lines together have more than kMostNodes elements, or if `elements` is NaN because the
  /// line has no length.
  std::size_t count(const Line& line, double elements) {
    elements_ += elements;
    if (!(elements_ <= kMostNodes))
      throw std::invalid_argument(
          fmt::format("{} would be divided into more than {:g} elements", name_of(line), kMostNodes));
    const std::size_t fewest = line.ends[0] == line.ends[1] ? 3 : 1;
    return std::max(fewest, static_cast<std::size_t>(std::lround(elements)));
  }

  /// The name of the first edge or rope that runs along a line.
  std::string name_of(const Line& line) const {
    const auto is_it = [&](const Run& run) { return &all_.lines[run.line] == &line; };
    for (std::size_t s = 0; s < all_.sides.size(); ++s)
      if (std::any_of(all_.sides[s].begin(), all_.sides[s].end(), is_it) && !cloths_.sides[s].is_inside)
        return gear_.name_of(cloths_.sides[s].edge);
    for (std::size_t r = 0; r < all_.ropes.size(); ++r)
      if (std::any_of(all_.ropes[r].begin(), all_.ropes[r].end(), is_it)) return gear_.ropes[r].name;
    return "the middle of a panel";
  }

  /// Divides a line of length L into n elements, whose size is h(x) at the distance x from its start. g is
  /// kGrowth; h₀ and h₁ are the sizes at both ends:
  ///   h(x) = min(size, h₀ + g x, h₁ + g (L − x)),   n = ∫ dx/h                                     (1)
  /// Each element covers the same part of the integral.
  void divide_line(Line& line, double h0, double h1) {
    const auto h = [&](double x) {
      return std::min({line.size, h0 + kGrowth * x, h1 + kGrowth * (line.length - x)});
    };
    const auto steps = static_cast<std::size_t>(
        std::clamp(8 * std::ceil(line.length / std::min({line.size, h0, h1})), 16.0, 1e6));
    std::vector<double> sum{0};
    for (std::size_t k = 0; k < steps; ++k)
      sum.push_back(sum.back() +
                    line.length / static_cast<double>(steps) /
                        h(line.length * (static_cast<double>(k) + 0.5) / static_cast<double>(steps)));
    spread_nodes(line, sum, count(line, sum.back()));
  }

  /// Divides a line evenly into elements from knot to knot.
  void divide_evenly(Line& line) {
    const std::size_t elements = count(line, line.knots);
    line.fractions.clear();
    for (std::size_t i = 1; i < elements; ++i)
      line.fractions.push_back(static_cast<double>(i) / static_cast<double>(elements));
  }

  static void spread_nodes(Line& line, const std::vector<double>& sum, std::size_t elements) {
    line.fractions.clear();
    std::size_t k = 0;
    for (std::size_t i = 1; i < elements; ++i) {
      const double wanted = sum.back() * static_cast<double>(i) / static_cast<double>(elements);
      while (sum[k + 1] < wanted) ++k;
      line.fractions.push_back((static_cast<double>(k) + (wanted - sum[k]) / (sum[k + 1] - sum[k])) /
                               static_cast<double>(sum.size() - 1));
    }
  }

  /// Adds a node in the middle of lines that would otherwise coincide, because they have the same two ends
  /// and no inner node.
  void part_parallel_lines() {
    std::map<std::array<std::size_t, 2>, std::size_t> seen;
    for (auto& line : all_.lines) {
      auto ends = line.ends;
      std::sort(ends.begin(), ends.end());
      if (line.fractions.empty() && seen[ends]++ > 0) line.fractions = {0.5};
    }
  }

  const Gear& gear_;
  const Cloths& cloths_;
  const Fineness& fineness_;
  double size_;
  Borders borders_;
  std::vector<std::size_t> numbers_;
  double elements_ = 0;  // number of elements of all lines so far
  std::vector<Neighbours> neighbours_;
  SeamLines all_;
};

}  // namespace

SeamLines seam_lines(const Gear& gear, const Cloths& cloths, const Fineness& fineness, double size) {
  return LineMaker(gear, cloths, fineness, size).make();
}

SeamLines seam_lines_alike(const Gear& gear, const Cloths& cloths, const Fineness& fineness,
                           const MeshTopology& like) {
  return LineMaker(gear, cloths, fineness, like.size).make_alike(like);
}

}  // namespace netloft::gears
