// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/members.hpp"

#include "framework/registry/plugin_call.hpp"

#include <stdexcept>

namespace netloft {

std::vector<netloft_member> members_of(const ElementFamily& family) {
  const netloft_element_members& members = family.type().members;
  std::vector<netloft_member> reported(family.size() * members.count);
  const auto count = static_cast<std::uint32_t>(family.size());
  const int status = call_plugin({family.type().type.c_str(), "members", nullptr, CallFrame::Kind::element},
                                 int{NETLOFT_ERROR},
                                 [&] { return members.write(family.self(), 0, 0, count, reported.data()); });
  if (const std::string broken = take_broken_rule(); !broken.empty()) throw std::runtime_error(broken);
  if (status != NETLOFT_OK) throw std::runtime_error(family.type().type + " could not report its members");
  return reported;
}

}  // namespace netloft
