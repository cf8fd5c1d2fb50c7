// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstddef>
#include <vector>

namespace netloft::pictures {

/// The numbers of some results as the page's scripts read them: JSON without '<', so that nothing in it can
/// end the element that holds it. `most_states`: of a motion with more, evenly spaced ones are kept, the last
/// among them.
std::string results_json(const std::vector<const results::StoredShape*>& results, std::size_t most_states);

/// The states of a result that are kept, in order.
std::vector<std::size_t> kept_states(std::size_t states, std::size_t most);

}  // namespace netloft::pictures
