// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/gear_json.hpp"

#include "io/results/text/spread.hpp"

namespace netloft::results {

using Json = nlohmann::ordered_json;

Json values_json(const std::vector<NamedScalar>& scalars) {
  Json values = Json::object();
  for (const auto& s : scalars) values[s.name] = s.value;
  return values;
}

Json units_json(const std::vector<NamedScalar>& scalars) {
  Json units = Json::object();
  for (const auto& s : scalars) units[s.name] = s.unit;
  return units;
}

Json errors_json(const std::vector<NamedScalar>& scalars) {
  Json errors = Json::object();
  for (const auto& s : scalars)
    errors[s.name] = {{"solver", s.solver_error}, {"mesh", s.mesh_error}, {"mesh_order", s.mesh_order}};
  return errors;
}

Json gear_json(const scenes::LoadedScene& loaded, const std::vector<NamedScalar>& figures) {
  if (figures.empty()) return nullptr;
  const int times = loaded.gear ? loaded.gear->times : 1;
  return {{"modelled", times == 2 ? "half" : "whole"},
          {"times", times},
          {"figures", values_json(figures)},
          {"units", units_json(figures)},
          {"errors", errors_json(figures)},
          {"spread", spread_json(figures)}};
}

}  // namespace netloft::results
