// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/error_json.hpp"

#include "io/program/session/options.hpp"

#include <nlohmann/json.hpp>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;

const char* status_of(int exit_code) {
  switch (exit_code) {
    case kWrongInput:
      return "wrong input";
    case kRefused:
      return "plugin refused";
    case kNotConverged:
      return "not converged";
    case kInterrupted:
      return "interrupted";
    default:
      return "failed";
  }
}

std::string dump(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string errors_json(const formats::Diagnostics& diagnostics, int exit_code) {
  Json errors = Json::array();
  for (const auto& d : diagnostics.sorted())
    errors.push_back({{"severity", d.severity == formats::Severity::error ? "error" : "warning"},
                      {"where", diagnostics.where(d.place)},
                      {"line", d.place.line},
                      {"column", d.place.column},
                      {"message", d.message},
                      {"hint", d.hint}});
  const std::string reason = errors.empty() ? "" : errors[0]["message"].get<std::string>();
  return dump({{"status", status_of(exit_code)}, {"reason", reason}, {"errors", errors}});
}

std::string error_json(const std::string& message, int exit_code) {
  const Json error = {{"severity", "error"}, {"where", ""},        {"line", 0},
                      {"column", 0},         {"message", message}, {"hint", ""}};
  return dump({{"status", status_of(exit_code)}, {"reason", message}, {"errors", Json::array({error})}});
}

std::string json_text(const std::string& text) { return dump(text, -1); }

std::string done_json(const std::string& output) {
  return "{\"status\": \"done\", \"output\": " + json_text(output) + "}";
}

}  // namespace netloft::program
