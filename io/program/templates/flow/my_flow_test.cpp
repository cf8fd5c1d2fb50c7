// SPDX-License-Identifier: BSD-3-Clause
//
// Compares one value with a calculation by hand, because `netloft test` cannot know which formula you meant.
#include "my_flow.cpp"

#include <cstdio>

int main() {
  netloft::MovingNodes<double, 3> m;  // an upright bar of 2 m, 3 m from the middle, in 2 m/s
  m.x = {{{0, 3, -5}, {0, 3, -3}, {0.1, 0, 0}}};
  m.current[0] = m.current[1] = {2, 0, 0};
  m.water.density = 1000;
  const double equation = -MyFlow::Thrust::force({}, {}, m)[2].x;
  const double by_hand = 9600;  // 4 x 0.1 x 1000/2 x 2² x 2 m/s x 6 m²
  std::printf("equation %g, by hand %g\n", equation, by_hand);
  return std::abs(equation - by_hand) < 1e-9 ? 0 : 1;
}
