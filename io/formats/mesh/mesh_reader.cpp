// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace netloft::formats {

namespace {

constexpr int kMostErrors = 50;

std::optional<RegionKind> kind_named(std::string_view name) {
  for (const auto kind : {RegionKind::triangles, RegionKind::bars, RegionKind::twines})
    if (name == name_of(kind)) return kind;
  return {};
}

/// Reads one mesh; the member functions are steps in the order of execution.
class MeshReader {
 public:
  MeshReader(std::string_view text, int file, Diagnostics& diagnostics)
      : rows_(text, file, '#'), diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {}

  InputMesh read() {
    read_first_row();
    while (!has_ended_ && errors() < kMostErrors) {
      const auto row = rows_.next_row();
      if (row.empty()) break;
      row[0].text.starts_with('[') ? begin_section(row) : read_row(row);
    }
    if (!has_ended_ && errors() == 0)
      error(rows_.place(), "the mesh is cut off: its last line must be [end]");
    if (errors() == 0) check_indices();
    return std::move(mesh_);
  }

 private:
  enum class Section { none, nodes, region, set };

  int errors() const { return diagnostics_.errors() - errors_before_; }
  void error(const Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }

  void read_first_row() {
    const auto row = rows_.next_row();
    const bool is_mesh = row.size() == 3 && row[0].text == "netloft" && row[1].text == "mesh";
    if (!is_mesh)
      error(row.empty() ? Place{} : row[0].place,
            "this file is no mesh: its first line must be: netloft mesh 1");
    else if (row[2].text != "1")
      error(row[2].place,
            "this mesh is of version " + std::string(row[2].text) + "; only version 1 can be read",
            "a newer version of the program reads it");
    has_ended_ = !is_mesh;
  }

  /// Begins a section: `[nodes]`, `[triangles wing]`, `[set wing-tip]`, `[end]`.
  void begin_section(const std::vector<Word>& row) {
    section_ = Section::none;
    std::string kind(row[0].text.substr(1)), name;
    if (row.size() == 2) name = row[1].text;
    std::string& last = row.size() == 2 ? name : kind;
    if (row.size() > 2 || !last.ends_with(']'))
      return error(row[0].place,
                   "a section begins with one or two words in brackets, such as [triangles wing]",
                   "names have no blanks");
    last.pop_back();
    const bool has_name = row.size() == 2 && !name.empty();
    if (kind == "nodes" && !has_name)
      section_ = Section::nodes;
    else if (kind == "end" && !has_name)
      has_ended_ = true;
    else if (kind == "set" && has_name)
      begin_set(row[1].place, name);
    else if (const auto region = kind_named(kind); region && has_name)
      begin_region(row[1].place, *region, name);
    else
      error(row[0].place,
            "there is no section " + in_quotes(kind) + (has_name ? " with a name" : " without a name"),
            "sections are [nodes], [triangles NAME], [bars NAME], [twines NAME], [set NAME] and [end]");
  }

  void begin_region(const Place& place, RegionKind kind, const std::string& name) {
    if (!names_.insert(name).second)
      return error(place, "there is a region " + in_quotes(name) + " already",
                   "a region is written in one section");
    section_ = Section::region;
    mesh_.regions.push_back({kind, name});
    element_places_.emplace_back();
  }

  void begin_set(const Place& place, const std::string& name) {
    if (!set_names_.insert(name).second)
      return error(place, "there is a set " + in_quotes(name) + " already",
                   "a set is written in one section");
    section_ = Section::set;
    mesh_.sets.push_back({name});
  }

  void read_row(const std::vector<Word>& row) {
    if (section_ == Section::nodes) read_node(row);
    if (section_ == Section::region) read_element(row);
    if (section_ == Section::set)
      for (const auto& word : row)
        if (const auto node = read_index(word)) {
          mesh_.sets.back().nodes.push_back(*node);
          note(word);
        }
    if (section_ == Section::none && errors() == 0)
      error(row[0].place, "there are numbers before the first section", "[nodes] is the first");
  }

  void read_node(const std::vector<Word>& row) {
    if (!has_columns(row, 3, "a node is x y z [m]")) return;
    if (mesh_.node_count() >= kMostNodes)
      return error(row[0].place, "there are more than " + std::to_string(kMostNodes) + " nodes");
    for (const auto& word : row) mesh_.positions.push_back(read_number(word));
  }

