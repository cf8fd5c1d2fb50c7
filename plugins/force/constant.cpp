// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/force/constant.hpp"

namespace netloft::forces {

void Constant::check(const Parameters&, const Data& d) {
  if (!(d.pieces >= 0)) throw std::invalid_argument("the number of forces at a node must not be negative");
}

Status Constant::Pull::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const Vec3<double> pull = d.pieces * Vec3<double>{p.x, p.y, p.z};
  out.energy = -dot(pull, s.x[0]);  // (1)
  out.force[0] = -1.0 * pull;
  return Status::ok;
}

}  // namespace netloft::forces
