// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a .mdg, a mesh of FEMNET: blocks of rows, each after a title, the number of rows and another title.
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/scenes/import/femnet_gear.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace netloft::scenes::femnet {

namespace {

constexpr std::int64_t kMostMeshRows = 4000000;
constexpr double kShareRounding = 1e-6;

/// Reads one mesh file. The member functions are the steps, in the order of execution.
class MeshFileReader {
 public:
  MeshFileReader(const std::string& text, int file, const GearFile& gear, formats::Diagnostics& diagnostics)
      : rows_(text, file), gear_(gear), diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {}

  MeshFile read() {
    for (int line = 0; line < 3; ++line) rows_.next_line();  // three lines of free text
    read_block("nodes", 7, [&](const auto& row) { read_node(row); });
    read_block("bars", 6, [&](const auto& row) { read_bar(row); });
    refuse_block("sliding cables");
    read_block("triangles", 12, [&](const auto& row) { read_triangle(row); });
    if (!rows_.at_end() && is_fine()) refuse_block("hexagonal netting", true);
    if (is_fine() && mesh_.nodes.empty()) error(rows_.place(), "the mesh has no nodes");
    return std::move(mesh_);
  }

 private:
  using Row = std::vector<formats::Word>;

  bool is_fine() const { return diagnostics_.errors() == errors_before_; }
  void error(const formats::Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }

  /// The number of rows of the next block: the first line that is a number and nothing else.
  std::int64_t find_count(const std::string& what, bool may_be_missing) {
    for (Row row = rows_.next_row(); !row.empty(); row = rows_.next_row()) {
      if (row.size() > 2 && formats::integer_in(row[0].text) && formats::number_in(row[1].text)) {
        error(row[0].place, "there are more rows than were announced before the " + what);
        return 0;
      }
      if (row.size() != 1) continue;
      const auto value = formats::integer_in(row[0].text);
      if (!value) continue;
      if (*value >= 0 && *value <= kMostMeshRows) return *value;
      error(row[0].place, "the number of " + what + " is " + std::string(row[0].text.substr(0, 30)) +
                              "; it must be from 0 to " + std::to_string(kMostMeshRows));
      return 0;
    }
    if (!may_be_missing) error(rows_.place(), "the file ends where the number of " + what + " is expected");
    return 0;
  }

  template <class Read>
  void read_block(const std::string& what, std::size_t columns, Read&& read) {
    const std::int64_t count = is_fine() ? find_count(what, false) : 0;
    for (std::int64_t i = 0; i < count && is_fine(); ++i) {
      Row row = rows_.next_row();
      if (i == 0 && !row.empty() && !formats::number_in(row[0].text)) row = rows_.next_row();  // a title
      number_ = i + 1;
      if (row.empty())
        error(rows_.place(),
              "the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " " + what);
      else if (row.size() != columns)
        error(row[0].place, std::to_string(row.size()) + " numbers are in a row of " + what +
                                "; there must be " + std::to_string(columns));
      else {
        check_number(row[0], what);
        read(row);
      }
    }
  }

  void refuse_block(const std::string& what, bool may_be_missing = false) {
    if (is_fine() && find_count(what, may_be_missing) > 0)
      error(rows_.place(), "meshes with " + what + " cannot be imported");
  }

  void check_number(const formats::Word& word, const std::string& what) {
    if (formats::integer_in(word.text) != number_)
      error(word.place, "this row of " + what + " must be number " + std::to_string(number_) + ", and is " +
                            std::string(word.text.substr(0, 30)));
  }

  double real(const formats::Word& word) {
    const auto value = formats::number_in(word.text);
    if (value && std::abs(*value) <= formats::kFarthest) return *value;
    error(word.place, "\"" + std::string(word.text.substr(0, 30)) +
                          (value ? "\" is beyond a million" : "\" is no number"));
    return 0;
  }

  /// Reports an error that shows that the mesh belongs to another version of the gear.
  void error_of_gear(const formats::Place& place, const std::string& message, const std::string& hint) {
    mesh_.is_of_another_gear = true;
    error(place, message, hint);
  }

  /// Reads the number of a node type, cable or panel. Reports an error if the gear does not have it.
  int index_of_gear(const formats::Word& word, std::int64_t lo, std::size_t hi, const char* what) {
    const int errors_before = diagnostics_.errors(), value = index(word, lo, hi, what);
    if (diagnostics_.errors() > errors_before && formats::integer_in(word.text))
      mesh_.is_of_another_gear = true;
    return value;
  }

  /// Reads a whole number from `lo` to `hi`.
  int index(const formats::Word& word, std::int64_t lo, std::size_t hi, const char* what) {
    const auto value = formats::integer_in(word.text);
    if (value && *value >= lo && *value <= static_cast<std::int64_t>(hi)) return static_cast<int>(*value);
    error(word.place, std::string(what) + " " + std::string(word.text.substr(0, 30)) + " does not exist",
          hi == 0 ? "there are none" : "they are numbered 1 to " + std::to_string(hi));
    return 1;
  }
  std::uint32_t node(const formats::Word& word) {
    return static_cast<std::uint32_t>(index(word, 1, mesh_.nodes.size(), "node")) - 1;
  }

  void read_node(const Row& row) {
    MeshFile::Node n;
    for (std::size_t axis = 0; axis < 3; ++axis) n.at[axis] = real(row[1 + axis]);
    n.type = index_of_gear(row[5], 1, gear_.types.size(), "the type of nodes") - 1;
    if (is_fine()) mesh_.nodes.push_back(n);
  }

  void read_bar(const Row& row) {
    MeshFile::Bar b;
    b.nodes = {node(row[1]), node(row[2])};
    b.shares = {real(row[3]), real(row[4])};
    if (formats::integer_in(row[5].text) == 0)
      return error_of_gear(row[5].place, "this bar is of cable 0: the mesh is older than the .don",
                           "mesh the gear anew");
    b.cable =
        index_of_gear(row[5], -static_cast<std::int64_t>(gear_.panels.size()), gear_.cables.size(), "cable");
    if (is_fine() && b.nodes[0] == b.nodes[1]) error(row[1].place, "a bar begins and ends at the same node");
    if (is_fine() && b.cable > 0) check_shares(b, row);
    if (is_fine() && b.cable < 0) check_twines(b, row);
    if (is_fine()) mesh_.bars.push_back(b);
  }

  void check_shares(MeshFile::Bar& b, const Row& row) {
    auto& [from, to] = b.shares;
    if (from < -kShareRounding || to > 1 + kShareRounding || !(from < to))
      return error_of_gear(row[3].place,
                           "the shares of its cable between which this bar lies are " +
                               std::string(row[3].text.substr(0, 30)) + " and " +
                               std::string(row[4].text.substr(0, 30)) + "; they must grow from 0 to 1",
                           "the mesh may be older than the .don");
    from = std::max(from, 0.0);
    to = std::min(to, 1.0);
  }

  void check_twines(const MeshFile::Bar& b, const Row& row) {
    if (!(gear_.panels[static_cast<std::size_t>(-b.cable) - 1].twines > 0))
      error_of_gear(row[5].place,
                    "this bar represents twines of panel " + std::to_string(-b.cable) +
                        ", but the .don has no bars for that panel",
                    "it needs input netting2ropes " + std::to_string(-b.cable));
  }

  void read_triangle(const Row& row) {
    MeshFile::Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t.nodes[k] = node(row[1 + k]);
    for (std::size_t k = 0; k < 6; ++k) t.UV[k] = real(row[4 + k]);
    t.panel = index_of_gear(row[10], 1, gear_.panels.size(), "panel") - 1;
    const double d = (t.UV[2] - t.UV[0]) * (t.UV[5] - t.UV[1]) - (t.UV[4] - t.UV[0]) * (t.UV[3] - t.UV[1]);
    if (t.nodes[0] == t.nodes[1] || t.nodes[0] == t.nodes[2] || t.nodes[1] == t.nodes[2])
      error(row[1].place, "a corner of this triangle appears twice");
    else if (is_fine() && !(std::abs(d) > 1e-9))
      error(row[4].place, "the corners of this triangle lie on one line in meshes");
    if (is_fine()) mesh_.triangles.push_back(t);
  }

  formats::TextRows rows_;
  const GearFile& gear_;
  formats::Diagnostics& diagnostics_;
  int errors_before_;
  std::int64_t number_ = 0;
  MeshFile mesh_;
};

}  // namespace

MeshFile read_mesh_file(const std::string& text, int file, const GearFile& gear,
                        formats::Diagnostics& diagnostics) {
  return MeshFileReader(text, file, gear, diagnostics).read();
}

}  // namespace netloft::scenes::femnet
