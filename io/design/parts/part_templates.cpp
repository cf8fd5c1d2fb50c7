// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/parts/part_templates.hpp"

namespace netloft::design {

namespace {

const PartField kRopeOfPart{"rope", "rope", "rope, wire or chain", ""};
const PartField kLengthOfPart{"length", "metres", "length", ""};

}  // namespace

const std::vector<PartTemplate>& part_templates() {
  static const std::vector<PartTemplate> all{
      {"floats",
       "floats or weights along a rope",
       {{"count", "count", "number", "5"},
        {"float", "float", "float or weight", ""},
        {"along", "ropes", "along", ""}},
       {"[floats.{name}]\nfloat = \"{float}\"\nspread = \"{count} along {along}\"\n"}},
      {"rope",
       "a rope between two points",
       {{"from", "points", "from", ""}, {"to", "points", "to", ""}, kRopeOfPart, kLengthOfPart},
       {"[ropes.{name}]\nrope = \"{rope}\"\nlength = \"{length} m\"\nbetween = [\"{from}\", \"{to}\"]\n",
        "[ropes.{name}]\nstands = \"alone\"\nrope = \"{rope}\"\nlength = \"{length} m\"\nbetween = "
        "[\"{from}\", "
        "\"{to}\"]\n"}},
      {"board",
       "a board between a point and the ropes that lead to it",
       {{"at", "points", "at", ""},
        {"board", "board", "board", ""},
        kRopeOfPart,
        {"length", "metres", "length of the rope", "10"}},
       {"[bodies.{name}]\ntype = \"board/otter\"\nboard = \"{board}\"\nat = "
        "{behind}\n[ropes.{name}-rope]\nrope = "
        "\"{rope}\"\nlength = \"{length} m\"\nbetween = [\"{at}\", \"{name}.warp\"]\n"},
       "{at}",
       "{name}.sweep",
       {"ropes"}},
      {"panel",
       "a panel at a fore or aft edge, which takes the place of the edge in its seams and hangings",
       {{"edge", "edges", "edge", ""},
        {"depth", "count", "meshes deep", "20"},
        {"far", "count", "meshes at the other edge", ""}},
       {"[panels.{name}]\n{cloth}{counts}depth = {depth}\n{sides}[[join]]\nedges = [\"{edge}\", "
        "\"{name}.{near}\"]\n"},
       "{edge}",
       "{name}.{other}",
       {"join", "hang", "floats"}}};
  return all;
}

}  // namespace netloft::design
