// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/changed_water.hpp"

#include "framework/assembler/lanes.hpp"

#include <netloft/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace netloft {

namespace {

constexpr std::size_t kMostCorners = 4, kRowsOfElement = 3 * kMostCorners;

/// Adds a factor times the product of two rows, each of 64 numbers.
void add_product(double* to, double factor, const double* a, const double* b, std::size_t count) {
  for (std::size_t lane = 0; lane < count; ++lane) to[lane] += factor * a[lane] * b[lane];
}

/// Multiplies 3 x 3 matrices by vectors, one pair per lane. Row 3r + c has entry (r, c) of the matrices, row
/// c the component c of the vectors.
void multiply(const double* matrix, const double* vector, std::size_t count, double* to) {
  std::fill_n(to, 3 * kTileLanes, 0.0);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      add_product(to + r * kTileLanes, 1, matrix + (3 * r + c) * kTileLanes, vector + c * kTileLanes, count);
}

/// Whether two vectors are equal for each of the elements.
bool are_equal(const double* a, const double* b, std::size_t count) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!std::equal(a + axis * kTileLanes, a + axis * kTileLanes + count, b + axis * kTileLanes))
      return false;
  return true;
}

}  // namespace

bool is_in_changed_water(const FamilyPlan& family, const TermPlan& term) {
  return family.flow && sees_changed_water(term.traits);
}

/// The normals (6) of the triangles of a tile. Rows of `edge` and `cross` have a component of a vector for
/// each element.
struct ChangedWater::Normals {
  explicit Normals(const netloft_tile& t) {
    // ε of (6). With 3e-4 and with 3e-2, drag, height and spread of a trawl differ by less than 4e-4.
    constexpr double kFlat = 0.003;
    const auto at = [&](std::size_t corner, std::size_t axis, std::size_t lane) {
      return t.x[(3 * (corner % 3) + axis) * kTileLanes + lane];
    };
    for (std::size_t lane = 0; lane < t.count; ++lane) {
      double squares = 0;
      for (std::size_t q = 0; q < 3; ++q)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          edge[q][axis][lane] = at(q + 2, axis, lane) - at(q + 1, axis, lane);
          squares += edge[q][axis][lane] * edge[q][axis][lane];
        }
      double product = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
        across[axis][lane] = edge[1][b][lane] * edge[2][c][lane] - edge[1][c][lane] * edge[2][b][lane];
        product += across[axis][lane] * across[axis][lane];
      }
      flat[lane] = kFlat * kFlat * squares;
      const double length = std::sqrt(product + flat[lane] * squares);
      inverse[lane] = length > 0 ? 1 / length : 0;
    }
  }
  void write_units(std::size_t count, double* to) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t lane = 0; lane < count; ++lane)
        to[axis * kTileLanes + lane] = inverse[lane] * across[axis][lane];  // (6)
  }
  void add_turn(double (&v)[3][kTileLanes], std::size_t count, double* by_x) const;

  double edge[3][3][kTileLanes], across[3][kTileLanes];  // e_q, N
  double inverse[kTileLanes], flat[kTileLanes];          // 1/D, ε² E
};

/// The changed water at the corners of the elements of a tile. Row 3 corner + axis of an array has 64
/// numbers, one per element.
struct ChangedWater::Places {
  double velocity[kRowsOfElement * kTileLanes], velocity_dz[kRowsOfElement * kTileLanes];
  double by_unknown[3][kRowsOfElement * kTileLanes], weight[3][kRowsOfElement * kTileLanes];
  double weight_dz[3][kRowsOfElement * kTileLanes];  // ∂g/∂U ∂U/∂z
  double by_normal[kMostCorners][9 * kTileLanes];    // ∂w/∂n
};

/// ∂r/∂x, multiplied by the factor cu of the tile, and ∂r/∂v: square matrices whose entries are rows of 64
/// numbers.
struct ChangedWater::Tangents {
  double by_x[kRowsOfElement * kRowsOfElement * kTileLanes],
      by_v[kRowsOfElement * kRowsOfElement * kTileLanes];
};

ChangedWater::ChangedWater(const Scene& scene, const FamilyPlan& plan, const ElementFamily& base,
                           const ElementFamily& flow)
    : base_(base),
      flow_(flow),
      type_(base.type()),
      corners_(static_cast<std::size_t>(base.nodes_per_element())),
      unknowns_(flow.type().globals.size()) {
  std::erase_if(type_.terms, [&](const netloft_term& term) {
    return std::ranges::none_of(plan.terms, [&](const TermPlan& t) {
      return t.on && t.name == term.name && is_in_changed_water(plan, t);
    });
  });
  type_.parameters.clear();
  type_.data.clear();
  type_.outputs.clear();
  type_.laws.clear();
  type_.members = {};
  type_.state_width = 0;
  type_.rides_on = nullptr;
  type_.globals = flow.type().globals;
  const auto part = std::ranges::find(flow.parts(), *plan.flow);
  flow_part_ = static_cast<std::uint32_t>(part - flow.parts().begin());
  for (const std::uint32_t p : base.parts())
    reach_.insert(reach_.end(), scene.parts[p].reach.begin(), scene.parts[p].reach.end());
  assert(reach_.size() == base.size() && "one reach per element");
}

