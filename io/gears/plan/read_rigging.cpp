// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/plan_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace netloft::gears {

namespace {

constexpr double kLongest = 1e5;  // [m]
constexpr double kMostPieces = 1e5;
const formats::Range kPlaces = formats::between(-1e6, 1e6);

double read_length(formats::TableReader& table, const char* key, const char* doc) {
  return table.real(key, {.unit = "m", .doc = doc, .range = {0, kLongest, true}});
}

/// Reads one name, or several in a row.
std::vector<std::string> read_row(const formats::Value& said, const std::string& path,
                                  formats::Diagnostics& diagnostics) {
  if (const std::string* name = said.as<std::string>()) return {*name};
  std::vector<std::string> names;
  const formats::Array* array = said.as<formats::Array>();
  if (array)
    for (const auto& item : array->items)
      if (const std::string* name = item.as<std::string>()) names.push_back(*name);
  if (!array || names.size() != array->items.size() || names.empty())
    diagnostics.error(said.place, path + ": give the name of an edge, or an array of edges in a row");
  return names;
}

/// Splits a text such as "47 along headrope" or "2 at footrope.end". If the key `number` says how many, the
/// text need not begin with a number, and its number is ignored.
bool split_spread(const std::string& text, Pieces& pieces) {
  const auto* end = text.data() + text.size();
  double number = 0;
  const auto [after, error] = std::from_chars(text.data(), end, number);
  const bool is_counted = error == std::errc();
  const std::string rest = is_counted ? std::string(after, end) : " " + text;
  constexpr std::string_view kAlong = " along ", kAt = " at ";
  if (is_counted ? !(number > 0) || number > kMostPieces : !pieces.has_number) return false;
  pieces.number = number;
  if (rest.starts_with(kAlong)) pieces.along = rest.substr(kAlong.size());
  if (rest.starts_with(kAt)) pieces.at = rest.substr(kAt.size());
  return !pieces.along.empty() || !pieces.at.empty();
}

/// Refuses a point of a pair if it is to port, and a point in the middle if it is not on the plane of
/// symmetry.
void check_side(const Point& point, formats::TableReader& table) {
  const double y = (*point.at)[1];
  if (point.stands == Standing::pair && y < 0)
    table.error("at", "is to port, y < 0",
                "for a pair, give the point to starboard; the other is its mirror image");
  if (point.stands == Standing::middle && y != 0)
    table.error("at", "is not on the plane of symmetry, y = 0",
                "stands = \"pair\", if there is one to port and one to starboard");
}

/// Reads a role such as `role = "headline"`. Without the key, the name of a rope is its role if it is one of
/// the roles; a headline or footrope must then also run across the middle.
void read_role(Rope& rope, formats::TableReader& table) {
  const auto& words = rope_roles();
  const bool says = table.has("role");
  if (says) rope.role = table.choice("role", {.allowed = words, .doc = "role of the rope in the gear"});
  if (!says && std::find(words.begin(), words.end(), rope.name) != words.end()) rope.role = rope.name;
  const bool is_line_of_mouth = rope.role == "headline" || rope.role == "footrope";
  rope.role_place = says ? table.place("role") : rope.place;
  if (!is_line_of_mouth || rope.stands == Standing::middle) return;
  if (says)
    table.error("role", "a " + rope.role + " runs from one side of the mouth to the other",
                "stands = \"middle\", with the length of the whole rope");
  rope.role.clear();
}

}  // namespace

const std::vector<std::string>& rope_roles() {
  static const std::vector<std::string> words = {"headline",    "footrope", "fishing-line", "ground-rope",
                                                 "breast-line", "bridle",   "sweep",        "backstrap",
                                                 "door-leg",    "warp"};
  return words;
}

Rope read_rope(const std::string& name, formats::TableReader& table, const Catalogue& catalogue) {
  Rope rope;
  rope.name = name;
  rope.place = table.place();
  rope.stands = read_standing(table, "pair");
  ChosenPart part = read_part_choice(table, "rope", "rope", catalogue);
  rope.part_name = std::move(part.name);
  rope.rope = std::move(part.table);
  rope.length = read_length(table, "length", "unstretched length of the whole rope");
  read_role(rope, table);
  if (table.has("between")) {
    const auto ends =
        table.texts("between", {.doc = "two points, such as ends of ropes", .count = formats::exactly(2)});
    rope.between_place = table.place("between");
    if (ends.size() == 2) rope.between = {ends[0], ends[1]};
  }
  return rope;
}

