// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/neutral_case.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace netloft::real_gears {

namespace {

using Json = nlohmann::json;

/// Refuses features that none of these gears has, instead of ignoring them.
void refuse_unless(bool known, const char* what) {
  if (!known) throw std::runtime_error(std::string(what) + ": not known here");
}

std::uint8_t axes(const Json& flags) {
  std::uint8_t bits = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    bits |= static_cast<std::uint8_t>(flags.at(axis).get<bool>() << axis);
  return bits;
}

}  // namespace

static void from_json(const Json& j, NeutralNode& n) {
  n.initial = j.at("initial"), n.force = j.at("external_force"), n.box = j.at("box");
  n.limit = j.at("limit"), n.sense = j.at("limit_sense"), n.mass = j.at("mass");
  n.fixed = axes(j.at("fixed")), n.symmetry = axes(j.at("symmetry"));
  const Vector cd = j.at("cd");
  refuse_unless(n.box[0] * n.box[1] * n.box[2] == 0 || cd == Vector{}, "drag of a box");
}

static void from_json(const Json& j, NeutralBar& b) {
  b.nodes = j.at("nodes"), b.rest_length = j.at("rest_length");
  b.EA = j.at("EA_tension"), b.EA_compression = j.at("EA_compression");
  b.diameter = j.at("diameter"), b.density = j.at("density");
  b.cd_normal = j.at("cd_normal"), b.cd_tangent = j.at("cd_tangent");
}

static void from_json(const Json& j, NeutralBend& b) {
  refuse_unless(j.at("nodes").at(2).get<int>() >= 0, "bending against a mirror image");
  b.nodes = j.at("nodes"), b.EI = j.at("EI");
}

static void from_json(const Json& j, NeutralMaterial& m) {
  m.bar_length = j.at("twine_length"), m.EA = j.at("EA_tension"), m.EA_compression = j.at("EA_compression");
  m.diameter = j.at("diameter"), m.density = j.at("density");
  m.cd_normal = j.at("cd_normal"), m.cd_tangent = j.at("cd_tangent");
  refuse_unless(j.at("knot_size") == 0, "contact of knots");
  refuse_unless(j.at("opening_stiffness") == 0, "resistance to opening");
}

static void from_json(const Json& j, NeutralTriangle& t) {
  t.nodes = j.at("nodes"), t.twine_uv = j.at("twine_uv"), t.material = j.at("material");
}

static void from_json(const Json& j, NeutralReference::Reaction& r) {
  r.node = j.at("node"), r.force = j.at("force_N");
}

static void from_json(const Json& j, NeutralReference& r) {
  j.at("positions").get_to(r.positions);
  j.at("bar_tensions_N").get_to(r.bar_tensions);
  j.at("twine_tensions_N").get_to(r.twine_tensions);
  j.at("reactions").get_to(r.reactions);
  r.mean_residual = j.at("independent_mean_residual_N");
  r.largest_component = j.at("independent_max_component_N");
}

static void from_json(const Json& j, NeutralRun& r) {
  r.iterations = j.at("iterations"), r.cpu_seconds = j.at("user_cpu_s");
  r.mean_residual = j.at("true_mean_residual_N");
  r.distance = j.at("distance_to_reference").at("max_m");
}

namespace {

void read_water(const Json& j, NeutralCase& c) {
  c.gravity = j.at("gravity"), c.water_density = j.at("water_density");
  c.current = j.at("current").at("vector");
  c.drags_netting = j.at("netting_drag") == "morison";
  refuse_unless(c.drags_netting || j.at("netting_drag") == "none", "netting_drag");
  refuse_unless(j.at("free_surface_z") == 0, "a surface elsewhere than z = 0");
  const Json& bed = j.at("seabed");
  c.bed_stiffness = bed.at("stiffness");
  c.bed_friction = bed.at("moving").get<bool>() ? bed.at("friction").get<double>() : 0;
}

NeutralCase read(const Json& j) {
  refuse_unless(j.at("format") == "femnet-neutral/1", "format");
  NeutralCase c;
  c.name = j.at("name"), c.title = j.at("title");
  read_water(j.at("environment"), c);
  j.at("nodes").get_to(c.nodes);
  j.at("bars").get_to(c.bars);
  j.at("bends").get_to(c.bends);
  j.at("netting_materials").get_to(c.materials);
  j.at("triangles").get_to(c.triangles);
  j.at("reference").get_to(c.reference);
  j.at("femnet_default_run").get_to(c.femnet);
  return c;
}

}  // namespace

NeutralCase read_neutral_case(const std::filesystem::path& file) {
  try {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot be read");
    return read(Json::parse(stream));
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::vector<std::filesystem::path> neutral_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error(folder.string() + ": holds no .json");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace netloft::real_gears
