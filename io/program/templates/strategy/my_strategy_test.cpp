// SPDX-License-Identifier: BSD-3-Clause
//
// Runs a scene with a known solution: a spring of 100 N/m pulled by 1 N. Its solver converges only from an
// initial guess of at least 1/20 of the solution, or if the spring has at most 0.1 N/m. This file takes the
// place of the host.
#include "my_strategy.cpp"

#include <cmath>
#include <cstdio>

namespace {

int stages = 0;
double answer = 0;

uint32_t size_of(void*, uint32_t) { return 1; }
double work_left(void*) { return 1000; }
int solve(void*, netloft_stage* stage) {
  ++stages;
  const double cap = stage->variant.stiffness_cap, end = 1 / (cap > 0 ? std::fmin(cap, 100) : 100);
  const bool converges = *stage->u >= end / 20 || end > 9.9;
  if (converges) *stage->u = end;
  stage->ending = converges ? NETLOFT_ENDED_CONVERGED : NETLOFT_ENDED_NOT_CONVERGED;
  return NETLOFT_OK;
}
int take_answer(void*, const double* u) {
  answer = *u;
  return NETLOFT_OK;
}

}  // namespace

int main() {
  netloft_search s{};
  s.size = sizeof s;
  s.unknowns = s.levels = 1;
  s.stiffness = 100;
  s.size_of = size_of;
  s.work_left = work_left;
  s.solve = solve;
  s.answer = take_answer;
  netloft::Search search(s);
  MyStrategy::run(MyStrategy::Parameters{.softest = 1e-3, .factor = 10}, search);
  const double by_hand = 0.01;  // 1 N over 100 N/m; solved directly, then with 0.1, 1, 10 and 100 N/m
  std::printf("ends at %g m after %d stages; by hand %g m after 5\n", answer, stages, by_hand);
  return std::fabs(answer - by_hand) < 1e-12 && stages == 5 ? 0 : 1;
}
