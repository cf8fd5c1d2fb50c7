// SPDX-License-Identifier: BSD-3-Clause
//
// Solves a problem with a known solution: two masses between three springs of 1 N/m, pulled by 1 N and 2 N.
// This file takes the place of the host, the program that calls the plugin.
#include "my_solver.cpp"

#include <cstdio>

namespace {

int evaluate(void*, std::uint32_t, const double* u, double* energy, double* r) {
  if (energy) *energy = u[0] * u[0] - u[0] * u[1] + u[1] * u[1] - u[0] - 2 * u[1];
  if (r) {
    r[0] = 2 * u[0] - u[1] - 1;
    r[1] = 2 * u[1] - u[0] - 2;
  }
  return NETLOFT_OK;
}
double diagonal = 0;  // diagonal of the matrix (2, -1; -1, 2), increased by the fraction `shift`
int factorise(void*, int, double shift) {
  diagonal = 2 * (1 + shift);
  return NETLOFT_FACTOR_OK;
}
int solve(void*, const double* b, double* x) {
  const double determinant = 0.75 * diagonal * diagonal;
  const double first = (diagonal * b[0] + diagonal / 2 * b[1]) / determinant;
  x[1] = (diagonal * b[1] + diagonal / 2 * b[0]) / determinant;
  x[0] = first;
  return NETLOFT_OK;
}
int progress(void*, const double*, double, const double* r, const char*) {
  return std::abs(r[0]) + std::abs(r[1]) < 1e-9 ? NETLOFT_ARRIVED : NETLOFT_GO_ON;
}

}  // namespace

int main() {
  double u[2] = {0, 0};
  netloft_problem p{};
  p.size = sizeof p;
  p.unknowns = 2;
  p.traits = NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC;
  p.u = u;
  p.evaluate = evaluate;
  p.factorise = factorise;
  p.solve = solve;
  p.progress = progress;
  netloft::Problem problem(p);
  MySolver::solve(MySolver::Parameters{.damping = 0.1, .overshoot = 0.5}, problem);
  const double by_hand[2] = {4.0 / 3, 5.0 / 3};  // the solution of 2 a - b = 1, 2 b - a = 2
  std::printf("ends at %g, %g; by hand %g, %g\n", u[0], u[1], by_hand[0], by_hand[1]);
  return std::abs(u[0] - by_hand[0]) + std::abs(u[1] - by_hand[1]) < 1e-8 ? 0 : 1;
}
