// SPDX-License-Identifier: BSD-3-Clause
//
// Reads and writes Wavefront OBJ (Alias, "Object Files", appendix B1 of the Advanced Visualizer manual):
// lines v, vt, f, l, p, g and o.
#include "io/formats/mesh/mesh_builder.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <array>

namespace netloft::formats {

namespace {

/// Reads one file; each kind of line has its own member.
class ObjReader {
 public:
  ObjReader(std::string_view text, int file, Diagnostics& diagnostics)
      : rows_(text, file, '#'), builder_(diagnostics) {}

  InputMesh read() {
    bool is_obj = false;
    for (auto row = rows_.next_row(); !row.empty() && builder_.goes_on(); row = rows_.next_row()) {
      const std::string_view kind = row[0].text;
      is_obj = is_obj || kind == "v";
      if (!is_obj && !is_known_before_vertices(kind)) {
        builder_.error(row[0].place, "this file is no mesh that can be read",
                       "a mesh begins with netloft mesh 1, or is a VTK legacy file or an OBJ");
        break;
      }
      read_row(kind, row);
    }
    return builder_.finish(rows_.place());
  }

 private:
  using Row = std::vector<Word>;
  struct Corner {
    std::uint32_t node = 0;
    double U = 0, V = 0;
    bool has_texture = false;
  };

  static bool is_known_before_vertices(std::string_view kind) {
    static constexpr std::string_view known[] = {"g", "o", "s", "mtllib", "usemtl", "vt", "vn"};
    return std::find(std::begin(known), std::end(known), kind) != std::end(known);
  }

  void read_row(std::string_view kind, const Row& row) {
    if (kind == "v") read_vertex(row);
    if (kind == "vt") read_texture(row);
    if (kind == "g" || kind == "o") group_ = row.size() > 1 ? std::string(row[1].text) : "mesh";
    if (kind == "f") read_face(row);
    if (kind == "l") read_line(row);
    if (kind == "p") read_points(row);
  }

  bool has_words(const Row& row, std::size_t least, const char* what) {
    if (row.size() > least) return true;
    builder_.error(row[0].place, what);
    return false;
  }

  void read_vertex(const Row& row) {
    if (!has_words(row, 3, "a vertex is v x y z [m]")) return;
    for (std::size_t k = 1; k <= 3; ++k)
      builder_.add_coordinate(builder_.real(row[k].text, row[k].place), row[k].place);
    ++vertices_;
  }

  void read_texture(const Row& row) {
    if (!has_words(row, 1, "a texture coordinate is vt U V [meshes], or vt and the share of a rope")) return;
    textures_.push_back({builder_.real(row[1].text, row[1].place),
                         row.size() > 2 ? builder_.real(row[2].text, row[2].place) : 0});
  }

  /// Reads an index, which counts from 1, or from the end if it is negative. Reports an error and returns 0
  /// if it does not exist.
  std::size_t index(std::string_view word, std::size_t count, const char* what, const Place& place) {
    const auto value = integer_in(word);
    const auto all = static_cast<std::int64_t>(count);
    if (value && *value >= 1 && *value <= all) return static_cast<std::size_t>(*value) - 1;
    if (value && *value <= -1 && *value >= -all) return static_cast<std::size_t>(all + *value);
    builder_.error(place, "there is no " + std::string(what) + " " + in_quotes(word),
                   "there are " + std::to_string(count) + " above this line");
    return 0;
  }

  Corner corner(const Word& word) {
    Corner c;
    const auto slash = word.text.find('/');
    c.node = static_cast<std::uint32_t>(index(word.text.substr(0, slash), vertices_, "vertex", word.place));
    if (slash == std::string_view::npos) return c;
    const auto rest = word.text.substr(slash + 1), texture = rest.substr(0, rest.find('/'));
    if (texture.empty()) return c;
    c.has_texture = true;
    const std::size_t t = index(texture, textures_.size(), "texture coordinate", word.place);
    if (t < textures_.size()) {
      c.U = textures_[t][0];
      c.V = textures_[t][1];
    }
    return c;
  }

