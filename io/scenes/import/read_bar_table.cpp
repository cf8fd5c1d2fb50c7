// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/scenes/import/bar_table.hpp"
#include "io/scenes/import/csv_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace netloft::scenes {

namespace {

constexpr std::size_t kMostRows = 4000000;
constexpr int kMostErrors = 50;

/// A column that a table may have. A column without a unit contains words.
struct Column {
  const char *name, *unit, *doc;
  double lo = 0, hi = 0;
  bool is_needed = false;
};

enum NodeColumn { kNode, kX, kY, kZ, kHold, kMass, kBuoyancy, kForceX, kForceY, kForceZ };
constexpr Column kNodeColumns[] = {
    {"node", "", "name of the node"},
    {"x", "m", "initial position of the node", -formats::kFarthest, formats::kFarthest, true},
    {"y", "m", "initial position of the node", -formats::kFarthest, formats::kFarthest, true},
    {"z", "m", "initial position of the node, up from the surface", -formats::kFarthest, formats::kFarthest,
     true},
    {"hold", "", "axes along which the node is held"},
    {"mass", "kg", "mass in air, without buoyancy, as of steel or lead", 0, 1e6},
    {"buoyancy", "N", "net upward force in water", -1e7, 1e7},
    {"fx", "N", "constant force on the node", -1e9, 1e9},
    {"fy", "N", "constant force on the node", -1e9, 1e9},
    {"fz", "N", "constant force on the node", -1e9, 1e9}};

enum BarColumn {
  kBar,
  kFrom,
  kTo,
  kLength,
  kDiameter,
  kEA,
  kCompression,
  kDensity,
  kEI,
  kNormal,
  kTangential
};
constexpr Column kBarColumns[] = {
    {"bar", "", "name of the rope to which the bar belongs"},
    {"from", "", "node", 0, 0, true},
    {"to", "", "node", 0, 0, true},
    {"length", "m", "unstretched length; blank: distance of the nodes", 1e-6, 1e6},
    {"diameter", "m", "diameter of the rope", 0, 10, true},
    {"EA", "N", "axial stiffness", 0, 1e15, true},
    {"EA_compression", "N", "axial stiffness when slack", 0, 1e15},
    {"density", "kg/m3", "density of the material of the rope", 0, 1e6, true},
    {"EI", "N m2", "bending stiffness", 0, 1e12},
    {"normal_drag", "1", "drag coefficient across the rope", 0, 100},
    {"tangential_drag", "1", "drag coefficient along the rope", 0, 100}};

bool may_stand_in_a_name(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
}

/// Reads one table of nodes and bars. The member functions are the steps, in the order of execution.
class TableOfBars {
 public:
  TableOfBars(const std::string& text, int file, formats::Diagnostics& diagnostics)
      : rows_(text, file), diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {}

  BarTable read() {
    std::size_t count = 0;
    for (auto row = rows_.next(); !row.empty() && errors() < kMostErrors && !has_no_head_;
         row = rows_.next()) {
      if (++count > kMostRows) {
        error(row[0].place, fmt::format("there are more than {} rows", kMostRows));
        break;
      }
      read_row(row);
    }
    if (rows_.ended_in_quotes()) error(rows_.place(), "a quote is opened and not closed");
    if (errors() == 0 && table_.nodes.empty()) error(rows_.place(), "the table has no nodes", kHeads);
    if (errors() == 0 && table_.ropes.empty()) error(rows_.place(), "the table has no bars", kHeads);
    if (errors() == 0) check_ends();
    return std::move(table_);
  }

 private:
  using Row = std::vector<CsvCell>;
  static constexpr const char* kHeads =
      "write rows of nodes below the line node,x,y,z and rows of bars below bar,from,to,diameter,EA,density";

  int errors() const { return diagnostics_.errors() - errors_before_; }
  void error(const formats::Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }

  void read_row(const Row& row) {
    if (row[0].text == "node")
      read_head(row, kNodeColumns);
    else if (row[0].text == "bar")
      read_head(row, kBarColumns);
    else if (!head_) {
      has_no_head_ = true;
      error(row[0].place, "the first line names the columns, and begins with node or bar", kHeads);
    } else if (has_columns(row))
      head_ == kNodeColumns ? read_node(row) : read_bar(row);
  }

