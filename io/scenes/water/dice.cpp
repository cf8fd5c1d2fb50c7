// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/dice.hpp"

#include <cmath>

namespace netloft::scenes {

Dice::Dice(std::string_view name, std::uint64_t number) : state_(14695981039346656037ull) {
  for (const char c : name) state_ = (state_ ^ static_cast<unsigned char>(c)) * 1099511628211ull;  // FNV-1a
  state_ ^= number * 0x9e3779b97f4a7c15ull;
}

std::uint64_t Dice::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

double Dice::uniform(double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(next() >> 11) * 0x1.0p-53);
}

double Dice::log_uniform(double lo, double hi) { return std::exp(uniform(std::log(lo), std::log(hi))); }

std::int64_t Dice::whole(std::int64_t lo, std::int64_t hi) {
  return lo + static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(hi - lo + 1));
}

}  // namespace netloft::scenes
