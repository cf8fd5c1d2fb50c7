// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/request_values.hpp"

#include <cmath>

namespace netloft::design {

std::string text_in(const Json& body, const char* name) {
  const auto at = body.find(name);
  if (at == body.end() || !at->is_string())
    throw WrongRequest("\"" + std::string(name) + "\" is missing or not a text");
  return *at;
}

double number_in(const Json& body, const char* name) {
  const auto at = body.find(name);
  if (at == body.end() || !at->is_number() || !std::isfinite(at->get<double>()))
    throw WrongRequest("\"" + std::string(name) + "\" is missing or not a number");
  return *at;
}

bool flag_in(const Json& body, const char* name) {
  const auto at = body.find(name);
  if (at == body.end()) return false;
  if (!at->is_boolean()) throw WrongRequest("\"" + std::string(name) + "\" is neither true nor false");
  return *at;
}

}  // namespace netloft::design