  /// Reads the line of column names, such as `EA` or `EA [N]`, which may be in any order.
  template <std::size_t N>
  void read_head(const Row& row, const Column (&columns)[N]) {
    head_ = columns;
    where_.assign(N, 0);
    width_ = row.size();
    is_known_.assign(N, false);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto bracket = row[i].text.find('[');
      std::string name = row[i].text.substr(0, bracket);
      while (name.ends_with(' ')) name.pop_back();
      const auto at = std::find_if(columns, columns + N, [&](const Column& c) { return name == c.name; });
      if (at == columns + N) {
        error(row[i].place, "there is no column " + formats::in_quotes(name), names_of(columns, columns + N));
        continue;
      }
      const auto column = static_cast<std::size_t>(at - columns);
      if (is_known_[column]) error(row[i].place, "the column " + name + " appears twice");
      if (bracket != std::string::npos) check_unit(row[i], row[i].text.substr(bracket), *at);
      is_known_[column] = true;
      where_[column] = i;
    }
    for (std::size_t c = 0; c < N; ++c)
      if (columns[c].is_needed && !is_known_[c])
        error(row[0].place, fmt::format("the column {} is missing ({})", columns[c].name, columns[c].doc));
  }

  static std::string names_of(const Column* begin, const Column* end) {
    std::string names;
    for (auto c = begin; c != end; ++c) names += (names.empty() ? "there are " : ", ") + std::string(c->name);
    return names;
  }

  void check_unit(const CsvCell& cell, const std::string& unit, const Column& column) {
    const std::string wanted = fmt::format("[{}]", column.unit);
    if (unit != wanted)
      error(cell.place, fmt::format("{} must be in {}, not in {}", column.name, wanted, unit.substr(0, 20)),
            "convert the numbers; units are not read");
  }

  bool has_columns(const Row& row) {
    if (row.size() == width_) return true;
    const auto is_blank = [](const CsvCell& c) { return c.text.empty(); };
    if (row.size() < width_) {
      error(row[0].place,
            fmt::format("this row has {} cells, but the line of names has {}", row.size(), width_),
            "blank cells are written, too: a,,b");
      return false;
    }
    if (std::all_of(row.begin() + static_cast<std::ptrdiff_t>(width_), row.end(), is_blank)) return true;
    error(row[width_].place, fmt::format("this is cell {} of a row of {}", width_ + 1, width_),
          "a comma is no decimal point; write 1.5");
    return false;
  }

  const CsvCell* cell(const Row& row, std::size_t column) const {
    return is_known_[column] && !row[where_[column]].text.empty() ? &row[where_[column]] : nullptr;
  }

  std::optional<double> number(const Row& row, std::size_t column) {
    const CsvCell* c = cell(row, column);
    const Column& spec = head_[column];
    if (!c && spec.is_needed) error(row[0].place, fmt::format("{} is blank ({})", spec.name, spec.doc));
    if (!c) return {};
    const auto value = formats::number_in(c->text);
    if (!value)
      error(c->place,
            fmt::format("{} = {} is no number ({})", spec.name, formats::in_quotes(c->text), spec.doc));
    else if (!(*value >= spec.lo && *value <= spec.hi))
      error(c->place,
            fmt::format("{} = {} {} is outside [{}, {}] ({})", spec.name, formats::spell_number(*value),
                        spec.unit, formats::spell_number(spec.lo), formats::spell_number(spec.hi), spec.doc));
    return value;
  }
  double number_or_zero(const Row& row, std::size_t column) { return number(row, column).value_or(0); }

  std::string name_in(const Row& row) {
    const std::string& name = row[where_[0]].text;
    if (name.empty() || !std::all_of(name.begin(), name.end(), may_stand_in_a_name))
      error(row[where_[0]].place, formats::in_quotes(name) + " is no name",
            "names are letters, digits, - and _");
    return name;
  }

  void read_node(const Row& row) {
    TableNode n;
    n.name = name_in(row);
    n.place = row[where_[0]].place;
    n.at = {number_or_zero(row, kX), number_or_zero(row, kY), number_or_zero(row, kZ)};
    n.force = {number_or_zero(row, kForceX), number_or_zero(row, kForceY), number_or_zero(row, kForceZ)};
    n.mass = number_or_zero(row, kMass);
    n.buoyancy = number_or_zero(row, kBuoyancy);
    if (n.mass != 0 && n.buoyancy != 0)
      error(cell(row, kMass)->place,
            "this node has a mass and a buoyancy; the buoyancy is a net force that includes the weight",
            "leave one of them blank");
    if (const CsvCell* hold = cell(row, kHold)) n.hold = axes_in(*hold);
    if (!node_named_.try_emplace(n.name, table_.nodes.size()).second)
      error(n.place, "there is a node " + formats::in_quotes(n.name) + " already");
    table_.nodes.push_back(std::move(n));
  }

