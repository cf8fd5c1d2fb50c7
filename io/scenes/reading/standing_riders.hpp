// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

namespace netloft::scenes {

/// Makes the elements of a rider (a part on other parts) and reads their data. The elements have the type
/// `type`, and are on the nodes or elements that the key `on` names. The nodes of the scene must be numbered.
void stand_on_others(const ElementType& type, formats::TableReader& table, Draft& draft, Part& rider);

}  // namespace netloft::scenes