std::uint32_t ChangedWater::node() const { return flow_.global_nodes()[flow_part_].node; }

bool ChangedWater::is_netting() const { return type_.element.stencil == NETLOFT_TRIANGLE; }

/// Computes (1) at all corners.
int ChangedWater::find_places(const netloft_tile& t, Places& w) const {
  double normal[3 * kTileLanes] = {};
  if (is_netting()) Normals(t).write_units(t.count, normal);
  double d_current[9 * kTileLanes], d_unknown[9 * kTileLanes], weight[9 * kTileLanes],
      d_weight[27 * kTileLanes];
  netloft_flow_tile f{};
  f.size = sizeof f, f.count = t.count, f.part = flow_part_;
  f.unknowns = t.x + 3 * static_cast<std::size_t>(base_.all_nodes_per_element()) * kTileLanes;
  f.reach = &reach_[t.first];
  f.weight = weight, f.normal = normal;
  if (t.tangent)
    f.d_current = d_current, f.d_unknown = d_unknown, f.d_weight = d_weight;
  else
    std::fill(std::begin(w.velocity_dz), std::end(w.velocity_dz), 0.0);
  for (std::size_t corner = 0; corner < corners_; ++corner) {
    const std::size_t first = 3 * corner * kTileLanes;
    const double* dz = t.current_dz + first;
    f.current = t.current + first;
    f.velocity = w.velocity + first;
    if (t.tangent) f.d_normal = w.by_normal[corner];
    if (corner > 0 && are_equal(f.current, f.current - 3 * kTileLanes, t.count)) {  // as at the last corner
      std::copy_n(f.velocity - 3 * kTileLanes, 3 * kTileLanes, f.velocity);
      if (t.tangent) std::copy_n(w.by_normal[corner - 1], 9 * kTileLanes, w.by_normal[corner]);
    } else if (const int status = flow_.find_water(f); status != NETLOFT_OK) {
      return status;
    }
    for (std::size_t k = 0; k < unknowns_; ++k)
      std::copy_n(weight + 3 * k * kTileLanes, 3 * kTileLanes, w.weight[k] + first);
    if (!t.tangent) continue;
    multiply(d_current, dz, t.count, w.velocity_dz + first);
    for (std::size_t k = 0; k < unknowns_; ++k) {
      std::copy_n(d_unknown + 3 * k * kTileLanes, 3 * kTileLanes, w.by_unknown[k] + first);
      multiply(d_weight + 9 * k * kTileLanes, dz, t.count, w.weight_dz[k] + first);
    }
  }
  return NETLOFT_OK;
}

int ChangedWater::evaluate(const netloft_term& term, netloft_tile& t) const {
  Places places;
  if (const int status = find_places(t, places); status != NETLOFT_OK) return status;
  Tangents tangents;
  double force[kRowsOfElement * kTileLanes] = {};
  netloft_tile inner = t;
  inner.current = places.velocity;
  inner.current_dz = places.velocity_dz;
  const auto evaluate = [&](double cu, double cv, double* to_force, double* to_tangent) {
    inner.cu = cu;
    inner.cv = cv;
    inner.ca = 0;
    inner.force = to_force;
    inner.tangent = to_tangent;
    inner.want = (to_force ? NETLOFT_WANT_FORCE : 0) | (to_tangent ? NETLOFT_WANT_TANGENT : 0);
    if (to_tangent) std::fill_n(to_tangent, 9 * corners_ * corners_ * kTileLanes, 0.0);
    const int status = base_.evaluate(term, inner);
    t.lane_at_fault = inner.lane_at_fault;
    return status;
  };
  if (const int status = evaluate(t.cu, 0, force, t.tangent ? tangents.by_x : nullptr); status != NETLOFT_OK)
    return status;
  if (t.force) add_forces(t, places, force);
  if (!t.tangent) return NETLOFT_OK;
  if (const int status = evaluate(0, 1, nullptr, tangents.by_v); status != NETLOFT_OK) return status;
  if (is_netting()) turn_with_netting(t, places, tangents);
  add_tangents(t, places, tangents);
  add_equations(t, places, tangents, force);
  return NETLOFT_OK;
}

int ChangedWater::output(netloft_tile& t, double* values) const {
  Places places;
  if (const int status = find_places(t, places); status != NETLOFT_OK) return status;
  netloft_tile inner = t;
  inner.current = places.velocity;
  inner.current_dz = places.velocity_dz;
  return base_.output(inner, values);
}

