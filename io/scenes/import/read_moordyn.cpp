// SPDX-License-Identifier: BSD-3-Clause
//
// Reads an input file of MoorDyn. A line of dashes with a title begins each section. In all sections except
// options and outputs, the next two lines contain names and units of columns, which MoorDyn does not read.
//   density of a line  ρ = m/(π d²/4)   m [kg/m] mass, d [m] diameter                             (1)
//   tangential drag    C_t = π C_dAx    C_dAx refers to the surface π d, C_t to d                 (2)
//   bed under a line   k = k_bot d      k_bot [Pa/m]; a segment of length s has stiffness k s     (3)
#include "framework/scene/standard_gravity.hpp"
#include "io/formats/mesh/mesh.hpp"
#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/scenes/import/moordyn.hpp"
#include "io/scenes/import/moordyn_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace netloft::scenes {

namespace {

constexpr int kMostMoordynErrors = 50;
constexpr double kMostSegments = 1e5, kMostNodes = 1e6;
constexpr double kSeaWater = 1025, kBedStiffness = 3e6;  // defaults of MoorDyn [kg/m³], [Pa/m]

using Section = MoordynSection;

struct LineType {
  double diameter = 0, mass = 0, EA = 0, EI = 0, cd = 0, cd_axial = 0;
};

/// Reads one file. The member functions are the steps, in the order of execution.
class MooringReader {
 public:
  MooringReader(const std::string& text, int file, formats::Diagnostics& diagnostics)
      : rows_(text, file), diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {
    out_.table.gravity = kStandardGravity;
    out_.table.density = kSeaWater;
  }

  MooringFile read() {
    bool has_end = false;
    for (Row row = next_row(); !row.empty() && errors() < kMostMoordynErrors; row = next_row()) {
      const bool begins = is_title(row);
      has_end = begins || row[0].text == "END";
      begins ? begin(row) : read_row(row);
    }
    if (!has_end) note(rows_.place(), "the file does not end with a line of dashes: is it whole?");
    if (errors() == 0 && out_.table.ropes.empty())
      error(rows_.place(), "there are no lines",
            "a file of MoorDyn has the sections LINE TYPES, POINTS and LINES");
    if (errors() == 0) lay_on_bed();
    if (errors() == 0) add_tensions();
    return std::move(out_);
  }

 private:
  using Row = std::vector<formats::Word>;

  int errors() const { return diagnostics_.errors() - errors_before_; }
  void error(const formats::Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }
  void note(const formats::Place& place, const std::string& text) {
    out_.findings.push_back({place, false, text});
  }
  void leave_out(const formats::Place& place, const std::string& text) {
    out_.findings.push_back({place, true, text});
  }

  static std::string shown(const formats::Word& word) { return formats::in_quotes(word.text); }

  /// The next row without its comment, which begins with !, # or %.
  Row next_row() {
    for (Row row = rows_.next_row(); !row.empty(); row = rows_.next_row()) {
      const auto comment = std::find_if(row.begin(), row.end(), [](const formats::Word& w) {
        return w.text[0] == '!' || w.text[0] == '#' || w.text[0] == '%';
      });
      if (comment == row.begin()) continue;
      row.erase(comment, row.end());
      return row;
    }
    return {};
  }

  static bool is_title(const Row& row) { return row[0].text.starts_with("---"); }

  void begin(const Row& row) {
    std::string title;
    for (const auto& word : row) title += " " + in_capitals(word.text);
    section_ = section_named(title + " ");
    const bool has_words = title.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != title.npos;
    if (section_ == Section::other && has_words && section_before_ != Section::none &&
        title.find("NEED THIS LINE") == title.npos)
      leave_out(row[0].place, "the section" + title.substr(0, 60) + " is not read");
    if (section_ != Section::other) section_before_ = section_;
    names_ = section_ == Section::options || section_ == Section::outputs ? 0 : 2;
  }

