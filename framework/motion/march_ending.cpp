// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/march_ending.hpp"

#include <cmath>
#include <cstdio>

namespace netloft {

const char* name_of(MarchStatus status) {
  switch (status) {
    case MarchStatus::finished:
      return "finished";
    case MarchStatus::interrupted:
      return "interrupted";
    default:
      return "not finished";
  }
}

std::string seconds_text(double t) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", t);
  return text;
}

std::string fastest_node(const AssembledScene& of, std::span<const double> v) {
  const auto node = [&](std::size_t i) { return of.assembler.numbering().node(Dof(i)); };
  double fastest = 0;
  std::uint32_t which = 0;
  for (std::size_t i = 0; i < v.size();) {
    const std::uint32_t at = node(i);
    double sum = 0;
    for (; i < v.size() && node(i) == at; ++i) sum += v[i] * v[i];
    if (!(sum <= fastest)) {
      fastest = sum;
      which = at;
    }
  }
  char speed[32];
  std::snprintf(speed, sizeof speed, "%.3g m/s", std::sqrt(fastest));
  return of.assembler.node_name(of.scene, which) + " moves at " + speed;
}

}  // namespace netloft