/// Adds (7) to one row of ∂r/∂x, from v, the same row of −∂r/∂v ∂w/∂n. Overwrites v.
void ChangedWater::Normals::add_turn(double (&v)[3][kTileLanes], std::size_t count, double* by_x) const {
  double along[kTileLanes];  // 2 (v·N) ε² E/D³
  for (std::size_t lane = 0; lane < count; ++lane) {
    const double s = inverse[lane];
    const double product =
        (v[0][lane] * across[0][lane] + v[1][lane] * across[1][lane] + v[2][lane] * across[2][lane]) * s * s *
        s;
    for (std::size_t axis = 0; axis < 3; ++axis)  // v becomes h
      v[axis][lane] = s * v[axis][lane] - product * across[axis][lane];
    along[lane] = 2 * product * flat[lane];
  }
  for (std::size_t q = 0; q < 3; ++q)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
      const double *eb = edge[q][b], *ec = edge[q][c], *next = edge[(q + 1) % 3][axis],
                   *last = edge[(q + 2) % 3][axis], *vb = v[b], *vc = v[c];
      double* row = by_x + (3 * q + axis) * kTileLanes;
      for (std::size_t lane = 0; lane < count; ++lane)  // (8)
        row[lane] += vb[lane] * ec[lane] - vc[lane] * eb[lane] - along[lane] * (next[lane] - last[lane]);
    }
}

/// Adds (7) for all rows.
void ChangedWater::turn_with_netting(const netloft_tile& t, const Places& w, Tangents& tangents) const {
  const Normals normals(t);
  const std::size_t rows = 3 * corners_;
  for (std::size_t r = 0; r < rows; ++r) {
    double v[3][kTileLanes] = {};
    for (std::size_t c = 0; c < rows; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis)
        add_product(v[axis], -t.cu, tangents.by_v + (r * rows + c) * kTileLanes,
                    w.by_normal[c / 3] + (3 * (c % 3) + axis) * kTileLanes, t.count);
    normals.add_turn(v, t.count, tangents.by_x + r * rows * kTileLanes);
  }
}

/// Adds the residual of the elements, and (2).
void ChangedWater::add_forces(const netloft_tile& t, const Places& w, const double* force) const {
  double* equations = t.force + static_cast<std::size_t>(type_.dofs() - 3) * kTileLanes;
  for (std::size_t r = 0; r < 3 * corners_; ++r) {
    const double* of_row = force + r * kTileLanes;
    for (std::size_t lane = 0; lane < t.count; ++lane) t.force[r * kTileLanes + lane] += of_row[lane];
    for (std::size_t k = 0; k < unknowns_; ++k)
      add_product(equations + k * kTileLanes, 1, w.weight[k] + r * kTileLanes, of_row, t.count);
  }
}

/// Adds the tangent of the elements, and (4).
void ChangedWater::add_tangents(const netloft_tile& t, const Places& w, const Tangents& tangents) const {
  const std::size_t rows = 3 * corners_, dofs = static_cast<std::size_t>(type_.dofs());
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < rows; ++c) {
      const double *x = tangents.by_x + (r * rows + c) * kTileLanes,
                   *v = tangents.by_v + (r * rows + c) * kTileLanes;
      double* row = t.tangent + r * dofs * kTileLanes;
      for (std::size_t lane = 0; lane < t.count; ++lane)
        row[c * kTileLanes + lane] += x[lane] + t.cv * v[lane];
      for (std::size_t k = 0; k < unknowns_; ++k)
        add_product(row + (dofs - 3 + k) * kTileLanes, -t.cu, v, w.by_unknown[k] + c * kTileLanes, t.count);
    }
}

/// Adds the rows of the flow's equations, by (5).
void ChangedWater::add_equations(const netloft_tile& t, const Places& w, const Tangents& tangents,
                                 const double* force) const {
  const std::size_t rows = 3 * corners_, dofs = static_cast<std::size_t>(type_.dofs());
  for (std::size_t k = 0; k < unknowns_; ++k) {
    double* row = t.tangent + (dofs - 3 + k) * dofs * kTileLanes;
    for (std::size_t r = 0; r < rows; ++r) {
      const double* weight = w.weight[k] + r * kTileLanes;
      add_product(row + (3 * (r / 3) + 2) * kTileLanes, t.cu, w.weight_dz[k] + r * kTileLanes,
                  force + r * kTileLanes, t.count);
      for (std::size_t c = 0; c < rows; ++c) {
        const double* v = tangents.by_v + (r * rows + c) * kTileLanes;
        add_product(row + c * kTileLanes, 1, weight, tangents.by_x + (r * rows + c) * kTileLanes, t.count);
        for (std::size_t l = 0; l < unknowns_; ++l)
          for (std::size_t lane = 0; lane < t.count; ++lane)
            row[(dofs - 3 + l) * kTileLanes + lane] -=
                t.cu * weight[lane] * v[lane] * w.by_unknown[l][c * kTileLanes + lane];
      }
    }
  }
}

}  // namespace netloft
