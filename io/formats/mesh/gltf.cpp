// SPDX-License-Identifier: BSD-3-Clause
//
// glTF 2.0 (Khronos Group, ISO/IEC 12113): binary files, and documents whose buffers stand in them. Triangles
// and lines of all nodes of the scene, where their transformations put them; z is up here, y there.
#include "io/formats/mesh/mesh_builder.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

namespace netloft::formats {

namespace {

using Json = nlohmann::json;
using Matrix = std::array<double, 16>;  // column by column, as glTF has them
using Vector = std::array<double, 3>;

// Numbers of glTF.
constexpr int kPoints = 0, kLines = 1, kLineLoop = 2, kLineStrip = 3, kTriangles = 4;
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr std::size_t kGltfHeader = 12, kChunkHeader = 8, kDeepest = 64;

/// Something that the file does not say as it should; the message goes to the user.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

Vector moved(const Matrix& m, const Vector& p) {
  Vector q{};
  for (std::size_t row = 0; row < 3; ++row)
    q[row] = m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row];
  return q;
}

/// A number of a document that is there and in its range.
std::size_t whole(const Json& object, const char* key, std::size_t most,
                  std::optional<std::size_t> fallback = {}) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || at == object.end()) {
    if (fallback) return *fallback;
    throw Fault(std::string("it has no ") + key + " where one is needed");
  }
  if (!at->is_number_unsigned() || at->get<std::uint64_t>() > most)
    throw Fault(std::string(key) + " = " + in_quotes(at->dump()) + " is no number from 0 to " +
                std::to_string(most));
  return at->get<std::size_t>();
}

const Json& item(const Json& document, const char* list, std::size_t index) {
  const auto at = document.find(list);
  if (at == document.end() || !at->is_array() || index >= at->size() || !(*at)[index].is_object())
    throw Fault(std::string(list) + " has no item " + std::to_string(index));
  return (*at)[index];
}

template <std::size_t N>
std::array<double, N> numbers(const Json& node, const char* key, const std::array<double, N>& fallback) {
  const auto at = node.find(key);
  if (at == node.end()) return fallback;
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!at->is_array() || at->size() != N || !(*at)[i].is_number())
      throw Fault(std::string(key) + " of a node is not " + std::to_string(N) + " numbers");
    values[i] = (*at)[i].template get<double>();
  }
  return values;
}

Matrix transformation(const Json& node) {
  if (node.contains("matrix")) return numbers<16>(node, "matrix", kIdentity);
  const auto t = numbers<3>(node, "translation", {0, 0, 0}), s = numbers<3>(node, "scale", {1, 1, 1});
  const auto [x, y, z, w] = numbers<4>(node, "rotation", {0, 0, 0, 1});
  Matrix m{1 - 2 * (y * y + z * z),
           2 * (x * y + z * w),
           2 * (x * z - y * w),
           0,
           2 * (x * y - z * w),
           1 - 2 * (x * x + z * z),
           2 * (y * z + x * w),
           0,
           2 * (x * z + y * w),
           2 * (y * z - x * w),
           1 - 2 * (x * x + y * y),
           0,
           t[0],
           t[1],
           t[2],
           1};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t row = 0; row < 3; ++row) m[4 * axis + row] *= s[axis];
  return m;
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return value;
}

