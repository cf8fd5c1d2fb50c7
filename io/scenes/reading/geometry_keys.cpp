// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/geometry_keys.hpp"

namespace netloft::scenes {

namespace {

using Shape = GeometryKey::Shape;
const formats::Range kCoordinates = formats::between(-1e6, 1e6);
const formats::Range kMeshes{.lo = 0, .hi = 1e6, .lo_open = true};
const formats::Range kRadii = formats::between(0, 1e4);

/// The name of a key without its table: the text after the dot.
std::string leaf(const GeometryKey& key) { return key.name.substr(key.name.find('.') + 1); }

}  // namespace

const GeometryKey kAt{"at",          "m",          "initial position of the point",
                      Shape::points, kCoordinates, formats::exactly(1)};
const GeometryKey kLength{
    "length", "m", "unstretched length of the rope", Shape::real, {.lo = 0, .hi = 1e6, .lo_open = true}, {}};
const GeometryKey kBars{
    "cells", "1", "number of bars of the rope", Shape::integer, formats::between(1, kMostCells), {}};
const GeometryKey kLine{"sketch",      "m",          "points of the initial line of the rope",
                        Shape::points, kCoordinates, {.least = 2}};
const GeometryKey kAcross{"panel.across", "1", "meshes across the panel", Shape::real, kMeshes, {}};
const GeometryKey kAlong{"panel.along", "1", "meshes along the panel", Shape::real, kMeshes, {}};
const GeometryKey kBar{"panel.bar",
                       "m",
                       "unstretched length of a bar, from knot to knot: half the mesh size",
                       Shape::real,
                       {.lo = 0, .hi = 100, .lo_open = true},
                       {}};
const GeometryKey kNetting{"panel.netting",
                           "1",
                           "orientation of the meshes: diamond; t90, diamonds turned by a right angle; "
                           "square, one twine direction along the panel",
                           Shape::word,
                           {},
                           {},
                           false,
                           {"diamond", "t90", "square"}};
const GeometryKey kCells{"cells",
                         "1",
                         "cells across and along, divided into triangles",
                         Shape::integers,
                         formats::between(1, kMostCells),
                         formats::exactly(2)};
const GeometryKey kDivision{"division",
                            "1",
                            "alternating: two triangles per cell, with the diagonal alternating from cell to "
                            "cell; crossed: four triangles around a node in the middle of the cell",
                            Shape::word,
                            {},
                            {},
                            false,
                            {"alternating", "crossed"}};
const GeometryKey kSquareCells{"cells",
                               "1",
                               "cells across and along, as many meshes wide as long, four bars each",
                               Shape::integers,
                               formats::between(1, kMostCells),
                               formats::exactly(2)};
const GeometryKey kCorners{
    "sketch",      "m",          "approximate initial corners: fore left, fore right, aft right, aft left",
    Shape::points, kCoordinates, formats::exactly(4),
    false};
const GeometryKey kFrom{
    "tube.from",   "m",          "middle of the fore edge of a panel that starts as a tube",
    Shape::points, kCoordinates, formats::exactly(1),
    false};
const GeometryKey kTo{"tube.to",     "m",          "middle of the aft edge of the tube",
                      Shape::points, kCoordinates, formats::exactly(1),
                      false};
const GeometryKey kRadius{"tube.radius", "m", "radius of the tube", Shape::real, kRadii, {}, false};
const GeometryKey kRadiusAft{
    "tube.radius_aft", "m", "radius at the aft edge, if it differs", Shape::real, kRadii, {}, false};

namespace {
const formats::Range kTurnRange = formats::between(-3.15, 3.15);
}
const GeometryKey kOrigin{"at",          "m",          "initial position of the origin of the body",
                          Shape::points, kCoordinates, formats::exactly(1)};
const GeometryKey kPoints{"points",
                          "m",
                          "named points to which parts are joined: [aft, outward, up] from the origin",
                          Shape::named_points,
                          kCoordinates,
                          {},
                          false};
const GeometryKey kSide{
    "side",
    "1",
    "side of the gear on which the body is; port mirrors everything that is given in the axes of the body",
    Shape::word,
    {},
    {},
    false,
    {"starboard", "port"}};
const GeometryKey kHeading{"turned.heading",
                           "rad",
                           "initial heading, positive with the nose turned outward",
                           Shape::real,
                           kTurnRange,
                           {},
                           false};
const GeometryKey kHeel{"turned.heel", "rad",      "initial heel, positive with the top leaning outward",
                        Shape::real,   kTurnRange, {},
                        false};
const GeometryKey kTrim{
    "turned.trim", "rad", "initial trim, positive with the nose up", Shape::real, kTurnRange, {}, false};
const GeometryKey kTurns{"turns",
                         "1",
                         "rotation of the body: free, about one axis of the scene only, or none",
                         Shape::word,
                         {},
                         {},
                         false,
                         {"freely", "about x", "about y", "about z", "not"}};
const GeometryKey kOutline{
    "outline",     "m",          "corners of the outline that is drawn in pictures, in the axes of the body",
    Shape::points, kCoordinates, {.least = 3},
    false};

namespace {
const formats::Range kRimSizes{.lo = 0, .hi = 1e4, .lo_open = true};
}
const GeometryKey kRimEdge{
    "rim.edge",  "1", "edge of a panel of the net plan that is hung round the rim of the body",
    Shape::word, {},  {},
    false};
const GeometryKey kRimWidth{
    "rim.width", "m", "width of the rim, an ellipse across x", Shape::real, kRimSizes, {}, false};
const GeometryKey kRimHeight{
    "rim.height", "m", "height of the rim; default: its width", Shape::real, kRimSizes, {}, false};
const GeometryKey kRimAt{
    "rim.at",      "m",          "centre of the rim in the axes of the body; default: the origin",
    Shape::points, kCoordinates, formats::exactly(1),
    false};

double read_real(formats::TableReader& table, const GeometryKey& key, std::optional<double> fallback) {
  return table.real(leaf(key), {.unit = key.unit, .doc = key.doc, .range = key.range, .fallback = fallback});
}

std::string read_word(formats::TableReader& table, const GeometryKey& key) {
  return table.choice(leaf(key), {.allowed = key.words, .doc = key.doc, .fallback = key.words[0]});
}

Point read_one_point(formats::TableReader& table, const GeometryKey& key) {
  const auto at = table.reals(
      leaf(key), {.unit = key.unit, .doc = key.doc, .range = key.range, .count = formats::exactly(3)});
  return at.size() == 3 ? Point{at[0], at[1], at[2]} : Point{};
}

std::vector<std::int64_t> read_integers(formats::TableReader& table, const GeometryKey& key) {
  const auto lo = static_cast<std::int64_t>(key.range.lo), hi = static_cast<std::int64_t>(key.range.hi);
  if (key.shape == Shape::integer) return {table.integer(leaf(key), {.doc = key.doc, .lo = lo, .hi = hi})};
  return table.integers(leaf(key), {.doc = key.doc, .lo = lo, .hi = hi, .count = key.count});
}

std::vector<Point> read_points(formats::TableReader& table, const GeometryKey& key) {
  std::vector<Point> points;
  for (const auto& row : table.rows(leaf(key), {.unit = key.unit,
                                               .doc = key.doc,
                                               .range = key.range,
                                               .rows = key.count,
                                               .columns = formats::exactly(3)}))
    if (row.size() == 3) points.push_back({row[0], row[1], row[2]});
  return points;
}

const std::vector<GeometryKey>& geometry_keys(Layout layout) {
  static const ByLayout<std::vector<GeometryKey>> keys{
      {kAt},
      {kLength, kBars, kLine},
      {kAcross, kAlong, kBar, kNetting, kCells, kDivision, kCorners, kFrom, kTo, kRadius, kRadiusAft},
      {kAcross, kAlong, kBar, kSquareCells, kCorners, kFrom, kTo, kRadius, kRadiusAft},
      {kOrigin, kPoints, kSide, kHeading, kHeel, kTrim, kTurns, kOutline, kRimEdge, kRimWidth, kRimHeight,
       kRimAt}};
  return keys.of(layout);
}

}  // namespace netloft::scenes
