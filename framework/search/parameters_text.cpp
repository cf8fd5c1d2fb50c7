// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/nearest.hpp"
#include "framework/parameters/whole_number.hpp"
#include "framework/search/search.hpp"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace netloft {

namespace {

[[noreturn]] void refuse(const netloft_parameter& parameter, const std::string& text, const char* why) {
  throw std::invalid_argument(std::string(parameter.name) + ": \"" + text + "\" is " + why);
}

double number_of(const netloft_parameter& parameter, const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') refuse(parameter, text, "no number");
  return number;
}

std::int64_t whole_number_of(const netloft_parameter& parameter, const std::string& text) {
  const auto number = whole_number(number_of(parameter, text));
  if (!number) refuse(parameter, text, "no whole number from -2^53 to 2^53");
  return *number;
}

bool truth_of(const netloft_parameter& parameter, const std::string& text) {
  if (text != "true" && text != "false") refuse(parameter, text, "neither true nor false");
  return text == "true";
}

Value value_of(const netloft_parameter& parameter, const std::string& text) {
  switch (parameter.kind) {
    case NETLOFT_REAL:
      return number_of(parameter, text);
    case NETLOFT_INTEGER:
      return whole_number_of(parameter, text);
    case NETLOFT_BOOLEAN:
      return truth_of(parameter, text);
    case NETLOFT_TABLE:
      throw std::invalid_argument(std::string(parameter.name) + " is a table, which has no short form");
    default:
      return text;
  }
}

const netloft_parameter& find_parameter(std::span<const netloft_parameter> table, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& parameter : table) {
    if (name == parameter.name) return parameter;
    names.push_back(parameter.name);
  }
  std::string all;
  for (const auto& one : names) all += (all.empty() ? "; there is " : ", ") + one;
  const auto near = nearest(name, names);
  throw std::invalid_argument("there is no parameter " + name +
                              (near ? "; did you mean \"" + *near + "\"?" : all));
}

}  // namespace

Values parse_parameters(std::span<const netloft_parameter> table, const std::string& text) {
  Values values;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos) throw std::invalid_argument("\"" + pair + "\" is not key=value");
    const netloft_parameter& parameter = find_parameter(table, pair.substr(0, equals));
    const bool is_new = values.emplace(parameter.name, value_of(parameter, pair.substr(equals + 1))).second;
    if (!is_new) throw std::invalid_argument(std::string(parameter.name) + " is given twice");
    if (const auto fault = fault_of(parameter, values[parameter.name])) throw std::invalid_argument(*fault);
  }
  return values;
}

}  // namespace netloft
