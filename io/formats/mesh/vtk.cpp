// SPDX-License-Identifier: BSD-3-Clause
//
// Reads and writes VTK legacy files (Kitware, "VTK File Formats", simple legacy formats), in ASCII, with an
// unstructured grid.
#include "io/formats/mesh/mesh_builder.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/mesh/vtk_cells.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <array>

namespace netloft::formats {

namespace {

std::string in_capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

/// Reads one file; the member functions have the order of the blocks in a file.
class VtkReader {
 public:
  VtkReader(std::string_view text, int file, Diagnostics& diagnostics)
      : rows_(text, file), builder_(diagnostics) {}

  InputMesh read() {
    rows_.next_line();
    rows_.next_line();  // these two lines are the version and the title
    const Word form = next();
    if (in_capitals(form.text) != "ASCII")
      fail(form.place, "only VTK files in ASCII are read", "save it in the legacy ASCII format");
    for (Word word = next(); goes_on() && !word.text.empty(); word = next()) read_block(word);
    if (goes_on()) add_vtk_cells(cells_, place_of_cells_, builder_);
    return builder_.finish(rows_.place());
  }

 private:
  bool goes_on() const { return !has_failed_ && builder_.goes_on(); }
  void fail(const Place& place, const std::string& message, const std::string& hint = {}) {
    if (!has_failed_) builder_.error(place, message, hint);
    has_failed_ = true;
  }

  /// The next word on this or a later line; empty at the end.
  Word next() {
    if (at_ >= row_.size()) {
      row_ = rows_.next_row();
      at_ = 0;
    }
    return row_.empty() ? Word{{}, rows_.place()} : row_[at_++];
  }
  double next_number() {
    const Word word = next();
    const auto value = number_in(word.text);
    if (!value)
      fail(word.place,
           word.text.empty() ? "the file ends within its numbers" : in_quotes(word.text) + " is no number");
    return value.value_or(0);
  }
  std::size_t next_count(std::size_t most, const char* what) {
    const Word word = next();
    const auto value = integer_in(word.text);
    if (value && *value >= 0 && *value <= static_cast<std::int64_t>(most))
      return static_cast<std::size_t>(*value);
    fail(word.place, "the number of " + std::string(what) + " is " + in_quotes(word.text) +
                         "; it must be from 0 to " + std::to_string(most));
    return 0;
  }

  void read_block(const Word& word) {
    const std::string name = in_capitals(word.text);
    if (name == "DATASET")
      read_dataset(next());
    else if (name == "POINTS")
      read_points();
    else if (name == "CELLS")
      read_cells();
    else if (name == "CELL_TYPES")
      read_types();
    else if (name == "CELL_DATA") {
      next_count(kMostElements, "cells");
      is_on_cells_ = true;
    } else if (name == "POINT_DATA") {
      next_count(kMostNodes, "points");
      is_on_cells_ = false;
    } else if (name == "SCALARS")
      read_scalars();
    else if (name == "FIELD")
      read_field();
    else if (name == "METADATA")
      skip_metadata();
    else
      fail(word.place, in_quotes(word.text) + " is not read in a VTK file",
           "only an unstructured grid with SCALARS and FIELD arrays is read");
  }

  void read_dataset(const Word& kind) {
    if (in_capitals(kind.text) != "UNSTRUCTURED_GRID")
      fail(kind.place, "the data set is " + in_quotes(kind.text) + "; only an UNSTRUCTURED_GRID can be read");
  }

  void read_points() {
    const std::size_t count = next_count(kMostNodes, "points");
    next();  // skips the type
    for (std::size_t i = 0; i < 3 * count && goes_on(); ++i) {
      const Word word = next();
      if (word.text.empty()) return fail(word.place, "the file ends within its points");
      builder_.add_coordinate(builder_.real(word.text, word.place), word.place);
    }
    points_ = count;
  }

