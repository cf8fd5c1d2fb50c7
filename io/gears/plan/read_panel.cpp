// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/part_choice.hpp"
#include "io/gears/plan/plan_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::gears {

namespace {

double read_meshes(formats::TableReader& table, const char* key, const char* doc) {
  return table.real(key, {.unit = "1", .doc = doc, .range = formats::between(0, kMostMeshes)});
}

/// Reads `fore = 3`, or a list of named counts.
std::vector<MeshCount> read_counts(formats::TableReader& table, const char* key) {
  if (table.kind(key) != formats::Kind::array)
    return {{key, read_meshes(table, key, "meshes along this edge"), table.place(key)}};
  std::vector<MeshCount> counts;
  for (auto& entry : table.tables(key)) {
    MeshCount count;
    count.name = entry.text("name", {.doc = "name of this stretch of the edge"});
    count.meshes = read_meshes(entry, "meshes", "meshes along this stretch");
    count.place = entry.place("name");
    counts.push_back(std::move(count));
  }
  return counts;
}

// The functions below read sides.

struct CutText {
  std::string rate, direction;
};

/// Splits a text such as "5B1P in" into rate and direction.
CutText split_cut(const std::string& written) {
  const auto space = written.find(' ');
  if (space == std::string::npos) return {written, ""};
  const auto word = written.find_first_not_of(' ', space);
  return {written.substr(0, space), word == std::string::npos ? "" : written.substr(word)};
}

void read_direction(Cut& cut, const std::string& direction, formats::TableReader& table, const char* key) {
  if (direction == "in" || direction == "out")
    cut.goes = direction == "in" ? -1 : 1;
  else if (!direction.empty())
    table.error(key, "\"" + direction + "\" is not a direction",
                "\"in\" where the panel becomes narrower going aft, \"out\" where it becomes wider");
  else if (cut.is_known && !cut.rate.is_straight())
    table.error(key, "does not contain the direction of \"" + cut.written + "\", in or out",
                "write \"" + cut.written + " in\" where the panel becomes narrower going aft, else \"" +
                    cut.written + " out\"");
}

/// Reads a rate. If the text is not a rate, check_plan() proposes one that fits the whole panel.
void read_rate(Cut& cut, formats::TableReader& table, const char* key) {
  const auto words = split_cut(table.text(key, {.doc = "cutting rate and direction, such as \"5B1P in\""}));
  cut.written = words.rate;
  cut.place = table.place(key);
  if (const auto rate = parse_rate(words.rate))
    cut.rate = *rate;
  else {
    cut.is_known = false;
    cut.rate = {.points = 1};
  }
  read_direction(cut, words.direction, table, key);
}

bool goes_across_only(const Cut& cut) { return cut.is_known && cut.rate.half_meshes_deep() == 0; }

void read_extent(Cut& cut, formats::TableReader& table) {
  if (table.has("meshes"))
    cut.said_across = read_meshes(table, "meshes", "meshes that the cut goes sideways");
  if (table.has("depth")) cut.said_deep = read_meshes(table, "depth", "meshes that the cut goes aft");
}

/// Whether the two numbers that a plan states for a cut agree with its rate.
bool agrees(const Cut& cut) {
  const double across = cut.rate.across(*cut.said_deep);
  return std::abs(across - *cut.said_across) <= std::max(1.0, 0.03 * *cut.said_across);
}

void check_extent(const Cut& cut, formats::TableReader& table) {
  if (!cut.is_known) return;
  if (goes_across_only(cut) && !cut.said_across)
    table.error("meshes", "is missing: a cut " + cut.written + " has no depth");
  else if (goes_across_only(cut) && cut.said_deep)
    table.error("depth", "a cut " + cut.written + " has no depth", "leave depth out");
  else if (cut.rate.is_straight() && cut.said_across)
    table.error("meshes", "a cut " + cut.written + " does not go sideways", "give depth instead");
  else if (cut.said_across && cut.said_deep && !agrees(cut))
    table.error("meshes", "is not the number that " + cut.written + " gives over this depth",
                "leave out either of meshes and depth");
}

Cut read_cut(formats::TableReader& table, const std::string& default_name) {
  Cut cut;
  cut.name = table.text("name", {.doc = "name of this stretch of the side", .fallback = default_name});
  read_rate(cut, table, "cut");
  read_extent(cut, table);
  check_extent(cut, table);
  return cut;
}

bool is_open(const Cut& cut) { return !cut.said_across && !cut.said_deep && !goes_across_only(cut); }

std::vector<Cut> read_whole_side(formats::TableReader& table, const char* key) {
  Cut cut;
  cut.name = key;
  read_rate(cut, table, key);
  if (goes_across_only(cut)) table.error(key, "goes across only, so that the side has no depth");
  return {cut};
}

/// The straight side of a tube for which the plan states no cuts.
Cut straight_cut(const char* key, const formats::Place& place) {
  Cut cut;
  cut.name = key;
  cut.written = "AN";
  cut.rate = {.points = 1};
  cut.place = place;
  return cut;
}

std::vector<Cut> read_side(formats::TableReader& table, const char* key, double depth,
                           bool may_be_straight = false) {
  std::vector<Cut> side;
  if (may_be_straight && !table.has(key)) {
    side = {straight_cut(key, table.place())};
  } else if (table.kind(key) == formats::Kind::text) {
    side = read_whole_side(table, key);
  } else {
    for (auto& entry : table.tables(key, formats::Presence::required, "cuts going aft, such as \"5B1P in\""))
      side.push_back(read_cut(entry, std::string(key) + "-" + std::to_string(side.size() + 1)));
    if (table.kind(key) == formats::Kind::array && side.empty())
      table.error(key, "is empty: give at least one cut");
  }
  if (std::count_if(side.begin(), side.end(), is_open) > 1)
    table.error(key, "more than one of its cuts has neither meshes nor depth");
  settle(side, depth);
  return side;
}

void read_sides(Panel& panel, formats::TableReader& table) {
  if (panel.stands == Standing::middle) {
    panel.outer = read_side(table, "sides", panel.depth, panel.is_round);
    return;
  }
  panel.outer = read_side(table, "outer", panel.depth);
  panel.inner = read_side(table, "inner", panel.depth);
}

// The functions below read the netting.

const std::vector<std::string>& orientations() {
  static const std::vector<std::string> words = {"diamond", "t90", "square"};
  return words;
}

/// Reads a catalogue entry such as `netting = "83-112-fore"`, which provides mesh and twine unless the plan
/// states them; nullptr if there is none.
const CataloguePart* read_netting(formats::TableReader& table, const Catalogue& catalogue) {
  const formats::Value* said = table.raw("netting");
  return said ? choose_part(*said, {"netting"}, table.path("netting"), catalogue, table.diagnostics())
              : nullptr;
}

ChosenPart twine_of(const CataloguePart& netting, const formats::Place& place, const Catalogue& catalogue) {
  const std::string& name = netting.texts.at("twine");
  const CataloguePart* twine = catalogue.find(name, {"twine"});
  if (!twine) return {name, {place, formats::Table{}}};
  return {name, spell_out({place, name}, *twine, [](const std::string&) { return true; })};
}

double diameter_of(const formats::Value& twine, const std::string& path, formats::Diagnostics& diagnostics) {
  if (!twine.as<formats::Table>()) return 0;
  formats::TableReader reader(twine, diagnostics, path);
  return reader.has("diameter") ? reader.real("diameter", {.unit = "m", .range = formats::between(0, 1)}) : 0;
}

/// Refuses a mesh size without a unit if the number is so large that it must be in millimetres. Meshes of
/// several metres exist in the fore parts of pelagic trawls; they have to be written with a unit.
void check_unit(const Panel& panel, formats::TableReader& table) {
  constexpr double kLarge = 2;  // [m]
  const formats::Value* written = table.raw("mesh");
  const double* real = written ? written->as<double>() : nullptr;
  const std::int64_t* whole = written ? written->as<std::int64_t>() : nullptr;
  const double number = real ? *real : whole ? static_cast<double>(*whole) : 0;
  if (number < kLarge || number != panel.mesh) return;  // a number out of range has been reported before
  table.error(
      "mesh",
      fmt::format("{:g} means meshes of {:g} m, because numbers without a unit are in metres", panel.mesh,
                  panel.mesh),
      fmt::format("write mesh = \"{:g} mm\", or \"{:g} m\" if that is meant", panel.mesh, panel.mesh));
}

void read_material(Panel& panel, formats::TableReader& table, const Catalogue& catalogue) {
  const CataloguePart* netting = read_netting(table, catalogue);
  if (table.has("mesh") || !netting) {
    panel.mesh =
        table.real("mesh", {.unit = "m", .doc = "stretched mesh size", .range = formats::between(1e-4, 100)});
    check_unit(panel, table);
  } else
    panel.mesh = netting->numbers.at("mesh");
  ChosenPart twine = table.has("twine") || !netting ? read_part_choice(table, "twine", "twine", catalogue)
                                                    : twine_of(*netting, table.place("netting"), catalogue);
  panel.twine_name = std::move(twine.name);
  panel.twine = std::move(twine.table);
  panel.twine_diameter = diameter_of(panel.twine, table.path("twine"), table.diagnostics());
  panel.twines = static_cast<int>(
      table.integer("twines", {.doc = "twines side by side in every bar", .lo = 1, .hi = 9, .fallback = 1}));
  panel.orientation = table.choice(
      "orientation", {.allowed = orientations(), .doc = "orientation of the meshes", .fallback = "diamond"});
}

/// Reads the angle of the netting. Netting of a middle panel can be turned only by multiples of 45 degrees,
/// so that it is the same to port and to starboard.
void read_angle(Panel& panel, formats::TableReader& table) {
  panel.angle = table.real("angle", {.unit = "rad",
                                     .doc = "angle by which the netting is turned, from outwards towards aft",
                                     .range = formats::between(-std::numbers::pi, std::numbers::pi),
                                     .fallback = 0.0});
  const double eighths = panel.angle / (std::numbers::pi / 4);
  if (panel.stands == Standing::middle && std::abs(eighths - std::round(eighths)) > 1e-9)
    table.error(
        "angle", "the netting of a panel in the middle would differ to port and to starboard",
        "give a multiple of 45 deg, or stands = \"pair\" and both sewn together in the middle: edges = "
        "[\"" +
            panel.name + ".inner\", \"" + panel.name + ".inner\"]");
}

/// Reads `fore`, or `round`, which is the number of meshes round a tube.
void read_fore(Panel& panel, formats::TableReader& table) {
  panel.is_round = table.has("round");
  panel.fore = read_counts(table, panel.is_round ? "round" : "fore");
  if (!panel.is_round) return;
  for (auto& count : panel.fore)
    if (count.name == "round") count.name = "fore";
  if (table.has("fore"))
    table.error("fore", "cannot be combined with round, which has the same meaning", "leave out either");
  if (panel.stands != Standing::middle)
    table.error("round", "a tube is always across the plane of symmetry",
                "leave out stands, or write fore for round");
}

/// Reads the depth of a panel: the depth of one piece times the number of pieces in a row.
void read_depth(Panel& panel, formats::TableReader& table) {
  panel.depth = table.real(
      "depth", {.unit = "1", .doc = "meshes from the fore to the aft edge", .range = {0, kMostMeshes, true}});
  panel.pieces = static_cast<int>(table.integer(
      "pieces", {.doc = "number of pieces of this depth in a row", .lo = 1, .hi = 100, .fallback = 1}));
  panel.depth *= panel.pieces;
}

void check_pieces_in_a_row(const Panel& panel, formats::TableReader& table) {
  for (const auto* side : {&panel.outer, &panel.inner})
    for (const auto& cut : *side)
      if (panel.pieces > 1 && !cut.rate.is_straight())
        return table.error("pieces",
                           "pieces in a row have the same number of meshes, so their sides are straight, AN",
                           "write a panel for each, with its own counts");
}

/// Reads `open = "aft"`, or an array of edges.
std::vector<OpenEdge> read_open(formats::TableReader& table) {
  const formats::Value* said = table.raw("open");
  if (!said) return {};
  if (const auto* name = said->as<std::string>()) return {{*name, said->place}};
  const formats::Array* array = said->as<formats::Array>();
  std::vector<OpenEdge> open;
  if (array)
    for (const auto& item : array->items)
      if (const auto* name = item.as<std::string>()) open.push_back({*name, item.place});
  if (!array || open.size() != array->items.size())
    table.error("open", "give the name of an edge of the panel that stays open, or an array of names",
                "such as open = [\"aft\"]");
  return open;
}

void read_sketch(Panel& panel, formats::TableReader& table) {
  if (!table.has("sketch")) return;
  for (const auto& row : table.rows("sketch", {.unit = "m",
                                              .doc = "corners: fore inner, fore outer, aft outer, aft inner",
                                              .range = formats::between(-1e6, 1e6),
                                              .rows = formats::exactly(4),
                                              .columns = formats::exactly(3)}))
    if (row.size() == 3) panel.sketch.push_back({row[0], row[1], row[2]});
  if (panel.sketch.size() != 4) panel.sketch.clear();
}

void read_counts_and_cuttings(Panel& panel, formats::TableReader& table) {
  read_depth(panel, table);
  read_fore(panel, table);
  read_sides(panel, table);
  check_pieces_in_a_row(panel, table);
  panel.states_aft = table.has("aft");
  panel.aft_place = table.place("aft");
  if (panel.states_aft) panel.aft = read_counts(table, "aft");
}

}  // namespace

