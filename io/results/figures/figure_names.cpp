// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/figure_names.hpp"

#include <algorithm>

namespace netloft::results {

namespace {

/// Whether a figure of a pair of bodies is the spread, or a force that causes it. Other figures of a pair are
/// means, for which tables show the figures of the two bodies instead.
bool is_of_pair(const std::string& name) {
  return name.starts_with("pairs/") &&
         (name.ends_with("/spread") || name.ends_with("/spread_force") || name.ends_with("/ground_share"));
}

}  // namespace

std::string spoken(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '_' || c == '/'; }, ' ');
  return name;
}

bool are_of_plan(const std::vector<NamedScalar>& figures) {
  if (figures.empty()) return false;
  const std::string& last = figures.back().name;
  return !last.starts_with("bodies/") && !last.starts_with("body_forces/");
}

std::string principal_name(const std::string& figure) {
  const std::string last = spoken(figure.substr(figure.find('/') + 1));
  if (figure.starts_with("mouth/")) return last == "area" ? "mouth area" : last;
  if (figure == "drag/all/x") return "drag";
  if (figure.starts_with("netting/")) return "netting " + last;
  if (figure.starts_with("ground/")) return "ground " + last;
  if (figure.starts_with("rigging/")) return figure.substr(8, figure.rfind('/') - 8) + " pull";
  if (is_of_pair(figure)) return spoken(figure.substr(6));
  if (figure.starts_with("towing/")) return "towing " + last;
  if (figure == "weight_in_water/all") return "weight in water";
  if (figure.starts_with("budget/")) return last + " weight";
  return "";
}

}  // namespace netloft::results
