// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/morison.hpp"
#include "plugins/hydro/reynolds.hpp"
#include "plugins/hydro/screen.hpp"

using namespace netloft::hydro;

namespace {

constexpr const char* kShielding =
    "velocity of the water here divided by that ahead of the gear, 1 in open water";

template <class L>
auto& add_screen(netloft::Plugin& plugin, const char* name, const char* doc) {
  auto& law = plugin.law<L>(name, doc);
  law.real("shielding", &ScreenParameters::shielding, "1", kShielding, {.lo = 0, .hi = 2, .fallback = 1});
  law.choice("wake", &ScreenParameters::wake,
             "loland: netting of the same solidity is upstream and slows the water", {"none", "loland"});
  return law;
}

/// A screen whose published coefficients know no Reynolds number.
template <class L>
void add_screen_at_one_reynolds_number(netloft::Plugin& plugin, const char* name, const char* doc) {
  add_screen<L>(plugin, name, doc)
      .real("measured_at", &ScreenParameters::measured_at, "1",
            "Reynolds number of a twine at which the coefficients were measured; at others they follow the "
            "drag "
            "coefficient of a cylinder, Choo and Casarella 1971; 0: they do not",
            {.lo = 0, .hi = 1e5, .fallback = 0});
}

}  // namespace

NETLOFT_PLUGIN("hydro", "0.1.0", "Forces of flowing water on twines, ropes and netting") {
  auto& m = plugin.law<Morison>("morison", "Drag across and along a twine, with constant coefficients");
  m.real("normal", &Morison::Parameters::normal, "1", "drag coefficient of the flow across, on the diameter",
         {.lo = 0, .hi = 100, .fallback = 1.2});
  m.real("tangential", &Morison::Parameters::tangential, "1",
         "drag coefficient of the flow along, on the diameter", {.lo = 0, .hi = 100, .fallback = 0.08});
  m.real("shielding", &Morison::Parameters::shielding, "1", kShielding, {.lo = 0, .hi = 2, .fallback = 1});

  auto& r = plugin.law<MorisonReynolds>(
      "morison-reynolds", "The same with a drag coefficient that depends on the Reynolds number");
  r.table(
      "normal", &MorisonReynolds::Parameters::normal,
      "drag coefficient of the flow across over its Reynolds number; Choo and Casarella 1971 when not given",
      {{"Re", "1"}, {"C_n", "1"}});
  r.real("tangential", &MorisonReynolds::Parameters::tangential, "1",
         "drag coefficient of the flow along, on the diameter", {.lo = 0, .hi = 10, .fallback = 0.08});
  r.real("shielding", &MorisonReynolds::Parameters::shielding, "1", kShielding,
         {.lo = 0, .hi = 2, .fallback = 1});

  add_screen_at_one_reynolds_number<Loland>(plugin, "loland",
                                            "Drag and lift of netting as a screen, Løland 1991");
  add_screen_at_one_reynolds_number<Aarsnes>(plugin, "aarsnes",
                                             "Drag and lift of netting as a screen, Aarsnes 1990");
  add_screen<KristiansenFaltinsen>(plugin, "kristiansen-faltinsen",
                                   "Drag and lift of netting as a screen, Kristiansen and Faltinsen 2012");
}
