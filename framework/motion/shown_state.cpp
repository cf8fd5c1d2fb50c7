// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/shown_state.hpp"

#include "framework/scene/course.hpp"

#include <algorithm>

namespace netloft {

void ShownState::show(const MarchState& at) {
  u_ = at.u;
  moving_.set(at.t, at.u, at.v, at.a);
}

void ShownState::show_between(const MarchState& begin, const MarchState& end, double t) {
  std::vector<double> v(end.u.size()), a(v);
  u_.resize(v.size());
  Course course;
  course.knots = {{begin.t, {}, {}}, {end.t, {}, {}}};
  Course::Knot &from = course.knots[0], &to = course.knots[1];
  for (std::size_t i = 0; i < v.size(); i += 3) {  // three unknowns at a time form one vector of the cubic
    const std::size_t some = std::min<std::size_t>(3, v.size() - i);
    std::copy_n(&begin.u[i], some, from.d.begin());
    std::copy_n(&begin.v[i], some, from.v.begin());
    std::copy_n(&end.u[i], some, to.d.begin());
    std::copy_n(&end.v[i], some, to.v.begin());
    const Course::Moment m = course.at(t);
    std::copy_n(m.d.begin(), some, &u_[i]);
    std::copy_n(m.v.begin(), some, &v[i]);
    std::copy_n(m.a.begin(), some, &a[i]);
  }
  moving_.set(t, u_, v, a);
}

}  // namespace netloft