std::string from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    static constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto value = letters.find(c);
    if (c == '=') break;
    if (value == std::string_view::npos) throw Fault("a buffer is not in base64");
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (count += 6; count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

/// Reads one file; members are steps in the order they happen.
class GltfReader {
 public:
  GltfReader(std::string_view bytes, int file, Diagnostics& diagnostics)
      : bytes_(bytes), place_{file, 0, 0, 1}, builder_(diagnostics) {}

  InputMesh read() {
    try {
      read_document();
      const Json& scene = item(document_, "scenes", whole(document_, "scene", 1000000, 0));
      for (const auto& node : list(scene, "nodes")) add_node(index(node), y_up(), 0);
    } catch (const Fault& fault) {
      builder_.error(place_, std::string("this glTF cannot be read: ") + fault.what());
    } catch (const Json::exception&) {
      builder_.error(place_, "this glTF cannot be read: its document is no JSON, or not of glTF's form");
    }
    return builder_.finish(place_);
  }

 private:
  /// y up becomes z up.
  static Matrix y_up() { return {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1}; }

  void read_document() {
    if (!bytes_.starts_with("glTF")) {
      document_ = Json::parse(bytes_);
      return;
    }
    if (bytes_.size() < kGltfHeader + kChunkHeader || word_at(bytes_, 4) != 2)
      throw Fault("it is not of version 2");
    std::size_t at = kGltfHeader;
    document_ = Json::parse(chunk(at, "JSON"));
    if (at + kChunkHeader <= bytes_.size()) binary_ = chunk(at, std::string_view("BIN\0", 4));
  }

  std::string_view chunk(std::size_t& at, std::string_view kind) {
    const std::size_t length = word_at(bytes_, at), begin = at + kChunkHeader;
    if (bytes_.substr(at + 4, 4) != kind) throw Fault("it has no chunk " + std::string(kind.substr(0, 3)));
    if (length > bytes_.size() - begin) throw Fault("the file is cut off");
    at = begin + length;
    return bytes_.substr(begin, length);
  }

  static const Json& list(const Json& object, const char* key) {
    static const Json none = Json::array();
    const auto at = object.find(key);
    return at == object.end() || !at->is_array() ? none : *at;
  }
  static std::size_t index(const Json& value) {
    if (!value.is_number_unsigned()) throw Fault("a node is named by " + in_quotes(value.dump()));
    return value.get<std::size_t>();
  }
  static std::string name_of(const Json& object) {
    const auto at = object.find("name");
    return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
  }

  void add_node(std::size_t number, const Matrix& above, std::size_t depth) {
    if (depth > kDeepest) throw Fault("nodes lie within nodes without end");
    if (++nodes_ > kMostElements) throw Fault("there are too many nodes");
    const Json& node = item(document_, "nodes", number);
    const Matrix here = product(above, transformation(node));
    if (node.contains("mesh")) {
      const Json& mesh = item(document_, "meshes", whole(node, "mesh", 1000000));
      const std::string name = name_of(node).empty() ? name_of(mesh) : name_of(node);
      for (const auto& primitive : list(mesh, "primitives")) add_primitive(primitive, name, here);
    }
    for (const auto& child : list(node, "children")) add_node(index(child), here, depth + 1);
  }

  void add_primitive(const Json& primitive, const std::string& name, const Matrix& here) {
    const auto mode = static_cast<int>(whole(primitive, "mode", 6, kTriangles));
    const Json& attributes = primitive.at("attributes");
    const auto places = floats(whole(attributes, "POSITION", 1000000000), 3);
    std::vector<double> textures;
    if (attributes.contains("TEXCOORD_0")) textures = floats(whole(attributes, "TEXCOORD_0", 1000000000), 2);
    const std::size_t count = places.size() / 3;
    if (!textures.empty() && textures.size() / 2 != count)
      throw Fault("POSITION and TEXCOORD_0 of a primitive differ in number");
    std::vector<std::size_t> order;
    if (primitive.contains("indices"))
      order = indices(whole(primitive, "indices", 1000000000), count);
    else
      for (std::size_t i = 0; i < count; ++i) order.push_back(i);
    std::vector<std::uint32_t> nodes;
    for (std::size_t i = 0; i < count; ++i)
      nodes.push_back(node_at(moved(here, {places[3 * i], places[3 * i + 1], places[3 * i + 2]})));
    if (mode == kTriangles)
      add_triangles(name, order, nodes, textures);
    else if (mode >= kLines && mode <= kLineStrip)
      add_lines(name, mode, order, nodes, textures);
    else if (mode == kPoints)
      for (const auto i : order) builder_.set(name).nodes.push_back(nodes[i]);
    else
      throw Fault("strips and fans of triangles are not read; save it with plain triangles");
  }

  /// Vertices in one place are one node: glTF needs several where texture coordinates differ.
  std::uint32_t node_at(const Vector& p) {
    const auto [known, is_new] = node_at_.try_emplace(p, static_cast<std::uint32_t>(node_at_.size()));
    for (const double x : p) {
      if (!(std::abs(x) <= kFarthest)) throw Fault("a vertex is beyond a million metres");
      if (is_new) builder_.add_coordinate(x, place_);
    }
    return known->second;
  }

  void add_triangles(const std::string& name, const std::vector<std::size_t>& order,
                     const std::vector<std::uint32_t>& nodes, const std::vector<double>& textures) {
    if (textures.empty())
      throw Fault("the triangles of " + in_quotes(name) + " have no TEXCOORD_0, which is U and V in meshes");
    MeshRegion& region = builder_.region(name, RegionKind::triangles);
    for (std::size_t i = 0; i + 2 < order.size() && builder_.goes_on(); i += 3) {
      std::uint32_t own[3];
      double UV[6];
      for (std::size_t k = 0; k < 3; ++k) {
        own[k] = nodes[order[i + k]];
        UV[2 * k] = textures[2 * order[i + k]];
        UV[2 * k + 1] = textures[2 * order[i + k] + 1];
      }
      builder_.add_element(region, own, UV, place_);
    }
  }

  /// Lines between pairs of vertices, or from each to the next; with texture coordinates their first number
  /// is the share of the rope.
  void add_lines(const std::string& name, int mode, const std::vector<std::size_t>& order,
                 const std::vector<std::uint32_t>& nodes, const std::vector<double>& textures) {
    MeshRegion& region = builder_.region(name, RegionKind::bars);
    if (region.size() > 0 && region.numbers.empty() != textures.empty())
      throw Fault("some bars of " + in_quotes(name) + " have shares of it, and others have none");
    for (std::size_t i = 0; i + 1 < order.size() && builder_.goes_on(); i += mode == kLines ? 2 : 1)
      add_line(region, order[i], order[i + 1], nodes, textures);
    if (mode == kLineLoop && order.size() > 2) add_line(region, order.back(), order.front(), nodes, textures);
  }
  void add_line(MeshRegion& region, std::size_t a, std::size_t b, const std::vector<std::uint32_t>& nodes,
                const std::vector<double>& textures) {
    const std::uint32_t own[] = {nodes[a], nodes[b]};
    const double shares[] = {textures.empty() ? 0 : textures[2 * a], textures.empty() ? 0 : textures[2 * b]};
    builder_.add_element(region, own, textures.empty() ? nullptr : shares, place_);
  }

  /// The bytes of the items of an accessor.
  struct Items {
    std::string_view bytes;
    std::size_t count = 0, stride = 0;
    int type = 0;
  };
  Items items(std::size_t number, const char* kind, std::size_t components) {
    const Json& accessor = item(document_, "accessors", number);
    if (accessor.value("type", "") != kind) throw Fault(std::string("an accessor is not of type ") + kind);
    if (accessor.contains("sparse")) throw Fault("sparse accessors are not read");
    const Json& view = item(document_, "bufferViews", whole(accessor, "bufferView", 1000000));
    Items out;
    out.type = static_cast<int>(whole(accessor, "componentType", 10000));
    const std::size_t size = components * (out.type == kUnsignedByte    ? 1
                                           : out.type == kUnsignedShort ? 2
                                                                        : 4);
    out.count = whole(accessor, "count", kMostElements * 3);
    out.stride = whole(view, "byteStride", 252, size);
    const std::string_view all = buffer(whole(view, "buffer", 1000000));
    const std::size_t most = std::size_t{1} << 40;
    const std::size_t begin = whole(view, "byteOffset", most, 0) + whole(accessor, "byteOffset", most, 0);
    const std::size_t length = out.count == 0 ? 0 : out.stride * (out.count - 1) + size;
    if (begin > all.size() || length > all.size() - begin)
      throw Fault("an accessor reaches beyond its buffer");
    out.bytes = all.substr(begin, length);
    return out;
  }

  std::vector<double> floats(std::size_t number, std::size_t components) {
    const Items all = items(number, components == 3 ? "VEC3" : "VEC2", components);
    if (all.type != kFloat) throw Fault("positions and texture coordinates are read as 32-bit floats only");
    std::vector<double> values;
    for (std::size_t i = 0; i < all.count; ++i)
      for (std::size_t k = 0; k < components; ++k) {
        const float value = std::bit_cast<float>(word_at(all.bytes, i * all.stride + 4 * k));
        if (!(std::abs(value) <= kFarthest)) throw Fault("a number of a vertex is beyond a million, or none");
        values.push_back(static_cast<double>(value));
      }
    return values;
  }

  std::vector<std::size_t> indices(std::size_t number, std::size_t count) {
    const Items all = items(number, "SCALAR", 1);
    const std::size_t size = all.type == kUnsignedByte ? 1 : all.type == kUnsignedShort ? 2 : 4;
    if (size == 4 && all.type != kUnsignedInt) throw Fault("indices are not whole numbers");
    std::vector<std::size_t> values;
    for (std::size_t i = 0; i < all.count; ++i) {
      std::size_t value = 0;
      for (std::size_t k = 0; k < size; ++k)
        value |= std::size_t{static_cast<unsigned char>(all.bytes[i * all.stride + k])} << (8 * k);
      if (value >= count) throw Fault("an index is beyond the vertices");
      values.push_back(value);
    }
    return values;
  }

  /// The binary chunk, or the bytes that a document has in itself.
  std::string_view buffer(std::size_t number) {
    const Json& buffer = item(document_, "buffers", number);
    if (!buffer.contains("uri")) return binary_;
    auto [known, is_new] = buffers_.try_emplace(number);
    if (is_new) {
      const std::string uri = buffer.at("uri").get<std::string>();
      const auto begin = uri.find(";base64,");
      if (!uri.starts_with("data:") || begin == std::string::npos)
        throw Fault("its numbers stand in another file; save it as .glb, in one");
      known->second = from_base64(std::string_view(uri).substr(begin + 8));
    }
    return known->second;
  }

  std::string_view bytes_, binary_;
  Place place_;
  MeshBuilder builder_;
  Json document_;
  std::size_t nodes_ = 0;
  std::map<std::size_t, std::string> buffers_;
  std::map<Vector, std::uint32_t> node_at_;
};

}  // namespace

InputMesh read_gltf(std::string_view bytes, int file, Diagnostics& diagnostics) {
  return GltfReader(bytes, file, diagnostics).read();
}

}  // namespace netloft::formats
