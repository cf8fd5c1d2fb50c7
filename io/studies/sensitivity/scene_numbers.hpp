// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/studies/variables/variable.hpp"

#include <string>
#include <vector>

namespace netloft::studies {

/// A number in the tables of a scene, or a variable that sets several such numbers.
struct SceneNumber {
  std::string path;                     // path as for `--set`: "tow.speed", "points.towing-point.at[2]"
  double value = 0;                     // the number as written
  std::string unit;                     // its unit as written, such as "kn"; empty: none
  std::vector<FollowingKey> keys = {};  // keys that the number sets; empty: only the key `path`
  double deviation = 0;                 // its standard deviation in its unit; 0: not known
  std::string doc = {};                 // half a sentence about a parameter of a part; empty: not known
  /// The changes that set the scene to another value of this number.
  std::vector<formats::Change> to(double other) const;
};

/// The number that stands for a variable of a study with this value.
SceneNumber number_of(const Variable& variable, double value);

/// The numbers in the tables of a scene, in the order of the file. Tables that only describe how the scene is
/// solved and reported are left out: analysis, results, catalogue, accept and gear.nodes.
std::vector<SceneNumber> numbers_of(const formats::Value& tables);

/// The real parameters of the parts of a scene, in SI units, as far as the scene, the net plan or the
/// catalogue states them. The path of a parameter is the key that overrides it:
/// "elements.top-wing.twine.diameter" for a part of a net plan, "parts.net.twine.EA" for another part.
std::vector<SceneNumber> parameters_of(const scenes::LoadedScene& loaded, Registry& registry);

/// The numbers of a scene at `paths`. Each path leads to a number, or to a table or array of numbers. A path
/// to the table of a part, such as "elements.top-wing", also means the parameters of that part. If there are
/// no paths, the result is all numbers of the tables. A path may be followed by the standard deviation of its
/// numbers, with a unit or in percent: "ship.speed=0.1 kn", "elements.top-wing.twine=10 %". Throws
/// std::invalid_argument with a sentence if there is no number at a path, or if a deviation does not fit the
/// numbers at its path.
std::vector<SceneNumber> chosen_numbers(runs::PreparedScene& scene, const std::vector<std::string>& paths);

}  // namespace netloft::studies
