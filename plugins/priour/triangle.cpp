// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/triangle.hpp"

#include "plugins/common/loss.hpp"
#include "plugins/priour/twines.hpp"

#include <limits>
#include <numbers>

namespace netloft::priour {

namespace {

/// Returns Σ c_p x_p from differences of positions, because Σ c_p = 0.
Vec3<double> combine(const double (&c)[3], const State<3>& s) {
  return c[1] * s.between(0, 1) + c[2] * s.between(0, 2);
}

}  // namespace

Triangle::Shape Triangle::shape(const Data& d) {
  const double twice = determinant(d.u, d.v), i = 1 / twice;
  return {{(d.v[1] - d.v[2]) * i, (d.v[2] - d.v[0]) * i, (d.v[0] - d.v[1]) * i},  // (2)
          {(d.u[2] - d.u[1]) * i, (d.u[0] - d.u[2]) * i, (d.u[1] - d.u[0]) * i},  // (3)
          std::abs(twice) / 2};
}

double Triangle::twine_volume(const Parameters& p, const Data& d) {
  return 2 * bars(p, d) * std::numbers::pi / 4 * p.diameter * p.diameter * d.bar_length;
}

double Triangle::twine_area(const Parameters& p, const Data& d) {
  return 2 * bars(p, d) * d.bar_length * p.diameter;
}

double Triangle::opening_stiffness(const Parameters& p, const Data& d) {
  return p.opening_stiffness + 12 * p.EI / d.bar_length;
}

double Triangle::touching_cosine(const Parameters& p, const Data& d) {
  const double t = p.knot_size / (2 * d.bar_length), square = t * t;  // tan α_k
  return (1 - square) / (1 + square);
}

namespace {

void check_twines(const Triangle::Parameters& p, const Triangle::Data& d) {
  if (p.EI > 0 && p.opening_stiffness > 0)
    throw std::invalid_argument(
        "twine.EI and twine.opening_stiffness both say how the meshes resist opening (the first as 12 EI "
        "over "
        "the bar): give one of them");
  if (p.knot_size >= 2 * d.bar_length)
    throw std::invalid_argument(
        "twine.knot_size leaves no mesh between knots: it must be below the length of two bars");
}

}  // namespace

void Triangle::check(const Parameters& p, const Data& d) {
  if (!(d.bar_length > 0)) throw std::invalid_argument("a bar length of zero leaves no netting");
  check_twines(p, d);
  const double across = std::abs(d.u[1] - d.u[0]) + std::abs(d.v[1] - d.v[0]);
  const double along = std::abs(d.u[2] - d.u[0]) + std::abs(d.v[2] - d.v[0]);
  if (!(std::abs(determinant(d.u, d.v)) > 1e-14 * across * along))
    throw std::invalid_argument("a triangle whose corners lie on one line of meshes holds no netting");
}

void Triangle::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  const Shape s = shape(d);
  for (std::size_t k = 0; k < 3; ++k) {
    lanes.a[k][lane] = s.a[k];
    lanes.b[k][lane] = s.b[k];
  }
  lanes.bars[lane] = bars(p, d);
  lanes.l0[lane] = d.bar_length;
  lanes.EA[lane] = p.EA;
  lanes.EA_compression[lane] = p.EA_compression;
  lanes.volume[lane] = twine_volume(p, d);
  lanes.density[lane] = p.density;
  lanes.diameter[lane] = p.diameter;
  lanes.damping[lane] = p.damping;
  lanes.loss[lane] = axial::loss_of(p.EA, p.loss_factor, p.loss_frequency);
  lanes.added_mass[lane] = p.added_mass;
  lanes.surface[lane] = p.surface;
  lanes.H[lane] = p.opening_stiffness;
  lanes.H_of_EI[lane] = 12 * p.EI / d.bar_length;
  lanes.alpha0[lane] = p.opening_angle;
  lanes.touching[lane] = touching_cosine(p, d);
  lanes.slowed_by[lane] = p.slowed_by;
  lanes.slowed_front[lane] = p.slowed_front;
  lanes.slowed_radius[lane] = p.slowed_radius;
  lanes.slowed_x[lane] = std::cos(p.slowed_direction);
  lanes.slowed_y[lane] = std::sin(p.slowed_direction);
  lanes.slows |= p.slowed_by > 0;
}

axial::Bar Triangle::stretch(int direction, const Parameters& p, const Data& d, const State<3>& s) {
  const Shape h = shape(d);
  const Vec3<double> w = combine(direction == 0 ? h.a : h.b, s);
  return axial::stretch(w.x, w.y, w.z, d.bar_length, p.EA, p.EA_compression);
}

std::array<Member, 2> Triangle::members(const Parameters& p, const Data& d, double) {
  const Shape h = shape(d);
  const auto member = [&](const double(&c)[3]) -> Member {
    return {{c[0], c[1], c[2]}, d.bar_length, p.EA, p.EA_compression, bars(p, d)};
  };
  return {member(h.a), member(h.b)};
}

double Triangle::half_angle(const Data& d, const State<3>& s) {
  const Shape h = shape(d);
  const Vec3<double> U = combine(h.a, s), V = combine(h.b, s);
  return 0.5 * std::atan2(norm(cross(U, V)), dot(U, V));
}

