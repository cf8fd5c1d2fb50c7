// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/morison.hpp"
#include "plugins/hydro/netting_twine.hpp"
#include "plugins/hydro/reynolds.hpp"
#include "plugins/hydro/screen.hpp"

using namespace netloft::hydro;
using netloft::Quantity;

namespace {

constexpr const char* kShielding =
    "velocity of the water at this place divided by that ahead of the gear; 1 in undisturbed water";

/// Adds the parameter `cylinder`, which chooses the formula for the drag coefficient of a cylinder.
template <class Table>
void add_cylinder(Table& law, auto member) {
  law.choice("cylinder", member,
             "formula of the drag coefficient of a cylinder: Choo and Casarella 1971, or Takagi et al. 2004, "
             "which is lower and steeper below a Reynolds number of 200",
             {"choo-casarella", "takagi"});
}

template <class L>
auto& add_screen(netloft::Plugin& plugin, const char* name, const char* doc) {
  using P = typename L::Parameters;
  auto& law = plugin.law<L>(name, doc);
  law.real("shielding", &P::shielding, "1", kShielding, {.lo = 0, .hi = 2, .fallback = 1});
  law.choice("wake", &P::wake, "loland: netting of the same solidity is upstream and slows the water",
             {"none", "loland"});
  return law;
}

/// Adds a law of screens whose published coefficients do not depend on the Reynolds number.
template <class L>
auto& add_screen_at_one_reynolds_number(netloft::Plugin& plugin, const char* name, const char* doc) {
  using P = typename L::Parameters;
  auto& law = add_screen<L>(plugin, name, doc);
  law.real(
      "measured_at", &P::measured_at, "1",
      "Reynolds number of a twine at which the coefficients were measured; for other Reynolds numbers they "
      "are scaled with the drag coefficient of a cylinder; 0: no scaling",
      {.lo = 0, .hi = 1e5, .fallback = 0});
  add_cylinder(law, &P::cylinder);
  law.valid(Quantity::reynolds, 0, 1e5, "Choo and Casarella 1971", {.where = "measured_at"});
  return law;
}

void add_netting_twine(netloft::Plugin& plugin) {
  using P = NettingTwine::Parameters;
  auto& law = plugin.law<NettingTwine>(
      "netting-twine",
      "Twines of knotted netting: drag across, friction along and knots, each over its Reynolds number");
  add_cylinder(law, &P::cylinder);
  law.real("knots", &P::knots, "1",
           "frontal area of the knots over that of the twines: 0.39 times the square of knot_diameter, times "
           "the ratio of twine diameter to bar length",
           {.lo = 0, .hi = 10, .fallback = 0.1});
  law.real("knot_diameter", &P::knot_diameter, "1", "diameter of a knot over that of the twine",
           {.lo = 0.1, .hi = 20, .fallback = 2.5});
  law.real("shielding", &P::shielding, "1", kShielding, {.lo = 0, .hi = 2, .fallback = 1});
  law.valid(Quantity::reynolds_across, 30, 1e4, "friction of Choo and Casarella 1971");
}

void add_knotted(netloft::Plugin& plugin) {
  auto& law = add_screen_at_one_reynolds_number<Knotted>(
      plugin, "knotted",
      "Drag and lift of knotted trawl netting as a screen, much drag at small angles, Suisan 1979");
  law.real("normal", &KnottedParameters::normal, "1",
           "drag coefficient at normal incidence, on the area of the twines",
           {.lo = 0, .hi = 10, .fallback = 1.35});
  law.real("friction", &KnottedParameters::friction, "1",
           "friction coefficient along the netting, on the area of the twines",
           {.lo = 0, .hi = 10, .fallback = 0.4});
  law.real("friction_slope", &KnottedParameters::friction_slope, "1",
           "increase of the friction coefficient with the sine of the angle of attack",
           {.lo = -10, .hi = 10, .fallback = 0});
  law.valid(Quantity::reynolds, 600, 3000, "Imai 1986: the coefficients are constant in this range",
            {.unless = "measured_at"});
}

}  // namespace

NETLOFT_PLUGIN("hydro", "0.1.0", "Forces of flowing water on twines, ropes and netting") {
  auto& m = plugin.law<Morison>("morison", "Drag across and along a twine, with constant coefficients");
  m.real("normal", &Morison::Parameters::normal, "1", "drag coefficient of the flow across, on the diameter",
         {.lo = 0, .hi = 100, .fallback = 1.2});
  m.real("tangential", &Morison::Parameters::tangential, "1",
         "drag coefficient of the flow along, on the diameter", {.lo = 0, .hi = 100, .fallback = 0.08});
  m.real("shielding", &Morison::Parameters::shielding, "1", kShielding, {.lo = 0, .hi = 2, .fallback = 1});
  m.valid(Quantity::reynolds, 330, 1e5,
          "Choo and Casarella 1971: the coefficient of a cylinder is 1.2 within 10 % in this range");

  auto& r = plugin.law<MorisonReynolds>(
      "morison-reynolds",
      "Drag across and along a twine, with a drag coefficient that depends on the Reynolds number");
  r.table("normal", &MorisonReynolds::Parameters::normal,
          "drag coefficient of the flow across over its Reynolds number; if it is not given, `cylinder` "
          "chooses the coefficient",
          {{"Re", "1"}, {"C_n", "1"}});
  add_cylinder(r, &MorisonReynolds::Parameters::cylinder);
  r.valid(Quantity::reynolds_across, 0, 1e5, "Choo and Casarella 1971", {.unless = "normal"});
  r.real("tangential", &MorisonReynolds::Parameters::tangential, "1",
         "drag coefficient of the flow along, on the diameter", {.lo = 0, .hi = 10, .fallback = 0.08});
  r.real("shielding", &MorisonReynolds::Parameters::shielding, "1", kShielding,
         {.lo = 0, .hi = 2, .fallback = 1});

  add_netting_twine(plugin);

  add_screen_at_one_reynolds_number<Loland>(plugin, "loland",
                                            "Drag and lift of netting as a screen, Løland 1991")
      .valid(Quantity::solidity, 0.13, 0.32, "Løland 1991");
  add_screen_at_one_reynolds_number<Aarsnes>(plugin, "aarsnes",
                                             "Drag and lift of netting as a screen, Aarsnes 1990")
      .valid(Quantity::solidity, 0, 0.35, "Aarsnes, Rudi and Løland 1990");
  auto& kristiansen = add_screen<KristiansenFaltinsen>(
      plugin, "kristiansen-faltinsen",
      "Drag and lift of netting as a screen, Kristiansen and Faltinsen 2012");
  kristiansen.valid(Quantity::reynolds_in_meshes, 31.6, 1e4, "Kristiansen and Faltinsen 2012");
  kristiansen.valid(Quantity::solidity, 0, 0.5, "Kristiansen and Faltinsen 2012");
  add_knotted(plugin);
}