  /// Reads a face. A polygon becomes triangles that share its first corner.
  void read_face(const Row& row) {
    if (!has_words(row, 3, "a face has three corners or more")) return;
    std::vector<Corner> corners;
    for (std::size_t k = 1; k < row.size(); ++k) {
      corners.push_back(corner(row[k]));
      if (!corners.back().has_texture && builder_.goes_on())
        return builder_.error(row[k].place, "the corner has no coordinates on its panel",
                              "write vt U V in meshes, and f vertex/texture …");
    }
    if (builder_.errors() > 0) return;
    MeshRegion& region = builder_.region(group_, RegionKind::triangles);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Corner &a = corners[0], &b = corners[k], &c = corners[k + 1];
      const std::uint32_t nodes[] = {a.node, b.node, c.node};
      const double UV[] = {a.U, a.V, b.U, b.V, c.U, c.V};
      builder_.add_element(region, nodes, UV, row[0].place);
    }
  }

  void read_line(const Row& row) {
    if (!has_words(row, 2, "a line has two corners or more")) return;
    std::vector<Corner> corners;
    for (std::size_t k = 1; k < row.size(); ++k) corners.push_back(corner(row[k]));
    if (builder_.errors() > 0) return;
    MeshRegion& region = builder_.region(group_, RegionKind::bars);
    const bool has_shares = corners[0].has_texture;
    const bool is_mixed = std::any_of(corners.begin(), corners.end(),
                                      [&](const Corner& c) { return c.has_texture != has_shares; }) ||
                          (region.size() > 0 && region.numbers.empty() == has_shares);
    if (is_mixed)
      return builder_.error(row[0].place,
                            "some bars of this rope state their share of the rope, and others do not",
                            "write l vertex/texture … with vt and the share, or neither");
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      const std::uint32_t nodes[] = {corners[k].node, corners[k + 1].node};
      const double shares[] = {corners[k].U, corners[k + 1].U};
      builder_.add_element(region, nodes, has_shares ? shares : nullptr, row[0].place);
    }
  }

  void read_points(const Row& row) {
    for (std::size_t k = 1; k < row.size(); ++k) {
      const auto node = corner(row[k]).node;
      builder_.set(group_).nodes.push_back(node);
    }
  }

  TextRows rows_;
  MeshBuilder builder_;
  std::string group_ = "mesh";
  std::size_t vertices_ = 0;
  std::vector<std::array<double, 2>> textures_;
};

void write_region(const MeshRegion& region, std::size_t& textures, std::string& out) {
  const bool is_netting = region.kind == RegionKind::triangles;
  const std::size_t corners = nodes_in(region.kind), each = is_netting ? 2 : 1;
  out += "g " + region.name + "\n";
  for (std::size_t e = 0; e < region.size(); ++e) {
    std::string element = is_netting ? "f" : "l";
    for (std::size_t k = 0; k < corners; ++k) {
      const double* numbers = &region.numbers[e * numbers_in(region.kind) + each * k];
      out += "vt " + spell_number(numbers[0]) + (is_netting ? " " + spell_number(numbers[1]) : "") + "\n";
      element += " " + std::to_string(region.nodes[e * corners + k] + 1) + "/" + std::to_string(++textures);
    }
    out += element + "\n";
  }
}

}  // namespace

InputMesh read_obj(std::string_view text, int file, Diagnostics& diagnostics) {
  return ObjReader(text, file, diagnostics).read();
}

std::string obj_text(const InputMesh& mesh, const std::string& source) {
  std::string out =
      comment_of(source) + "# z up [m]; vt of faces: U V [meshes], of lines: share of the rope\n";
  for (std::size_t n = 0; n < mesh.node_count(); ++n)
    out += "v " + spell_number(mesh.positions[3 * n]) + " " + spell_number(mesh.positions[3 * n + 1]) + " " +
           spell_number(mesh.positions[3 * n + 2]) + "\n";
  std::size_t textures = 0;
  for (const auto& region : mesh.regions)
    if (region.kind != RegionKind::twines) write_region(region, textures, out);
  for (const auto& set : mesh.sets) {
    out += "g " + set.name + "\np";
    for (const auto node : set.nodes) out += " " + std::to_string(node + 1);
    out += "\n";
  }
  return out;
}

}  // namespace netloft::formats
