// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/gltf.hpp"

#include "io/pictures/picture/netting_texture.hpp"
#include "io/pictures/picture/png.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace netloft::pictures {

namespace {

using Json = nlohmann::ordered_json;

// Codes of glTF 2.0 (and of OpenGL).
enum Mode { kPoints = 0, kLines = 1, kTriangles = 4 };
// Least half width of twines in a texture [meshes]; thinner twines would be invisible
constexpr double kLeastTextureTwine = 0.03;
constexpr int kFloat = 5126, kArrayBuffer = 34962, kLinear = 9729, kLinearMipmapLinear = 9987;

/// Converts a colour component from sRGB (IEC 61966-2-1) to a linear scale, which glTF uses for vertices.
float linear(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

/// The vertices of one part in one of glTF's modes (triangles, lines, points): positions and colours, and for
/// netting the panel coordinates in meshes, so that scenes can read the file as a mesh (io/formats/mesh).
struct Vertices {
  std::vector<float> positions, colours, meshes;
  bool has_meshes = true;

  void add(const Point3& p, const Colour& colour) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
    for (const float c : colour) colours.push_back(linear(c));
  }
  void add_meshes(const double* UV) {
    has_meshes = has_meshes && std::isfinite(UV[0]) && std::isfinite(UV[1]);
    meshes.push_back(static_cast<float>(UV[0]));
    meshes.push_back(static_cast<float>(UV[1]));
  }
};

using Primitives = std::map<std::pair<std::uint32_t, Mode>, Vertices>;

/// The index of the ship, as if it were one more part after the parts of the gear.
std::uint32_t ship_of(const GearShape& shape) {
  return static_cast<std::uint32_t>(shape.stored->parts.size());
}

Primitives gather(const GearShape& shape) {
  const results::StoredMesh& mesh = shape.stored->mesh;
  Primitives all;
  const auto add = [&](Mode mode, std::uint32_t cell, std::uint32_t node, const Colour& colour) {
    all[{mesh.cell_part[cell], mode}].add(shape.nodes[node], colour);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto cell = mesh.triangle_cells[t];
      const double value = shape.field ? shape.at_corners[t][corner] : 0;
      add(kTriangles, cell, mesh.triangles[t][corner], shape.colour(results::CellKind::netting, cell, value));
      all.at({mesh.cell_part[cell], kTriangles}).add_meshes(&mesh.corners[t][2 * corner]);
    }
  for (std::size_t b = 0; b < mesh.bars.size(); ++b)
    for (const auto node : mesh.bars[b])
      add(kLines, mesh.bar_cells[b], node, shape.colour_of_cell(results::CellKind::rope, mesh.bar_cells[b]));
  for (std::size_t d = 0; d < mesh.dots.size(); ++d)
    add(kPoints, mesh.dot_cells[d], mesh.dots[d],
        shape.colour_of_cell(results::CellKind::point, mesh.dot_cells[d]));
  for (const auto& plate : shape.plates)
    for (const auto& corner : plate.triangles)
      all[{mesh.cell_part[mesh.dot_cells[plate.dot]], kTriangles}].add(corner, shape.colour_of_plate(plate));
  for (const auto& corner : shape.hulls) all[{ship_of(shape), kTriangles}].add(corner, kShipColour);
  return all;
}

std::string name_of(const GearShape& shape, std::uint32_t part) {
  return part == ship_of(shape) ? "ship" : shape.stored->parts[part].name;
}

/// Writes a file in pieces: the JSON document, and the binary data that it refers to.
class GltfWriter {
 public:
  explicit GltfWriter(const GearShape& shape) : shape_(shape) {}

