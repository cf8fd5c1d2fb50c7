// SPDX-License-Identifier: BSD-3-Clause
//
// Compares one value with a calculation by hand, because `netloft test` cannot know which formula you meant.
#include "my_element.cpp"

#include <cstdio>

int main() {
  const MyElement::Parameters p{.k = 100, .c = 100};
  const MyElement::Data d{.rest_length = 2};
  const netloft::Points<double, 2> x = {{{0, 0, 0}, {0, 0, -3}}};
  const double energy = MyElement::Elastic::energy(p, d, netloft::Water{}, x);
  const double by_hand = 75;  // stretched by 1 m: 100/2 + 100/4
  std::printf("energy %g J, by hand %g J\n", energy, by_hand);
  return std::abs(energy - by_hand) < 1e-12 ? 0 : 1;
}
