// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/references.hpp"

#include "io/formats/files/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <sstream>
#include <stdexcept>

namespace netloft::hard_cases {

using namespace formats;

namespace {

using Json = nlohmann::ordered_json;

Reference from_json(const Json& json) {
  Reference r;
  r.unknowns = json.at("unknowns"), r.found_by = json.at("found_by");
  r.energy = json.at("energy"), r.size = json.at("size");
  r.load = json.at("load"), r.noise = json.at("noise");
  r.residual = json.value("residual", 0.0);
  for (const auto& n : json.at("nodes")) r.nodes.push_back({n.at(0), {n.at(1), n.at(2), n.at(3)}});
  return r;
}

Json to_json(const Reference& r) {
  Json nodes = Json::array();
  for (const auto& n : r.nodes) nodes.push_back({n.node, n.x[0], n.x[1], n.x[2]});
  return {{"unknowns", r.unknowns}, {"energy", r.energy},     {"size", r.size},         {"load", r.load},
          {"noise", r.noise},       {"residual", r.residual}, {"found_by", r.found_by}, {"nodes", nodes}};
}

}  // namespace

References::References(const std::filesystem::path& file) : file_(file) {
  const auto text = formats::read_whole(file);
  if (!text) return;
  try {
    const Json book = Json::parse(*text);
    for (const auto& [name, sizes] : book.items())
      for (const auto& [size, reference] : sizes.items()) all_[name][size] = from_json(reference);
  } catch (const Json::exception& e) {
    throw std::runtime_error(file.string() + ": " + e.what());
  }
}

std::optional<Reference> References::find(const std::string& name, const std::string& size) const {
  const auto sizes = all_.find(name);
  if (sizes == all_.end()) return {};
  const auto at = sizes->second.find(size);
  return at == sizes->second.end() ? std::nullopt : std::optional(at->second);
}

void References::keep(const std::string& name, const std::string& size, const Reference& reference) {
  all_[name][size] = reference;
}

void References::forget(const std::string& name, const std::string& size) {
  const auto sizes = all_.find(name);
  if (sizes == all_.end()) return;
  sizes->second.erase(size);
  if (sizes->second.empty()) all_.erase(sizes);
}

/// Writes one reference per line, so that a diff shows what changed.
void References::save() const {
  std::ostringstream out;
  out << "{";
  const char* comma = "\n";
  for (const auto& [name, sizes] : all_) {
    out << comma << Json(name) << ": {", comma = ",\n";
    const char* between = "\n  ";
    for (const auto& [size, reference] : sizes)
      out << between << Json(size) << ": " << to_json(reference), between = ",\n  ";
    out << "}";
  }
  out << "\n}\n";
  formats::write_whole(file_, out.str());
}

}  // namespace netloft::hard_cases
