// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/python/module/python_plugin.hpp"

#include <string>
#include <vector>

namespace netloft::python {

/// Makes a callable of Python an element with one force term that has a potential: type "NAME/energy", on
/// `nodes` nodes (1 to 3). For each tile, the callable gets the coordinates [dof][element] [m], the
/// parameters [1 + number of reals][element], the data [number][element], and whether the tangent is wanted.
/// It returns energies [element] [J], forces [dof][element] [N] and tangents [dof][dof][element] [N/m].
/// `data` are names of data of the host, such as "rest_length". `acts_from_outside`: the forces need not sum
/// to zero. Throws PluginRefused.
void add_element(const std::string& name, const std::string& doc, unsigned nodes,
                 std::vector<RealParameter> parameters, const std::vector<std::string>& data,
                 bool acts_from_outside, pybind11::function energy);

}  // namespace netloft::python
