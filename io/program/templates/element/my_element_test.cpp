// SPDX-License-Identifier: BSD-3-Clause
//
// `netloft test` cannot know whether the formula is the one you meant. One value by hand.
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