  void read_element(const std::vector<Word>& row) {
    MeshRegion& region = mesh_.regions.back();
    const std::size_t nodes = nodes_in(region.kind), columns = nodes + numbers_in(region.kind);
    static constexpr std::array docs = {
        "a triangle is three nodes and U1 V1 U2 V2 U3 V3 [meshes]",
        "a bar is two nodes and the shares of the rope at which it begins and ends",
        "a bar of twines is two nodes, its length in mesh sides, and twines"};
    if (!has_columns(row, columns, docs[static_cast<std::size_t>(region.kind)])) return;
    if (++elements_ > kMostElements)
      return error(row[0].place, "there are more than " + std::to_string(kMostElements) + " elements");
    const int errors_before = errors();
    for (std::size_t k = 0; k < nodes; ++k) region.nodes.push_back(read_index(row[k]).value_or(0));
    for (std::size_t k = nodes; k < columns; ++k) region.numbers.push_back(read_number(row[k]));
    element_places_.back().push_back(row[0].place);
    if (errors() == errors_before) check_element(region, row);
  }

  bool has_columns(const std::vector<Word>& row, std::size_t columns, const char* doc) {
    if (row.size() == columns) return true;
    error(row[0].place, std::to_string(row.size()) + " numbers are given here; " + doc);
    return false;
  }

  double read_number(const Word& word) {
    const auto value = number_in(word.text);
    if (value && std::abs(*value) <= kFarthest) return *value;
    error(word.place, in_quotes(word.text) + (value ? " is beyond a million" : " is no number"));
    return 0;
  }

  std::optional<std::uint32_t> read_index(const Word& word) {
    const auto value = integer_in(word.text);
    if (value && *value >= 0 && *value < static_cast<std::int64_t>(kMostNodes))
      return static_cast<std::uint32_t>(*value);
    error(word.place, in_quotes(word.text) + " is no number of a node", "nodes are counted from 0");
    return {};
  }

  void note(const Word& word) { index_places_.push_back(word.place); }

  /// Checks an element as far as possible before the number of nodes is known.
  void check_element(const MeshRegion& region, const std::vector<Word>& row) {
    if (const auto fault = fault_of(region, region.size() - 1))
      error(row[fault->is_of_nodes ? 0 : nodes_in(region.kind)].place, fault->message);
  }

  void check_indices() {
    const std::size_t count = mesh_.node_count();
    const std::string there = "nodes of this mesh are 0 to " + std::to_string(count ? count - 1 : 0);
    if (count == 0) error(rows_.place(), "the mesh has no nodes", "write them in the section [nodes]");
    for (std::size_t r = 0; r < mesh_.regions.size() && count; ++r) {
      const MeshRegion& region = mesh_.regions[r];
      for (std::size_t i = 0; i < region.nodes.size() && errors() < kMostErrors; ++i)
        if (region.nodes[i] >= count)
          error(element_places_[r][i / nodes_in(region.kind)],
                "there is no node " + std::to_string(region.nodes[i]), there);
    }
    std::size_t word = 0;
    for (const auto& set : mesh_.sets)
      for (const auto node : set.nodes) {
        if (node >= count && errors() < kMostErrors)
          error(index_places_[word], "there is no node " + std::to_string(node), there);
        ++word;
      }
  }

  TextRows rows_;
  Diagnostics& diagnostics_;
  int errors_before_;
  InputMesh mesh_;
  Section section_ = Section::none;
  bool has_ended_ = false;
  std::size_t elements_ = 0;
  std::set<std::string> names_, set_names_;
  std::vector<std::vector<Place>> element_places_;  // places of the elements of each region
  std::vector<Place> index_places_;  // places of the indices in all sets, one set after another
};

}  // namespace

bool is_mesh_text(std::string_view text) { return text.starts_with("netloft mesh"); }

InputMesh read_any_mesh(std::string_view text, int file, Diagnostics& diagnostics) {
  if (is_mesh_text(text)) return read_mesh(text, file, diagnostics);
  if (text.starts_with("glTF") || text.starts_with("{")) {
    diagnostics.error(
        {file, 0, 0},
        "a glTF file is a picture whose coordinates have seven digits, and cannot be read as a mesh",
        "export .vtk or .obj");
    return {};
  }
  return text.starts_with("# vtk DataFile") ? read_vtk(text, file, diagnostics)
                                            : read_obj(text, file, diagnostics);
}

InputMesh read_mesh(std::string_view text, int file, Diagnostics& diagnostics) {
  return MeshReader(text, file, diagnostics).read();
}

}  // namespace netloft::formats
