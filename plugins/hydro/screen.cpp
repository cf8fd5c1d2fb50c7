// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/screen.hpp"

namespace netloft::hydro {

namespace {

constexpr double kStill = 1e-150;  // speed below which u² is zero [m/s]

/// The factors α and λ of (3) in screen.hpp and their derivatives with respect to c, S and Re.
struct Shape {
  double alpha, alpha_c, alpha_S, alpha_Re, lambda, lambda_c, lambda_S, lambda_Re;
};

template <class Model>
Shape shape(const typename Model::Parameters& p, double c, double S, double Re) {
  using Three = Dual<3, 1>;
  const auto at = scaled<Model>(p, Three::variable(c, 0), Three::variable(S, 1), Three::variable(Re, 2));
  const double l = at.lift.value;
  const auto &D = at.drag.gradient, &L = at.lift.gradient;
  return {at.drag.value - l * c * c,
          D[0] - L[0] * c * c - 2 * l * c,
          D[1] - L[1] * c * c,
          D[2] - L[2] * c * c,
          l,
          L[0],
          L[1],
          L[2]};
}

Vec3<double> row(const double* a, std::size_t i) { return {a[i], a[kLanes + i], a[2 * kLanes + i]}; }

/// The incidence of a flow on a screen, by (1) of screen.hpp.
struct Incidence {
  Incidence(double r, const Vec3<double>& flow, const Vec3<double>& normal)
      : U(r * flow), sign(dot(U, normal) < 0 ? -1 : 1), n(sign * normal), u(norm(U)) {
    e = (1 / std::max(u, kStill)) * U;
    q = dot(U, n);
    c = dot(e, n);
  }
  Vec3<double> U;
  double sign;  // sign of the flow along the given normal
  Vec3<double> n;
  double u, q = 0, c = 0;
  Vec3<double> e{};
};

void write_derivatives(const netloft_law_tile& f, std::size_t i, const Incidence& s, const Shape& k,
                       double Re, double r, double r_S) {
  const double half = 0.5 * f.water_density;
  const Vec3<double> W = row(f.flow, i), turn = s.n - s.c * s.e;
  const Vec3<double> grad_alpha = k.alpha_c * turn + (k.alpha_Re * Re) * s.e;
  const Vec3<double> grad_lambda = k.lambda_c * turn + (k.lambda_Re * Re) * s.e;
  for (int p = 0; p < 3; ++p) {
    const auto at = static_cast<std::size_t>(3 * p);
    double sideways = 0;
    for (int m = 0; m < 3; ++m) {
      const double one = p == m ? 1 : 0;
      const double d_U =
          half * (k.alpha * (s.u * one + s.U[p] * s.e[m]) + s.U[p] * grad_alpha[m] +
                  k.lambda * s.n[p] * (s.q * s.e[m] + s.u * s.n[m]) + s.q * s.n[p] * grad_lambda[m]);  // (4)
      const double d_n = half * s.u *
                         ((k.alpha_c * s.U[p] + k.lambda_c * s.q * s.n[p]) * s.e[m] +
                          k.lambda * (s.q * one + s.n[p] * s.U[m]));  // (5)
      const auto entry = (at + static_cast<std::size_t>(m)) * kLanes + i;
      f.d_flow[entry] = r * d_U;
      f.d_direction[entry] = s.sign * d_n;
      sideways += d_U * W[m];
    }
    f.d_solidity[static_cast<std::size_t>(p) * kLanes + i] =
        half * s.u * (k.alpha_S * s.U[p] + k.lambda_S * s.q * s.n[p]) + r_S * sideways;  // (6)
  }
}

}  // namespace

template <class Model>
void Screen<Model>::lanes(const Parameters& p, const netloft_law_tile& f) {
  if (!(f.water_viscosity > 0))
    throw std::runtime_error("a screen needs a viscosity of the water above zero");
  for (std::size_t i = 0; i < f.count; ++i) {
    const auto r = flow_left(p, Dual<1, 1>::variable(f.solidity[i], 0));
    const Incidence s(r.value, row(f.flow, i), row(f.direction, i));
    const double Re = s.u * f.diameter[i] / f.water_viscosity;
    const Shape k = shape<Model>(p, s.c, f.solidity[i], Re);
    const Vec3<double> force =
        (0.5 * f.water_density * s.u) * (k.alpha * s.U + (k.lambda * s.q) * s.n);  // (3)
    for (int axis = 0; axis < 3; ++axis) f.force[static_cast<std::size_t>(axis) * kLanes + i] = force[axis];
    if (f.d_flow) write_derivatives(f, i, s, k, Re, r.value, r.gradient[0]);
  }
}

template struct Screen<LolandModel>;
template struct Screen<AarsnesModel>;
template struct Screen<KristiansenFaltinsenModel>;
template struct Screen<KnottedModel>;

}  // namespace netloft::hydro
