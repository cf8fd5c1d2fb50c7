// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include "plugins/common/bars.hpp"
#include "plugins/common/surface.hpp"
#include "plugins/priour/triangle.hpp"
#include "plugins/rope/bar.hpp"

namespace netloft::femnet {

/// Forces that FEMNET omits above the surface of the water, z = 0: (1) to (3) of plugins/common/surface.hpp,
/// as elements that are added to shipped elements, which know no surface.
using surface::Cube;

/// Equation (2) for netting: an element beside priour/triangle.
struct DryNettingDrag {
  static Status tile(const Family<priour::Triangle>& family, netloft_tile& t);
};

/// Equations (2) and (3) for ropes: an element beside rope/bar.
struct DryBarDrag {
  static Status tile(const Family<rope::Bar>& family, netloft_tile& t);
};
struct DryBarBuoyancy {
  static Status tile(const Family<rope::Bar>& family, netloft_tile& t);
};

}  // namespace netloft::femnet
