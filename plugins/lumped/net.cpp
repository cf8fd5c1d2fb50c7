// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/lumped/net.hpp"

namespace netloft::lumped {

void Net::check(const Parameters&, const Data& d) {
  if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no stiffness");
  if (!(d.parallel > 0)) throw std::invalid_argument("a bar that represents no twine has no stiffness");
}

void Net::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  bars::pack(p, d.rest_length, d.parallel, lanes, lane);
}

axial::Bar Net::stretch(const Parameters& p, const Data& d, const State<2>& s) {
  const Vec3<double> w = s.between(0, 1);
  return axial::stretch(w.x, w.y, w.z, d.rest_length, p.EA, p.EA_compression);
}

}  // namespace netloft::lumped