  /// Reads cells in the layout of version 5, OFFSETS and CONNECTIVITY, or in the older layout, in which each
  /// cell begins with its length.
  void read_cells() {
    const std::size_t first = next_count(8 * kMostElements, "cells"),
                      second = next_count(8 * kMostElements, "nodes");
    const Word word = next();
    place_of_cells_ = word.place;
    if (in_capitals(word.text) == "OFFSETS") return read_offsets(first, second);
    --at_;
    for (std::size_t c = 0; c < first && goes_on(); ++c) {
      const std::size_t length = next_count(second, "nodes of a cell");
      cells_.nodes.emplace_back();
      cells_.places.push_back(row_.empty() ? rows_.place() : row_[at_ - 1].place);
      for (std::size_t k = 0; k < length && goes_on(); ++k) cells_.nodes.back().push_back(next_node());
    }
  }

  void read_offsets(std::size_t offsets, std::size_t nodes) {
    next();  // skips the type
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < offsets && goes_on(); ++i)
      ends.push_back(next_count(nodes, "nodes before a cell"));
    next();
    next();  // these calls skip the word CONNECTIVITY and the type
    for (std::size_t c = 0; c + 1 < ends.size() && goes_on(); ++c) {
      cells_.nodes.emplace_back();
      if (ends[c + 1] < ends[c])
        return fail(place_of_cells_, "the offsets of cells decrease, which they must not");
      for (std::size_t k = ends[c]; k < ends[c + 1] && goes_on(); ++k)
        cells_.nodes.back().push_back(next_node());
      cells_.places.push_back(row_.empty() ? rows_.place() : row_[0].place);
    }
  }

  std::uint32_t next_node() {
    const Word word = next();
    const auto value = integer_in(word.text);
    if (value && *value >= 0 && *value < static_cast<std::int64_t>(points_))
      return static_cast<std::uint32_t>(*value);
    fail(word.place, "there is no node " + in_quotes(word.text),
         "points of this file are 0 to " + std::to_string(points_ ? points_ - 1 : 0));
    return 0;
  }

  void read_types() {
    const std::size_t count = next_count(kMostElements, "cells");
    for (std::size_t c = 0; c < count && goes_on(); ++c)
      cells_.types.push_back(static_cast<int>(next_number()));
  }

  void read_scalars() {
    const std::string name(next().text);
    next();  // skips the type
    std::size_t components = 1;
    Word word = next();
    if (const auto value = integer_in(word.text); value && *value >= 1 && *value <= 4) {
      components = static_cast<std::size_t>(*value);
      word = next();
    }
    if (in_capitals(word.text) != "LOOKUP_TABLE")
      return fail(word.place, "LOOKUP_TABLE is expected behind SCALARS");
    next();  // skips the name of the table
    read_values(name, components, is_on_cells_ ? cells_.nodes.size() : points_);
  }

  void read_field() {
    next();  // skips the name of the field
    const std::size_t arrays = next_count(1000, "arrays");
    for (std::size_t a = 0; a < arrays && goes_on(); ++a) {
      Word word = next();
      if (in_capitals(word.text) == "METADATA") {
        skip_metadata();
        word = next();
      }
      const std::string name(word.text);
      const std::size_t components = next_count(1000, "components"),
                        count = next_count(kMostElements, "values");
      if (in_capitals(next().text) != "STRING")
        read_values(name, components, count);
      else
        for (std::size_t i = 0; i < components * count && goes_on(); ++i) {
          const Word text = next();
          if (text.text.empty()) return fail(text.place, "the file ends within its texts");
          if (name == "region_names") cells_.names.emplace_back(text.text);
        }
    }
  }

  void read_values(const std::string& name, std::size_t components, std::size_t count) {
    VtkCells::Array array{components, {}};
    for (std::size_t i = 0; i < components * count && goes_on(); ++i) {
      const Word word = next();
      if (word.text.empty()) return fail(word.place, "the file ends within the array " + in_quotes(name));
      array.values.push_back(
          number_in(word.text).value_or(0));  // a word that is no number, such as nan, counts as 0
    }
    if (is_on_cells_) cells_.arrays[name] = std::move(array);
  }