  std::string write() {
    for (const auto& [key, vertices] : gather(shape_)) add_primitive(key.first, key.second, vertices);
    Json nodes = Json::array(), children = Json::array(), halves = Json::array();
    for (const auto& [part, mesh] : mesh_of_part_) {
      children.push_back(nodes.size());
      nodes.push_back({{"name", name_of(shape_, part)}, {"mesh", mesh}});
    }
    const auto group = [&](const char* name, int side) {
      halves.push_back(nodes.size());
      nodes.push_back({{"name", name}, {"scale", {1, side, 1}}, {"children", children}});
    };
    group(shape_.stored->result.is_half() ? "starboard" : "gear", 1);
    if (shape_.stored->result.is_half()) add_mirrored(children.size(), nodes, halves);
    // Rotates the z axis, which points up, onto the y axis of glTF.
    nodes.push_back({{"name", shape_.stored->result.title},
                     {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                     {"children", halves}});
    return finish(nodes);
  }

 private:
  /// Adds nodes for the mirrored half. They use the same meshes, but must be separate, because a node may
  /// have only one parent.
  static void add_mirrored(std::size_t parts, Json& nodes, Json& halves) {
    Json children = Json::array();
    for (std::size_t i = 0; i < parts; ++i) {
      children.push_back(nodes.size());
      nodes.push_back({{"name", "port " + nodes[i]["name"].get<std::string>()}, {"mesh", nodes[i]["mesh"]}});
    }
    halves.push_back(nodes.size());
    nodes.push_back({{"name", "port"}, {"scale", {1, -1, 1}}, {"children", children}});
  }

  void add_primitive(std::uint32_t part, Mode mode, const Vertices& vertices) {
    const auto [at, is_new] = mesh_of_part_.try_emplace(part, meshes_.size());
    if (is_new) meshes_.push_back({{"name", name_of(shape_, part)}, {"primitives", Json::array()}});
    Json attributes = {{"POSITION", add_accessor(vertices.positions, 3, true)},
                       {"COLOR_0", add_accessor(vertices.colours, 3, false)}};
    if (vertices.has_meshes && !vertices.meshes.empty())
      attributes["TEXCOORD_0"] = add_accessor(vertices.meshes, 2, false);
    const std::size_t material = attributes.contains("TEXCOORD_0") ? material_of_netting(part) : 0;
    meshes_[at->second]["primitives"].push_back(
        {{"attributes", attributes}, {"mode", static_cast<int>(mode)}, {"material", material}});
  }

  static Json plain_material() {
    return {{"doubleSided", true},
            {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}};
  }

  /// The material that shows the twines of a part. If the twine directions are unknown, it is the plain
  /// material. Parts with the same netting share a material.
  std::size_t material_of_netting(std::uint32_t part) {
    const results::StoredPart& p = shape_.stored->parts[part];
    const double half_width = std::isfinite(p.diameter / p.bar) ? p.diameter / p.bar / 2 : 0;
    const auto texture = netting_texture(p.twine_axes, std::max(half_width, kLeastTextureTwine));
    if (!texture) return 0;
    const std::string bytes = png(*texture);
    const auto [at, is_new] = material_of_texture_.try_emplace(bytes, materials_.size());
    if (is_new) add_textured_material(bytes);
    return at->second;
  }

  void add_textured_material(const std::string& bytes) {
    Json material = plain_material();
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", textures_.size()}};
    materials_.push_back(material);
    textures_.push_back({{"source", images_.size()}, {"sampler", 0}});
    images_.push_back({{"bufferView", views_.size()}, {"mimeType", "image/png"}});
    views_.push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}});
    binary_ += bytes;
    // Aligns the following numbers to a multiple of four bytes
    binary_.append((4 - binary_.size() % 4) % 4, '\0');
  }

  std::size_t add_accessor(const std::vector<float>& values, std::size_t components, bool with_box) {
    views_.push_back({{"buffer", 0},
                      {"byteOffset", binary_.size()},
                      {"byteLength", 4 * values.size()},
                      {"target", kArrayBuffer}});
    binary_.append(reinterpret_cast<const char*>(values.data()), 4 * values.size());
    Json accessor = {{"bufferView", views_.size() - 1},
                     {"componentType", kFloat},
                     {"count", values.size() / components},
                     {"type", components == 3 ? "VEC3" : "VEC2"}};
    for (const bool is_max : {false, true}) {
      if (!with_box) continue;
      std::array<float, 3> box{values[0], values[1], values[2]};
      for (std::size_t i = 0; i < values.size(); ++i)
        box[i % 3] = is_max ? std::max(box[i % 3], values[i]) : std::min(box[i % 3], values[i]);
      accessor[is_max ? "max" : "min"] = box;
    }
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
  }

  std::string finish(const Json& nodes) const {
    Json document = {{"asset", {{"version", "2.0"}, {"generator", "netloft"}}},
                     {"scene", 0},
                     {"scenes", {{{"nodes", {nodes.size() - 1}}}}},
                     {"nodes", nodes},
                     {"meshes", meshes_},
                     {"materials", materials_},
                     {"accessors", accessors_},
                     {"bufferViews", views_},
                     {"buffers", {{{"byteLength", binary_.size()}}}}};
    if (!textures_.empty()) {
      document["textures"] = textures_;
      document["images"] = images_;
      document["samplers"] = Json::array({Json{{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}}});
    }
    std::string text = document.dump(-1, ' ', true, Json::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    const auto length = static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary_.size());
    return "glTF" + word(2) + word(length) + word(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
           word(static_cast<std::uint32_t>(binary_.size())) + std::string("BIN\0", 4) + binary_;
  }

  static std::string word(std::uint32_t value) {
    return {static_cast<char>(value), static_cast<char>(value >> 8), static_cast<char>(value >> 16),
            static_cast<char>(value >> 24)};
  }

  const GearShape& shape_;
  std::map<std::uint32_t, std::size_t> mesh_of_part_;
  std::map<std::string, std::size_t> material_of_texture_;
  Json meshes_ = Json::array(), accessors_ = Json::array(), views_ = Json::array(), textures_ = Json::array(),
       images_ = Json::array(), materials_ = Json::array({plain_material()});
  std::string binary_;
};

}  // namespace

std::string glb(const GearShape& shape) { return GltfWriter(shape).write(); }

}  // namespace netloft::pictures
