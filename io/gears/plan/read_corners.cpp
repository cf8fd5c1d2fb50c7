// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a panel given by its corners in meshes instead of counts and cuttings: any polygon with three corners
// or more. From the fore end to the aft end, neither of its two sides may run forward.
#include "io/gears/plan/plan_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

constexpr double kSame = 1e-9;  // tolerance for equal counts [meshes]

struct Corner {
  double across = 0, deep = 0;  // meshes outwards and aft
  std::string edge;             // name of the edge that begins at the corner; empty: a default name
};

/// Divides the border given by corners into edges; the member functions are steps in the order of execution.
class CornerReader {
 public:
  CornerReader(Panel& panel, formats::TableReader& table) : panel_(panel), table_(table) {}

  void read() {
    refuse_what_corners_say();
    read_corners();
    if (has_failed_) return;
    turn_to_fore();
    divide();
    if (has_failed_) return;
    name_sides();
    panel_.has_corners = true;
  }

 private:
  void fail(const std::string& what, const std::string& hint) {
    if (!has_failed_) table_.error("corners", what, hint);
    has_failed_ = true;
  }

  void refuse_what_corners_say() {
    for (const char* key : {"fore", "round", "aft", "depth", "pieces", "sides", "outer", "inner"})
      if (table_.has(key)) table_.error(key, "follows from the corners", "leave out either of them");
  }

  void read_corners() {
    const auto rows = table_.rows(
        "corners", {.unit = "1",
                    .doc = "meshes across (outwards) and deep (aft) of each corner, in a row round the panel",
                    .range = formats::between(-kMostMeshes, kMostMeshes),
                    .rows = {.least = 3},
                    .columns = formats::exactly(2)});
    const auto names =
        table_.has("edges")
            ? table_.texts("edges", {.doc = "names of the edges, each from a corner to the next",
                                     .count = formats::exactly(rows.size())})
            : std::vector<std::string>();
    for (const auto& row : rows)
      if (row.size() == 2) corners_.push_back({row[0], row[1], {}});
    for (std::size_t i = 0; i < std::min(names.size(), corners_.size()); ++i) corners_[i].edge = names[i];
    has_failed_ = corners_.size() < 3 || corners_.size() != rows.size();
    for (std::size_t i = 0; i < corners_.size() && !has_failed_; ++i)
      if (length(i, (i + 1) % corners_.size()) < kSame)
        fail(fmt::format("corners {} and {} are in one place", i + 1, (i + 1) % corners_.size() + 1),
             "leave out either of them");
  }

  double length(std::size_t a, std::size_t b) const {
    return std::hypot(corners_[b].across - corners_[a].across, corners_[b].deep - corners_[a].deep);
  }