ChosenPart read_part_choice(formats::TableReader& table, const char* key, const char* kind_key,
                            const Catalogue& catalogue) {
  const formats::Value* said = table.raw(key);
  if (!said) {
    table.table(key, formats::Presence::required, "the name of a part of the catalogue, or a table");
    return {"", {table.place(), formats::Table{}}};
  }
  if (!names_a_part(*said)) {
    if (said->kind() != formats::Kind::table)
      table.error(key, "give the name of a part of the catalogue, or a table");
    if (const formats::Table* numbers = said->as<formats::Table>(); numbers && numbers->members.empty())
      table.error(key, "is an empty table", "give its numbers, or the name of a part of the catalogue");
    return {"", said->kind() == formats::Kind::table ? *said : formats::Value{said->place, formats::Table{}}};
  }
  const CataloguePart* part =
      choose_part(*said, kinds_under(kind_key), table.path(key), catalogue, table.diagnostics());
  if (!part) return {"", {said->place, formats::Table{}}};
  return {part->name, spell_out(*said, *part, [](const std::string&) { return true; })};
}

Standing read_standing(formats::TableReader& table, const char* fallback) {
  const std::string word = table.choice("stands", {.allowed = {"alone", "pair", "middle"},
                                                   .doc = "place relative to the plane of symmetry",
                                                   .fallback = fallback});
  return word == "pair" ? Standing::pair : word == "middle" ? Standing::middle : Standing::alone;
}

Panel read_panel(const std::string& name, formats::TableReader& table, const Catalogue& catalogue) {
  Panel panel;
  panel.name = name;
  panel.place = table.place();
  panel.stands = read_standing(table, "middle");
  table.has("corners") ? read_corners(panel, table) : read_counts_and_cuttings(panel, table);
  read_material(panel, table, catalogue);
  read_angle(panel, table);
  panel.open = read_open(table);
  read_sketch(panel, table);
  return panel;
}

}  // namespace netloft::gears
