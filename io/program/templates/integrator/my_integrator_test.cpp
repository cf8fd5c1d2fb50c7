// SPDX-License-Identifier: BSD-3-Clause
//
// Compares one step with a calculation by hand: 1 kg on a spring of 1 N/m, released at 1 m, h = 1 s. This
// file takes the place of the host, the program that calls the plugin.
#include "my_integrator.cpp"

#include <cmath>
#include <cstdio>

namespace {

double vectors[8][1];
double* scratch(void*, std::uint32_t index) { return vectors[index]; }

/// Solves F = a + u = 0 for u, with a = a0 + ca u.
int solve(void*, double, const double*, double, const double* a0, double ca, double* u) {
  u[0] = -a0[0] / (ca + 1);
  return NETLOFT_OK;
}

}  // namespace

int main() {
  const double u[1] = {1}, v[1] = {0}, a[1] = {-1};
  double u1[1], v1[1], a1[1], error[1];
  netloft_motion m{};
  m.size = sizeof m;
  m.unknowns = 1;
  m.t = 0;
  m.h = 1;
  m.u = u;
  m.v = v;
  m.a = a;
  m.u_new = u1;
  m.v_new = v1;
  m.a_new = a1;
  m.error = error;
  m.solve = solve;
  m.scratch = scratch;
  netloft::Motion motion(m);
  MyIntegrator::step(MyIntegrator::Parameters{.damping = 0}, motion);
  const double by_hand[3] = {0.6, -0.8, -0.6};  // u₁ = 0.75/1.25, v₁ = -(1 + 0.6)/2, a₁ = -u₁
  std::printf("arrives at %g, %g, %g; by hand %g, %g, %g\n", u1[0], v1[0], a1[0], by_hand[0], by_hand[1],
              by_hand[2]);
  return std::abs(u1[0] - by_hand[0]) + std::abs(v1[0] - by_hand[1]) + std::abs(a1[0] - by_hand[2]) < 1e-12
             ? 0
             : 1;
}