Hanging read_hanging(formats::TableReader& table) {
  Hanging hanging;
  hanging.edge = table.text("edge", {.doc = "edge of a panel, such as \"top-wing.inner\""});
  hanging.rope = table.text("on", {.doc = "a rope"});
  hanging.edge_place = table.place("edge");
  hanging.rope_place = table.place("on");
  hanging.place = table.place();
  hanging.path = table.path();
  if (table.has("length") && table.has("ratio"))
    table.error("ratio", "cannot be combined with length, which has the same meaning", "leave out either");
  if (table.has("ratio"))
    hanging.ratio = table.real("ratio", {.unit = "1",
                                         .doc = "length of rope over the length of the stretched edge",
                                         .range = formats::between(0.01, 2)});
  else
    hanging.length = read_length(table, "length", "length of rope that the edge takes");
  return hanging;
}

/// A number for each edge after the first, or one number if there is only one such edge.
std::vector<double> read_take_up(formats::TableReader& table, std::size_t edges) {
  const std::string doc = "meshes of each further edge for one of the first";
  const formats::Range range = formats::between(0.05, 20);
  if (edges == 1 && table.kind("take_up") != formats::Kind::array)
    return {table.real("take_up", {.unit = "1", .doc = doc, .range = range})};
  return table.reals("take_up", {.unit = "1", .doc = doc, .range = range, .count = formats::exactly(edges)});
}

Join read_join(formats::TableReader& table) {
  Join join;
  join.place = table.place();
  join.path = table.path();
  const formats::Value* edges = table.raw("edges");
  const formats::Array* array = edges ? edges->as<formats::Array>() : nullptr;
  if (!array || array->items.size() < 2) {
    table.error(
        "edges",
        "give two edges that are sewn together, such as [\"wing.aft\", \"body.fore\"], or more of them, "
        "if several layers of netting meet in one seam");
    join.edges.resize(2);
    join.places.resize(2, join.place);
    return join;
  }
  for (const auto& item : array->items) {
    join.places.push_back(item.place);
    join.edges.push_back(read_row(item, table.path("edges"), table.diagnostics()));
  }
  if (table.has("take_up")) join.take_up = read_take_up(table, join.edges.size() - 1);
  join.selvedge = table.real("selvedge", {.unit = "1",
                                          .doc = "meshes of either edge that are gathered into the seam",
                                          .range = formats::between(0, 50),
                                          .fallback = 0.0});
  return join;
}

Pieces read_pieces(const std::string& name, formats::TableReader& table, const Catalogue& catalogue) {
  Pieces pieces;
  pieces.name = name;
  pieces.place = table.place();
  ChosenPart part = read_part_choice(table, "float", "float", catalogue);
  pieces.part_name = std::move(part.name);
  pieces.piece = std::move(part.table);
  pieces.has_number = table.has("number");
  const std::string spread =
      table.text("spread", {.doc = "how many pieces along which rope, or at which point"});
  pieces.spread_place = table.place("spread");
  if (table.has("spread") && table.kind("spread") == formats::Kind::text && !split_spread(spread, pieces))
    table.error("spread", "\"" + spread + "\" is not understood",
                "give a number of pieces and a rope, an edge or a point, such as \"47 along headrope\" "
                "or \"2 at footrope.end\"");
  const double in_spread = pieces.number;
  pieces.number = table.real("number", {.unit = "1",
                                        .doc = "pieces in the whole gear, instead of the number in spread",
                                        .range = {.lo = 0, .hi = kMostPieces, .lo_open = true},
                                        .fallback = in_spread});
  if (in_spread > 0 && in_spread != pieces.number)
    table.diagnostics().warning(table.place("number"),
                                fmt::format("{}: {:g} pieces, not the {:g} in spread", table.path("number"),
                                            pieces.number, in_spread),
                                "leave the number out of spread");
  return pieces;
}

Point read_point(const std::string& name, formats::TableReader& table) {
  Point point;
  point.name = name;
  point.place = table.place();
  point.stands = read_standing(table, "pair");
  if (table.has("at")) {
    const auto at =
        table.reals("at", {.unit = "m", .doc = "x, y, z", .range = kPlaces, .count = formats::exactly(3)});
    if (at.size() == 3) point.at = {at[0], at[1], at[2]};
    if (point.at) check_side(point, table);
  }
  return point;
}

}  // namespace netloft::gears