  std::string axes_in(const CsvCell& cell) {
    std::string axes;
    for (const char axis : {'x', 'y', 'z'})
      if (cell.text.find(axis) != std::string::npos) axes += axis;
    if (axes.size() != cell.text.size())
      error(cell.place, "hold = " + formats::in_quotes(cell.text) + " is not understood",
            "the axes along which the node is held, such as xyz or z; blank: none");
    return axes;
  }

  void read_bar(const Row& row) {
    TableRope rope;
    rope.name = name_in(row);
    rope.place = row[where_[0]].place;
    rope.diameter = number_or_zero(row, kDiameter);
    rope.EA = number_or_zero(row, kEA);
    rope.density = number_or_zero(row, kDensity);
    rope.EI = number_or_zero(row, kEI);
    rope.EA_compression = number(row, kCompression);
    rope.normal = number(row, kNormal);
    rope.tangential = number(row, kTangential);
    if (rope.normal.has_value() != rope.tangential.has_value())
      error(row[0].place, "only one of normal_drag and tangential_drag is given; give both or neither");
    const auto length = number(row, kLength);
    const auto from = node_in(row, kFrom), to = node_in(row, kTo);
    if (!from || !to || errors() > 0) return;
    if (*from == *to) return error(cell(row, kTo)->place, "the bar begins and ends at the same node");
    const double drawn = distance(*from, *to);
    if (!length && !(drawn > 1e-6))
      return error(row[0].place, "length is blank, and the nodes are in one place");
    rope_of(rope).bars.push_back(
        {{static_cast<std::uint32_t>(*from), static_cast<std::uint32_t>(*to)}, length.value_or(drawn)});
  }

  /// Returns the rope with the name of `rope`; adds it if there is none. Reports properties that differ from
  /// those in the first row of this rope.
  TableRope& rope_of(const TableRope& rope) {
    const auto [known, is_new] = rope_named_.try_emplace(rope.name, table_.ropes.size());
    if (is_new) table_.ropes.push_back(rope);
    TableRope& first = table_.ropes[known->second];
    const auto numbers = [](const TableRope& r) {
      return std::tuple(r.diameter, r.EA, r.density, r.EI, r.EA_compression, r.normal, r.tangential);
    };
    if (numbers(first) != numbers(rope))
      error(rope.place,
            fmt::format("the rope {} has different properties here than in line {}",
                        formats::in_quotes(rope.name), first.place.line),
            "all bars of a rope must have the same properties; give these bars another name");
    return first;
  }

  std::optional<std::size_t> node_in(const Row& row, std::size_t column) {
    const CsvCell* c = cell(row, column);
    if (!c) error(row[0].place, fmt::format("{} is blank: the bar has no end there", head_[column].name));
    if (!c) return {};
    const auto known = node_named_.find(c->text);
    if (known != node_named_.end()) return known->second;
    error(c->place, "there is no node " + formats::in_quotes(c->text) + " above this line",
          "write nodes before the bars that end there");
    return {};
  }

  /// Checks that at least one bar ends at every node. Nodes without bars are a sign of a truncated file, and
  /// holds and loads could not act on them.
  void check_ends() {
    std::vector<bool> is_used(table_.nodes.size());
    for (const auto& rope : table_.ropes)
      for (const auto& bar : rope.bars) is_used[bar.nodes[0]] = is_used[bar.nodes[1]] = true;
    for (std::size_t i = 0; i < is_used.size(); ++i) {
      const TableNode& n = table_.nodes[i];
      if (!is_used[i] && errors() < kMostErrors)
        error(n.place, "no bar ends at the node " + formats::in_quotes(n.name),
              "leave it out, or connect it");
    }
  }

  double distance(std::size_t a, std::size_t b) const {
    const auto &p = table_.nodes[a].at, &q = table_.nodes[b].at;
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }

  CsvRows rows_;
  formats::Diagnostics& diagnostics_;
  int errors_before_;
  BarTable table_;
  const Column* head_ = nullptr;  // columns of the rows that are being read
  bool has_no_head_ = false;
  std::size_t width_ = 0;
  std::vector<std::size_t> where_;  // for each column: its position in a row
  std::vector<bool> is_known_;      // whether the table has each column
  std::map<std::string, std::size_t> node_named_, rope_named_;
};

}  // namespace

BarTable read_bar_table(const std::string& text, int file, formats::Diagnostics& diagnostics) {
  return TableOfBars(text, file, diagnostics).read();
}

}  // namespace netloft::scenes
