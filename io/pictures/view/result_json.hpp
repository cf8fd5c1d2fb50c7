// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstddef>
#include <vector>

namespace netloft::pictures {

/// The numbers of results for the scripts of the page, as JSON. The text contains no '<', so that it cannot
/// close the surrounding element. If a motion has more than `most_states` states, only `most_states` of them,
/// evenly spaced, are included.
std::string results_json(const std::vector<const results::StoredShape*>& results, std::size_t most_states);

/// The indices of the included states of a result, in order.
std::vector<std::size_t> kept_states(std::size_t states, std::size_t most);

}  // namespace netloft::pictures