namespace {

/// Stiffness A of axial.hpp (4) times the number of bars of one direction: six numbers per element.
struct Blocks {
  double v[6][kLanes];
};

/// The bars of one direction of every element: their vectors, and the scalars of axial.hpp (1)–(4).
struct Stretched {
  double w[3][kLanes];
  double inverse[kLanes], T[kLanes], k[kLanes], energy[kLanes];
};

/// Each loop over the elements (lanes) does one thing only, so that compilers vectorise it.
void stretch_direction(const Triangle::Lanes& p, const double (&c)[3][kLanes], const netloft_tile& t,
                       Stretched& __restrict s) {
  find_spans(t, c, s.w);
  for (std::size_t i = 0; i < t.count; ++i) {
    const auto b = axial::stretch(s.w[0][i], s.w[1][i], s.w[2][i], p.l0[i], p.EA[i], p.EA_compression[i]);
    s.inverse[i] = b.inverse;
    s.T[i] = b.T;
    s.k[i] = b.k;
    s.energy[i] = b.energy;
  }
}

/// Adds the residual (5) of triangle.hpp for the bars of one direction: r_p += n c_p T t.
void add_force(const Triangle::Lanes& p, const double (&c)[3][kLanes], const Stretched& s,
               std::uint32_t count, double* __restrict force) {
  for (std::size_t i = 0; i < count; ++i) {
    const double f = p.bars[i] * s.T[i] * s.inverse[i];
    const double fx = f * s.w[0][i], fy = f * s.w[1][i], fz = f * s.w[2][i];
    force[at(0, i)] += c[0][i] * fx, force[at(1, i)] += c[0][i] * fy, force[at(2, i)] += c[0][i] * fz;
    force[at(3, i)] += c[1][i] * fx, force[at(4, i)] += c[1][i] * fy, force[at(5, i)] += c[1][i] * fz;
    force[at(6, i)] += c[2][i] * fx, force[at(7, i)] += c[2][i] * fy, force[at(8, i)] += c[2][i] * fz;
  }
}

void fill_stiffness(const Triangle::Lanes& p, const Stretched& s, double cu, bool convex, std::uint32_t count,
                    Blocks& __restrict blocks) {
  const double lowest = convex ? 0.0 : -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const axial::Bar b{0, s.inverse[i], s.T[i], s.k[i], 0};
    const auto A = axial::stiffness(b, s.w[0][i], s.w[1][i], s.w[2][i], cu * p.bars[i], lowest);
    for (int k = 0; k < 6; ++k) blocks.v[k][i] = A.v[k];
  }
}

/// Adds block (P, Q) of the tangent (6) of triangle.hpp, a_p a_q A_U + b_p b_q A_V, to the packed lower
/// triangle.
template <int P, int Q>
void add_block(const Triangle::Lanes& p, const Blocks& U, const Blocks& V, std::uint32_t count,
               double* __restrict tangent) {
  for (std::size_t i = 0; i < count; ++i) {
    const double aa = p.a[P][i] * p.a[Q][i], bb = p.b[P][i] * p.b[Q][i];
    double k[6];
    for (int m = 0; m < 6; ++m) k[m] = aa * U.v[m][i] + bb * V.v[m][i];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < (P == Q ? r + 1 : 3); ++c) {
        constexpr int row = 3 * P, column = 3 * Q;
        const int entry = (row + r) * (row + r + 1) / 2 + column + c;
        tangent[at(entry, i)] += k[axial::kPlace[r][c]];
      }
  }
}

void add_blocks(const Triangle::Lanes& p, const Blocks& U, const Blocks& V, std::uint32_t count,
                double* tangent) {
  add_block<0, 0>(p, U, V, count, tangent);
  add_block<1, 0>(p, U, V, count, tangent);
  add_block<1, 1>(p, U, V, count, tangent);
  add_block<2, 0>(p, U, V, count, tangent);
  add_block<2, 1>(p, U, V, count, tangent);
  add_block<2, 2>(p, U, V, count, tangent);
}

void fill_metric(const Triangle::Lanes& p, std::uint32_t count, Blocks& blocks) {
  for (std::size_t i = 0; i < count; ++i) {
    const double m = p.bars[i] * std::max(p.EA[i], p.EA_compression[i]) / p.l0[i];  // bound by axial (6)
    for (int k = 0; k < 6; ++k) blocks.v[k][i] = k == 0 || k == 2 || k == 5 ? m : 0;
  }
}

}  // namespace

Status Triangle::Elastic::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  Blocks U, V;
  if (t.want & NETLOFT_WANT_METRIC) {
    fill_metric(p, t.count, U);
    add_blocks(p, U, U, t.count, t.tangent);
    return Status::ok;
  }
  Stretched u, v;
  stretch_direction(p, p.a, t, u);
  stretch_direction(p, p.b, t, v);
  if (t.energy)
    for (std::size_t i = 0; i < t.count; ++i) t.energy[i] += p.bars[i] * (u.energy[i] + v.energy[i]);  // (4)
  if (t.force) {
    add_force(p, p.a, u, t.count, t.force);
    add_force(p, p.b, v, t.count, t.force);
  }
  if (t.tangent) {
    const bool convex = t.want & NETLOFT_WANT_CONVEX;
    fill_stiffness(p, u, t.cu, convex, t.count, U);
    fill_stiffness(p, v, t.cu, convex, t.count, V);
    add_blocks(p, U, V, t.count, t.tangent);
  }
  return Status::ok;
}

Status Triangle::Weight::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  for (std::size_t i = 0; i < t.count; ++i) {
    const double third = p.volume[i] * (p.density[i] - t.water_density) * t.gravity / 3;  // (7)
    if (t.energy) t.energy[i] += third * (t.x[at(2, i)] + t.x[at(5, i)] + t.x[at(8, i)]);
    if (t.force)
      for (int corner = 0; corner < 3; ++corner) t.force[at(3 * corner + 2, i)] += third;
  }
  return Status::ok;
}

}  // namespace netloft::priour
