// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/law_watch.hpp"

#include <netloft/vectors.hpp>

#include "framework/registry/plugin_call.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

namespace netloft {

namespace {

using Vector3 = std::array<double, 3>;

Vector3 row(const double* field, std::size_t lane) {
  return {field[lane], field[NETLOFT_LANES + lane], field[2 * NETLOFT_LANES + lane]};
}

Vector3 across(const Vector3& flow, const Vector3& direction) {
  const double along = dot(flow, direction);
  return {flow[0] - along * direction[0], flow[1] - along * direction[1], flow[2] - along * direction[2]};
}

/// Whether a parameter is given: a table that has rows, or a number other than zero (see netloft_validity).
bool is_given(const LawType& law, const ParameterBlock& block, std::string_view name) {
  for (const auto& p : law.parameters) {
    if (name != p.name) continue;
    if (p.kind != NETLOFT_TABLE) return p.kind != NETLOFT_TEXT && block.number(p) != 0;
    netloft_table table{};
    std::memcpy(&table, static_cast<const std::byte*>(block.data()) + p.offset, sizeof table);
    return table.rows > 0;
  }
  return false;
}

bool holds(const LawType& law, const ParameterBlock& block, const netloft_validity& range) {
  return (!range.where || is_given(law, block, range.where)) &&
         (!range.unless || !is_given(law, block, range.unless));
}

}  // namespace

double flow_quantity(std::uint32_t kind, std::uint32_t quantity, const netloft_law_tile& f,
                     std::size_t lane) {
  const Vector3 W = row(f.flow, lane), d = row(f.direction, lane);
  const double reynolds_of_unit = f.diameter[lane] / f.water_viscosity;
  switch (quantity) {
    case NETLOFT_REYNOLDS:
      return norm(W) * reynolds_of_unit;
    case NETLOFT_REYNOLDS_ACROSS:
      return norm(across(W, d)) * reynolds_of_unit;
    case NETLOFT_REYNOLDS_IN_MESHES:
      return norm(W) * reynolds_of_unit / (1 - f.solidity[lane]);
    case NETLOFT_SOLIDITY:
      return f.solidity[lane];
    default:
      return kind == NETLOFT_SCREEN_LAW ? std::atan2(std::abs(dot(W, d)), norm(across(W, d)))
                                        : std::atan2(norm(across(W, d)), std::abs(dot(W, d)));
  }
}

const char* name_of_quantity(std::uint32_t quantity) {
  static constexpr const char* kNames[] = {"Reynolds number", "Reynolds number across",
                                           "Reynolds number in the meshes", "solidity", "angle of attack"};
  return kNames[std::min<std::uint32_t>(quantity, NETLOFT_ATTACK)];
}

LawWatch::LawWatch(const LawType& law, const ParameterBlock& parameters)
    : law_(law), parameters_(parameters.data()) {
  use_.law = &law;
  for (const auto& range : law.validity)
    if (holds(law, parameters, range)) use_.ranges.push_back({.range = &range});
}

netloft_bound_law LawWatch::bound() const { return {law_.law.kind, 0, this, &LawWatch::pass_on}; }

LawUse LawWatch::end() {
  watches_ = false;
  LawUse seen = use_;
  for (auto& range : use_.ranges) range = {.range = range.range};
  return seen;
}

int LawWatch::pass_on(const void* watch, const netloft_law_tile* flow) {
  const LawWatch& self = *static_cast<const LawWatch*>(watch);
  // the C interface hands out a pointer to const only
  if (self.watches_) const_cast<LawWatch&>(self).note(*flow);
  return call_plugin({self.law_.type.c_str(), "evaluate", nullptr, CallFrame::Kind::element},
                     int{NETLOFT_ERROR}, [&] {
                       const int status = self.law_.law.evaluate(self.parameters_, flow);
                       if (status != NETLOFT_OK && status != NETLOFT_OUTSIDE_DOMAIN)
                         calls_of_this_thread().blame("failed in");
                       return status;
                     });
}

void LawWatch::note(const netloft_law_tile& f) {
  for (auto& use : use_.ranges)
    for (std::size_t lane = 0; lane < f.count; ++lane) {
      const double value = flow_quantity(law_.law.kind, use.range->quantity, f, lane);
      const bool is_inside = use.range->lo <= value && value <= use.range->hi;
      (is_inside ? use.inside : use.outside) += f.extent ? f.extent[lane] : 1;
      use.least = std::min(use.least, value);
      use.most = std::max(use.most, value);
    }
}

}  // namespace netloft