  double area() const {
    double sum = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      sum += a.across * b.deep - b.across * a.deep;
    }
    return sum / 2;
  }

  /// Reorders the corners as in an outline, which begins at the inner end of the fore edge and follows this
  /// edge outwards.
  void turn_to_fore() {
    if (std::abs(area()) < kSame) return fail("enclose no netting", "give them in a row round the panel");
    if (area() < 0) {
      std::reverse(corners_.begin(), corners_.end());
      auto first = corners_.front().edge;  // an edge belongs to its first corner, now its last one
      for (std::size_t i = 0; i + 1 < corners_.size(); ++i) corners_[i].edge = corners_[i + 1].edge;
      corners_.back().edge = first;
    }
    const auto fore = std::min_element(corners_.begin(), corners_.end(), [](auto& a, auto& b) {
      return a.deep != b.deep ? a.deep < b.deep : a.across < b.across;
    });
    std::rotate(corners_.begin(), fore, corners_.end());
    corners_.push_back(corners_.front());
  }

  /// Divides the border into fore edge, outer side, aft edge and inner side.
  void divide() {
    const double begin = corners_.front().deep;
    double end = begin;
    for (const auto& c : corners_) end = std::max(end, c.deep);
    panel_.depth = end - begin;
    std::size_t i = 0;
    const auto is_along = [&](double deep) {
      return i + 1 < corners_.size() && corners_[i].deep == deep && corners_[i + 1].deep == deep;
    };
    for (; is_along(begin); ++i) add_count(panel_.fore, i, 1);
    for (; i + 1 < corners_.size() && corners_[i].deep < end; ++i) add_cut(panel_.outer, i, 1);
    for (; is_along(end); ++i) add_count(panel_.aft, i, -1);
    for (; i + 1 < corners_.size(); ++i) add_cut(panel_.inner, i, -1);
    std::reverse(panel_.aft.begin(), panel_.aft.end());
    std::reverse(panel_.inner.begin(), panel_.inner.end());
    if (panel_.stands == Standing::middle) leave_out_middle();
  }

  void add_count(std::vector<MeshCount>& edge, std::size_t i, double outwards) {
    const double meshes = outwards * (corners_[i + 1].across - corners_[i].across);
    if (meshes <= 0)
      return fail("go back along the fore or the aft edge", "give them in a row round the panel");
    edge.push_back({corners_[i].edge, meshes, table_.place("corners")});
  }

  void add_cut(std::vector<Cut>& side, std::size_t i, double aft) {
    const double deep = aft * (corners_[i + 1].deep - corners_[i].deep),
                 across = aft * (corners_[i + 1].across - corners_[i].across);
    if (deep < 0)
      return fail(fmt::format("turn back at [{:g}, {:g}]", corners_[i].across, corners_[i].deep),
                  "sides go from the fore to the aft end; divide the panel there and join the pieces");
    const double outwards = side_sign(side) * across;
    Cut cut;
    cut.name = corners_[i].edge;
    cut.place = table_.place("corners");
    cut.goes = outwards > 0 ? 1 : outwards < 0 ? -1 : 0;
    cut.said_across = cut.across = std::abs(across);
    cut.said_deep = cut.deep = deep;
    side.push_back(std::move(cut));
  }

  /// Returns 1 for the outer side, which goes outwards where the panel becomes wider; -1 for the inner side.
  double side_sign(const std::vector<Cut>& side) const { return &side == &panel_.outer ? 1 : -1; }

  /// Removes the middle line of a middle panel. The corners of such a panel enclose one half only, and the
  /// middle line is not an edge.
  void leave_out_middle() {
    const bool is_straight = panel_.inner.size() == 1 && panel_.inner[0].across == 0;
    const bool is_on_middle = std::abs(corners_.front().across) < kSame;
    if (!is_on_middle || (!is_straight && !panel_.inner.empty()))
      return fail(
          "do not begin and end in the middle",
          "give the starboard half of a panel in the middle, from [0, …] to [0, …], or stands = \"pair\"");
    panel_.inner.clear();
    for (auto* edge : {&panel_.fore, &panel_.aft})
      if (!edge->empty()) edge->front().meshes *= 2;  // the first count is for both halves
  }

  void name_sides() {
    name_all(panel_.fore, "fore");
    name_all(panel_.aft, "aft");
    name_all(panel_.outer, panel_.stands == Standing::middle ? "sides" : "outer");
    name_all(panel_.inner, "inner");
    if (panel_.fore.empty()) panel_.fore = {{"fore", 0, table_.place("corners")}};
    if (panel_.aft.empty()) panel_.aft = {{"aft", 0, table_.place("corners")}};
    panel_.states_aft = true;
    panel_.aft_place = table_.place("corners");
  }

  template <class Edge>
  static void name_all(std::vector<Edge>& edges, const std::string& name) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (edges[i].name.empty())
        edges[i].name = edges.size() == 1 ? name : name + "-" + std::to_string(i + 1);
  }

  Panel& panel_;
  formats::TableReader& table_;
  std::vector<Corner> corners_;  // after turn_to_fore(), the first corner is repeated at the end
  bool has_failed_ = false;
};

}  // namespace

void read_corners(Panel& panel, formats::TableReader& table) { CornerReader(panel, table).read(); }

}  // namespace netloft::gears
