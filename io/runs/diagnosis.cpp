// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/diagnosis.hpp"

#include "framework/assembler/reports.hpp"
#include "framework/registry/element_outputs.hpp"

#include <fmt/format.h>
#include <netloft/vectors.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace netloft::runs {

namespace {

using Point = std::array<double, 3>;

// Fractions of the largest tension in the gear. A tension below kNone counts as zero, and so does a
// compression below kCounts.
constexpr double kNone = 1e-6, kCounts = 1e-3;
// Two neighbouring elements are folded if the angle between them exceeds this [rad].
constexpr double kFolded = std::numbers::pi * 5 / 6;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Least and largest tension in a part, and the tensions of its elements.
struct Tensions {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  std::vector<double> of_elements;  // tension of each element [N]; the smaller of two
};

/// Makes the diagnosis. Each member function `say_…` adds the sentences about one kind of fault.
class Diagnosis {
 public:
  Diagnosis(const Scene& scene, Assembler& assembler, const Solution& solution)
      : scene_(scene), assembler_(assembler), x_(solution.x) {}

  std::vector<std::string> make() {
    read_tensions();
    say_slack();
    say_pressed();
    say_folded();
    say_gone();
    return std::move(sentences_);
  }

 private:
  const std::string& name(std::uint32_t part) const { return scene_.parts[part].name; }

  Point at(std::uint32_t node) const {
    Point p{};
    for (int axis = 0; axis < 3; ++axis)
      p[static_cast<std::size_t>(axis)] = x_[assembler_.numbering().dof(node, axis).at()];
    return p;
  }

  void read_tensions() {
    for (std::size_t f = 0; f < assembler_.families().size(); ++f) {
      const ElementFamily& family = *assembler_.families()[f];
      std::vector<std::vector<double>> values;
      assembler_.reports().outputs(x_, f, values);
      for (std::size_t k = 0; k < values.size(); ++k)
        if (is_tension(family.type().outputs[k])) add_tensions(family, values[k]);
    }
    for (const auto& [part, t] : tensions_) largest_ = std::max(largest_, t.largest);
  }

  void add_tensions(const ElementFamily& family, const std::vector<double>& values) {
    std::map<std::uint32_t, std::size_t> own;
    for (std::size_t e = 0; e < values.size(); ++e) {
      if (!std::isfinite(values[e])) continue;
      Tensions& t = tensions_[family.part(e)];
      const std::size_t i = own[family.part(e)]++;
      if (t.of_elements.size() <= i) t.of_elements.resize(i + 1, std::numeric_limits<double>::infinity());
      t.of_elements[i] = std::min(t.of_elements[i], values[e]);
      t.least = std::min(t.least, values[e]);
      t.largest = std::max(t.largest, values[e]);
    }
  }

  void say_slack() {
    for (const auto& [part, t] : tensions_)
      if (t.largest <= kNone * largest_)
        sentences_.push_back(fmt::format("{} is slack: no force pulls at it", name(part)));
  }

  void say_pressed() {
    for (const auto& [part, t] : tensions_) {
      const auto pressed = std::count_if(t.of_elements.begin(), t.of_elements.end(),
                                         [&](double T) { return T < -kCounts * largest_; });
      if (pressed)
        sentences_.push_back(
            fmt::format("{} bears compression in {} of {} elements, up to {:.3g} N: perhaps only its "
                        "stiffness in compression keeps it in this place",
                        name(part), pressed, t.of_elements.size(), -t.least));
    }
  }

  void say_folded() {
    for (const auto& family : assembler_.families()) {
      if (family->repeated()) continue;
      std::map<std::uint32_t, int> folds;
      if (family->nodes_per_element() == 2) count_folds_of_ropes(*family, folds);
      if (family->nodes_per_element() == 3) count_folds_of_netting(*family, folds);
      for (const auto& [part, count] : folds)
        sentences_.push_back(fmt::format("{} is folded back on itself at {} place{}", name(part), count,
                                         count == 1 ? "" : "s"));
    }
  }

  /// Counts the places at which two neighbouring bars of a part fold back on each other.
  void count_folds_of_ropes(const ElementFamily& family, std::map<std::uint32_t, int>& folds) const {
    for (std::size_t e = 0; e + 1 < family.size(); ++e)
      if (family.part(e) == family.part(e + 1) && family.node(e, 1) == family.node(e + 1, 0)) {
        const Point a = at(family.node(e, 1)) - at(family.node(e, 0)),
                    b = at(family.node(e + 1, 1)) - at(family.node(e + 1, 0));
        if (turns_back(a, b)) ++folds[family.part(e)];
      }
  }

  /// Counts pairs of triangles with a common side and opposite normals.
  void count_folds_of_netting(const ElementFamily& family, std::map<std::uint32_t, int>& folds) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> first;
    for (std::size_t e = 0; e < family.size(); ++e)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t from = family.node(e, k), to = family.node(e, (k + 1) % 3);
        const auto [known, is_new] = first.try_emplace({std::min(from, to), std::max(from, to)}, e);
        if (!is_new && family.part(e) == family.part(known->second) &&
            turns_back(normal(family, known->second), normal(family, e)))
          ++folds[family.part(e)];
      }
  }

  Point normal(const ElementFamily& family, std::size_t e) const {
    const Point a = at(family.node(e, 0));
    return cross(at(family.node(e, 1)) - a, at(family.node(e, 2)) - a);
  }

  static bool turns_back(const Point& a, const Point& b) {
    const double lengths = norm(a) * norm(b);
    return lengths > 0 && dot(a, b) < std::cos(kFolded) * lengths;
  }

  void say_gone() {
    double size = 0, furthest = 0;
    std::uint32_t gone = 0;
    const std::vector<double>& start = scene_.positions;
    for (std::uint32_t node = 0; node < scene_.node_count(); ++node) {
      const Point from{start[3 * std::size_t{node}], start[3 * std::size_t{node} + 1],
                       start[3 * std::size_t{node} + 2]};
      size = std::max(size, norm(from - Point{start[0], start[1], start[2]}));
      const double way = norm(at(node) - from);
      if (std::isfinite(way) && way > furthest) {
        furthest = way;
        gone = node;
      }
    }
    if (furthest > 2 * size && size > 0)
      sentences_.push_back(
          fmt::format("{} went {:.3g} m away, {:.0f} times the size of the gear: is it held against the "
                      "forces that act on it?",
                      assembler_.node_name(scene_, gone), furthest, furthest / size));
  }

  const Scene& scene_;
  Assembler& assembler_;
  const std::vector<double>& x_;
  std::map<std::uint32_t, Tensions> tensions_;
  double largest_ = 0;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> diagnose(const Scene& scene, Assembler& assembler, const Solution& solution) {
  if (solution.x.empty()) return {};
  return Diagnosis(scene, assembler, solution).make();
}

}  // namespace netloft::runs