  /// Skips metadata, such as names of components, up to a blank line.
  void skip_metadata() {
    row_.clear();
    at_ = 0;
    for (auto line = rows_.next_line(); line && line->find_first_not_of(" \t") != std::string_view::npos;)
      line = rows_.next_line();
  }

  TextRows rows_;
  MeshBuilder builder_;
  std::vector<Word> row_;
  std::size_t at_ = 0;
  bool has_failed_ = false, is_on_cells_ = false;
  std::size_t points_ = 0;
  Place place_of_cells_;
  VtkCells cells_;
};

/// Collects the cells of a mesh as the texts of their blocks.
class VtkWriter {
 public:
  std::string write(const InputMesh& mesh, const std::string& source) {
    for (const auto& region : mesh.regions) add_region(region);
    for (const auto& set : mesh.sets) add_set(set);
    std::string title = source.substr(0, source.find('\n')).substr(0, 200);
    std::string out = "# vtk DataFile Version 3.0\n" + (title.empty() ? "a mesh" : title) +
                      "\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nregion_names 1 " +
                      std::to_string(regions_) + " string\n" + names_ + "POINTS " +
                      std::to_string(mesh.node_count()) + " double\n";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      out += spell_number(mesh.positions[i]) + (i % 3 == 2 ? "\n" : " ");
    const std::string count = std::to_string(cells_);
    out += "CELLS " + count + " " + std::to_string(words_) + "\n" + nodes_ + "CELL_TYPES " + count + "\n" +
           types_ + "CELL_DATA " + count + "\nSCALARS region int 1\nLOOKUP_TABLE default\n" + region_ +
           "FIELD FieldData 3\npanel_corners 6 " + count + " double\n" + corners_ + "shares 2 " + count +
           " double\n" + shares_ + "twines 2 " + count + " double\n" + twines_;
    return out;
  }

 private:
  void begin(const std::string& name) {
    names_ += name + "\n";
    ++regions_;
  }

  void add_cell(int type, const std::uint32_t* nodes, std::size_t count) {
    nodes_ += std::to_string(count);
    for (std::size_t k = 0; k < count; ++k) nodes_ += " " + std::to_string(nodes[k]);
    nodes_ += "\n";
    words_ += count + 1;
    ++cells_;
    types_ += std::to_string(type) + "\n";
    region_ += std::to_string(regions_ - 1) + "\n";
  }

  static void add_numbers(std::string& block, const double* numbers, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      block += spell_number(numbers ? numbers[k] : 0) + (k + 1 < count ? " " : "\n");
  }

  void add_region(const MeshRegion& region) {
    begin(region.name);
    const bool is_netting = region.kind == RegionKind::triangles;
    for (std::size_t e = 0; e < region.size(); ++e) {
      const double* numbers = &region.numbers[e * numbers_in(region.kind)];
      add_cell(is_netting ? vtk::kTriangle : vtk::kLine, &region.nodes[e * nodes_in(region.kind)],
               nodes_in(region.kind));
      add_numbers(corners_, is_netting ? numbers : nullptr, 6);
      add_numbers(shares_, region.kind == RegionKind::bars ? numbers : nullptr, 2);
      add_numbers(twines_, region.kind == RegionKind::twines ? numbers : nullptr, 2);
    }
  }

  void add_set(const MeshSet& set) {
    begin(set.name);
    add_cell(vtk::kPolyVertex, set.nodes.data(), set.nodes.size());
    add_numbers(corners_, nullptr, 6);
    add_numbers(shares_, nullptr, 2);
    add_numbers(twines_, nullptr, 2);
  }

  std::string names_, nodes_, types_, region_, corners_, shares_, twines_;
  std::size_t regions_ = 0, cells_ = 0, words_ = 0;
};

}  // namespace

InputMesh read_vtk(std::string_view text, int file, Diagnostics& diagnostics) {
  return VtkReader(text, file, diagnostics).read();
}

std::string vtk_text(const InputMesh& mesh, const std::string& source) {
  return VtkWriter().write(mesh, source);
}

}  // namespace netloft::formats