  void read_row(const Row& row) {
    if (names_ > 0) return read_names(row);
    switch (section_) {
      case Section::line_types:
        return read_line_type(row);
      case Section::bodies:
        return read_body(row);
      case Section::rods:
        return leave_out(row[0].place,
                         "rod " + shown(row[0]) + ": scenes have no rods, and no line may end at one");
      case Section::points:
        return read_point(row);
      case Section::lines:
        return read_line(row);
      case Section::options:
        return read_option(row);
      case Section::outputs:
        return read_output(row);
      default:
        return;
    }
  }

  /// Reads a line with names of columns. In version 1 of the format, the length of a mooring line comes
  /// before its ends; in version 2, after them. The position of the column "UNSTR…" therefore shows the
  /// version. In version 1 a number of rows ("2 NTypes") may come before the names.
  void read_names(const Row& row) {
    if (names_ == 2 && formats::integer_in(row[0].text)) return;
    --names_;
    if (section_ != Section::lines || names_ != 1) return;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (in_capitals(row[i].text).find("UNSTR") == 0) length_column_ = i;
  }

  bool has_columns(const Row& row, std::size_t least, const char* columns) {
    if (row.size() >= least) return true;
    error(row[0].place,
          fmt::format("{} words are given here, and {} are needed: {}", row.size(), least, columns));
    return false;
  }

  double number(const formats::Word& word, const char* what, double lo, double hi) {
    const auto value = formats::number_in(word.text);
    if (!value)
      error(word.place, fmt::format("{} = {} is no number", what, shown(word)));
    else if (!(*value >= lo && *value <= hi))
      error(word.place, fmt::format("{} = {} is outside [{}, {}]", what, formats::spell_number(*value),
                                    formats::spell_number(lo), formats::spell_number(hi)));
    return value.value_or(0);
  }

  void read_line_type(const Row& row) {
    if (!has_columns(row, 9, "name, diameter, mass a metre, EA, damping, and coefficients")) return;
    const bool is_new = row.size() >= 10;
    LineType type;
    type.diameter = number(row[1], "the diameter of the line", 1e-6, 10);
    type.mass = number(row[2], "the mass of a metre of the line", 0, 1e6);
    if (!formats::number_in(row[3].text))
      error(row[3].place, "EA = " + shown(row[3]) + ": stiffness that is no single number cannot be imported",
            "write the stiffness at the working load");
    else
      type.EA = number(row[3], "EA", 0, 1e15);
    if (is_new) type.EI = number(row[5], "EI", 0, 1e12);
    type.cd = number(row[is_new ? 6 : 7], "the transverse drag coefficient", 0, 100);
    type.cd_axial = number(row[8], "the tangential drag coefficient", 0, 30);
    if (row.size() > 10 && formats::number_in(row[10].text) != 0.0)
      leave_out(row[10].place,
                "line type " + shown(row[0]) + ": lift by vortices, Cl = " + std::string(row[10].text));
    if (!line_types_.try_emplace(std::string(row[0].text), type).second)
      error(row[0].place, "there is a line type " + shown(row[0]) + " already");
  }

