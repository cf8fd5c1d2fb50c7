// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/checked_plan.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace netloft::gears {

/// A small trawl that can be sewn: two wings, a body and a bag.
/// Wings: 10 fore, 20 more on the inner side by AB over 20 deep: 30 aft.
/// Body: 30 + 20 + 30 = 80 fore, 5B1P over 42 deep takes 30 from each side: 20 aft.
inline const std::string kGoodPlan = R"(
[panels.wing]
stands = "pair"
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 10
depth = 20
aft = 30
outer = "AN"
inner = "AB out"
open = ["fore", "outer"]

[panels.body]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = [{ name = "bosom", meshes = 20 }, { name = "wing", meshes = 30 }]
depth = 42
aft = 20
sides = "5B1P in"
open = "sides"

[panels.bag]
mesh = "80 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 20
depth = 50
sides = "AN"
open = ["sides", "aft"]

[ropes.headline]
stands = "middle"
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "6 m"

[ropes.bridle]
stands = "pair"
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "20 m"
between = ["door", "headline.end"]

[points.door]

[floats.top]
float = { buoyancy = "25 N" }
spread = "11 along headline"

[[join]]
edges = ["wing.aft", "body.wing"]
[[join]]
edges = ["body.aft", "bag.fore"]

[[hang]]
edge = "body.bosom"
on = "headline"
ratio = 0.5
[[hang]]
edge = "wing.inner"
on = "headline"
length = "1.9 m"
)";

/// The good plan with one piece of its text replaced; the plan must contain it.
inline std::string changed_plan(const std::string& old, const std::string& now) {
  std::string text = kGoodPlan;
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << "not in the plan: " << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), now);
}

struct CheckedPlan {
  NetPlan plan;
  formats::Diagnostics diagnostics;
  std::string said() const { return diagnostics.render(false); }
};

inline CheckedPlan check_text(const std::string& text) {
  CheckedPlan checked;
  checked.plan = read_and_check_text(text, "plan.toml", checked.diagnostics);
  if (checked.diagnostics.errors() == 0) check_seams(checked.plan, checked.diagnostics);
  return checked;
}

inline std::string library_text(const std::string& name) {
  std::ifstream file(test::source_folder() + "/gear-library/gears/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace netloft::gears
