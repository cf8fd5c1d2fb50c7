// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_result.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// A row of the bill of materials with what it carries; NaN marks what does not apply or is not known.
struct Material {
  scenes::BillItem item;
  double length = 0;  // in the whole gear: of ropes, unstretched; of the twines of netting [m]
  double area = 0;    // length times diameter of the twines; of bodies projected [m2]
  double mass = 0;    // in air [kg]
  double load = 0;    // largest tension in the newest state: of a rope, of a twine [N]

  /// The load as a fraction of the breaking load; NaN unless both are known.
  double utilisation() const { return load / item.breaking_load; }
};

/// All rows of a gear; none if the result has no bill of materials.
std::vector<Material> materials_of(const StoredResult& result);

/// A sentence for every material that carries more than half of its breaking load.
std::vector<std::string> load_warnings(const std::vector<Material>& materials);

}  // namespace netloft::results