  /// Reads a body of MoorDyn. Points on bodies that do not move are imported; moving bodies are not, because
  /// they would have to become rigid bodies.
  void read_body(const Row& row) {
    if (!has_columns(row, 8, "number, attachment, X0 Y0 Z0, r0 p0 y0")) return;
    Body body{{}, in_capitals(row[1].text)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      body.at[axis] =
          number(row[2 + axis], "a coordinate of the body", -formats::kFarthest, formats::kFarthest);
    for (std::size_t axis = 0; axis < 3; ++axis)
      body.is_turned = body.is_turned || number(row[5 + axis], "an angle of the body", -360, 360) != 0;
    bodies_.try_emplace("BODY" + std::string(row[0].text), body);
  }

  void read_point(const Row& row) {
    if (!has_columns(row, 9, "number, attachment, X Y Z, mass, volume, CdA, Ca")) return;
    const bool has_forces = row.size() >= 12;  // columns of version 1
    TableNode n;
    n.name = "point-" + std::string(row[0].text);
    n.place = row[0].place;
    for (std::size_t axis = 0; axis < 3; ++axis)
      n.at[axis] =
          number(row[2 + axis], "a coordinate of the point", -formats::kFarthest, formats::kFarthest);
    attach(n, row[1]);
    const double mass = number(row[5], "the mass of the point", 0, 1e6),
                 volume = number(row[6], "the volume of the point", 0, 1e3);
    const double area = number(row[has_forces ? 10 : 7], "CdA of the point", 0, 1e3);
    if (n.hold.empty()) {
      n.mass = mass;
      n.volume = volume;
      n.drag_area = area;
    }
    for (std::size_t axis = 0; has_forces && axis < 3; ++axis)
      n.force[axis] = number(row[7 + axis], "a force on the point [N]", -1e9, 1e9);
    if (!formats::integer_in(row[0].text))
      return error(row[0].place, shown(row[0]) + " is no number of a point");
    if (!point_named_.try_emplace(std::string(row[0].text), out_.table.nodes.size()).second)
      return error(row[0].place, "there is a point " + shown(row[0]) + " already");
    out_.table.nodes.push_back(std::move(n));
  }

  void attach(TableNode& n, const formats::Word& word) {
    const std::string to = in_capitals(word.text);
    if (to == "FREE" || to == "POINT" || to == "CONNECT" || to == "CON") return;
    n.hold = "xyz";
    if (to == "FIXED" || to == "FIX" || to == "ANCHOR") return;
    if (to == "VESSEL" || to == "VES" || to == "COUPLED" || to == "CPLD")
      return note(word.place, n.name +
                                  " is held at its position, because the vessel to which it is coupled does "
                                  "not move in the scene");
    const auto body = bodies_.find(to);
    if (body == bodies_.end())
      return error(word.place, "the attachment " + shown(word) + " is not known",
                   "Fixed, Coupled, Vessel, Free, Connect, or Body1 of a body above");
    const std::string& own = body->second.attachment;
    if (own != "FIXED" && own != "COUPLED" && own != "VESSEL")
      return error(word.place, "bodies that move, such as " + shown(word) + ", cannot be imported",
                   "make the point Fixed, at the position that the body gives it");
    if (body->second.is_turned)
      return error(word.place, "bodies with a rotation, such as " + shown(word) + ", cannot be imported",
                   "make the point Fixed, at the position that the body gives it");
    for (std::size_t axis = 0; axis < 3; ++axis) n.at[axis] += body->second.at[axis];
  }

  void read_line(const Row& row) {
    if (!has_columns(row, 6, "number, type, ends, length, segments")) return;
    const bool is_old = length_column_ == 2;
    const auto type = line_types_.find(std::string(row[1].text));
    if (type == line_types_.end()) error(row[1].place, "there is no line type " + shown(row[1]));
    const double length = number(row[is_old ? 2 : 4], "the length of the line", 1e-6, formats::kFarthest);
    const double segments = number(row[is_old ? 3 : 5], "the number of segments", 1, kMostSegments);
    const auto from = point(row[is_old ? 4 : 2]), to = point(row[is_old ? 5 : 3]);
    if (!formats::integer_in(row[0].text)) error(row[0].place, shown(row[0]) + " is no number of a line");
    if (segments != std::floor(segments))
      error(row[is_old ? 3 : 5].place, "the number of segments is not whole");
    if (from && to && *from == *to) error(row[0].place, "the line begins and ends at the same point");
    if (static_cast<double>(out_.table.nodes.size()) + segments > kMostNodes)
      error(row[0].place, fmt::format("there are more than {:g} nodes", kMostNodes));
    if (errors() > 0) return;
    add_line("line-" + std::string(row[0].text), row[0].place, type->second, length,
             static_cast<int>(segments), {*from, *to});
  }

  std::optional<std::uint32_t> point(const formats::Word& word) {
    const auto known = point_named_.find(std::string(word.text));
    if (known != point_named_.end()) return static_cast<std::uint32_t>(known->second);
    const bool is_rod = word.text.starts_with("R") || word.text.starts_with("r");
    error(word.place, is_rod ? "lines that end at rods, such as " + shown(word) + ", cannot be imported"
                             : "there is no point " + shown(word));
    return {};
  }

  void add_line(const std::string& name, const formats::Place& place, const LineType& type, double length,
                int segments, std::array<std::uint32_t, 2> ends) {
    TableRope rope;
    rope.name = name;
    rope.place = place;
    rope.diameter = type.diameter;
    rope.EA = type.EA;
    rope.EI = type.EI;
    rope.density = type.mass / (std::numbers::pi * type.diameter * type.diameter / 4);  // (1)
    rope.normal = type.cd;
    rope.tangential = std::numbers::pi * type.cd_axial;  // (2)
    rope.bed = type.diameter;                            // (3) without k_bot, which is one of the options
    if (std::any_of(out_.table.ropes.begin(), out_.table.ropes.end(),
                    [&](auto& r) { return r.name == name; }))
      return error(place, "there is a line with this number already");
    std::uint32_t last = ends[0];
    for (int i = 1; i <= segments; ++i) {
      const std::uint32_t next =
          i < segments ? add_node(name, i, ends, double(i) / segments, length) : ends[1];
      rope.bars.push_back({{last, next}, length / segments});
      last = next;
    }
    out_.table.ropes.push_back(std::move(rope));
  }

  /// Adds a node of a mooring line. The initial shape of the line is a parabola whose length is nearly that
  /// of the line: d + 8 s²/(3 d), with the distance d [m] between the ends and the sag s [m].
  std::uint32_t add_node(const std::string& line, int number, std::array<std::uint32_t, 2> ends, double t,
                         double length) {
    const auto &a = out_.table.nodes[ends[0]].at, &b = out_.table.nodes[ends[1]].at;
    const double d = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const double sag = length > d ? std::min(std::sqrt(0.375 * d * (length - d)), length / 2) : 0;
    TableNode n;
    n.name = line + "-" + std::to_string(number);
    for (std::size_t axis = 0; axis < 3; ++axis) n.at[axis] = a[axis] + t * (b[axis] - a[axis]);
    n.at[2] -= 4 * t * (1 - t) * sag;
    lower_.push_back(static_cast<std::uint32_t>(out_.table.nodes.size()));
    out_.table.nodes.push_back(std::move(n));
    return lower_.back();
  }

  void read_option(const Row& row) {
    if (row.size() < 2)
      return leave_out(row[0].place,
                       shown(row[0]) + " is not an option: an option is a value, followed by a name");
    const std::string name = in_capitals(row[1].text);
    if (name == "G" || name == "GRAVITY")
      out_.table.gravity = number(row[0], "the gravity", 0, 100);
    else if (name == "RHO" || name == "RHOW" || name == "WTRDNSTY")
      out_.table.density = number(row[0], "the density of the water", 0, 1e5);
    else if (name == "KBOT" || name == "KB")
      bed_stiffness_ = number(row[0], "the stiffness of the bed", 0, 1e12);
    else if (name == "SEAFLOORFILE" || (name == "WTRDPTH" && !formats::number_in(row[0].text)))
      leave_out(row[0].place, "the bed is not a plane, and is not read");
    else if (name == "WTRDPTH")
      depth_ = number(row[0], "the depth of the water", 0, formats::kFarthest);
    else if (is_option_of_water(name))
      leave_out_water(row[0]);
    else
      leave_out_option(row, name);
  }

  void leave_out_water(const formats::Word& value) {
    if (formats::number_in(value.text) != 0.0)
      leave_out(value.place, "waves and currents are in other files, which are not read");
  }

  void leave_out_option(const Row& row, const std::string& name) {
    leave_out(row[0].place,
              fmt::format("the option {} = {}: {}", row[1].text, row[0].text,
                          meaning_of_option(name).value_or("it is not known here, and may be misspelt")));
  }

  void read_output(const Row& row) {
    for (const auto& word : row) {
      std::string text(word.text);
      std::erase(text, '"');
      const std::string name = in_capitals(text);
      if (name == "END") return;
      if (const auto tension = end_tension_named(name))
        wanted_.push_back({word.place, text, *tension});
      else
        leave_out(word.place, "the output " + formats::in_quotes(text) +
                                  ": the scene has tensions at ends of lines alone");
    }
  }

  /// Adds results for the tensions at ends of lines. As in MoorDyn, they are net forces on the nodes at the
  /// ends. Such an end must be held, and no other line may end there.
  void add_tensions() {
    std::map<std::uint32_t, int> lines_at;
    for (const auto& rope : out_.table.ropes)
      for (const auto end : {rope.bars.front().nodes[0], rope.bars.back().nodes[1]}) ++lines_at[end];
    const auto is_known = [&](std::uint32_t end) {
      return lines_at[end] == 1 && out_.table.nodes[end].hold == "xyz";
    };
    for (const auto& rope : out_.table.ropes) {
      const std::string number = rope.name.substr(rope.name.find('-') + 1);
      if (is_known(rope.bars.back().nodes[1]))
        out_.table.results.push_back({"FairTen" + number, rope.name + ".end", "reaction"});
      if (is_known(rope.bars.front().nodes[0]))
        out_.table.results.push_back({"AnchTen" + number, rope.name + ".start", "reaction"});
    }
    for (const auto& w : wanted_) report_unknown_tension(w);
  }

  struct Wanted {
    formats::Place place;
    std::string text;
    EndTension tension;
  };
  void report_unknown_tension(const Wanted& w) {
    const std::string name = (w.tension.is_at_start ? "AnchTen" : "FairTen") + w.tension.line;
    const auto& results = out_.table.results;
    if (std::ranges::find(results, name, &TableResult::name) != results.end()) return;
    leave_out(w.place, "the output " + formats::in_quotes(w.text) +
                           ": the line does not end there at a held point of its own; the result has the "
                           "tensions of all its bars");
  }

  void lay_on_bed() {
    out_.table.depth = depth_.value_or(0);
    for (auto& rope : out_.table.ropes) rope.bed = depth_ ? rope.bed * bed_stiffness_ : 0;
    if (!depth_) return note({}, "the depth of the water is not given, so there is no bed");
    for (const auto n : lower_) out_.table.nodes[n].at[2] = std::max(out_.table.nodes[n].at[2], -*depth_);
  }

  struct Body {
    std::array<double, 3> at{};
    std::string attachment;
    bool is_turned = false;
  };

  formats::TextRows rows_;
  formats::Diagnostics& diagnostics_;
  int errors_before_;
  MooringFile out_;
  Section section_ = Section::none, section_before_ = Section::none;
  int names_ = 0;  // how many more lines with names and units of columns follow
  std::size_t length_column_ = 4;
  std::map<std::string, LineType> line_types_;
  std::map<std::string, Body> bodies_;
  std::map<std::string, std::size_t> point_named_;
  std::vector<std::uint32_t> lower_;  // inner nodes of lines
  std::vector<Wanted> wanted_;        // outputs that the file requests
  std::optional<double> depth_;       // depth of the water [m]
  double bed_stiffness_ = kBedStiffness;
};

}  // namespace

MooringFile read_moordyn(const std::string& text, int file, formats::Diagnostics& diagnostics) {
  return MooringReader(text, file, diagnostics).read();
}

}  // namespace netloft::scenes
