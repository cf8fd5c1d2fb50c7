// SPDX-License-Identifier: BSD-3-Clause
//
// Compares one value with a calculation by hand, because `netloft test` cannot know which formula you meant.
#include "my_law.cpp"

#include <cstdio>

int main() {
  netloft::Flow<double> f;
  f.flow = {3, 0, 4};
  f.direction = {0, 0, 1};
  f.diameter = 0.02;
  f.density = 1000;
  const double force = MyLaw::force(MyLaw::Parameters{.coefficient = 1}, f).x;
  const double by_hand = 90;  // only 3 m/s go across: 1000/2 x 1 x 0.02 x 3²
  std::printf("force %g N/m, by hand %g N/m\n", force, by_hand);
  return std::abs(force - by_hand) < 1e-9 ? 0 : 1;
}
