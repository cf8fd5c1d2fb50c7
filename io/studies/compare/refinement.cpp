// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/refinement.hpp"

#include "io/studies/compare/rope_ends.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kResults = "results/", kGear = "gear/";
constexpr double kRoundOff = 1e-12;  // a smaller relative difference is not a change

void add_trends(const Refinement& refinement, std::string_view group, NumberGroup numbers,
                std::vector<RefinedNumber>& all) {
  const auto& meshes = refinement.meshes;
  for (const auto& finest : meshes.back().*numbers) {
    RefinedNumber number{std::string(group) + finest.name, finest.unit, {}, {}};
    for (const auto& mesh : meshes) {
      const results::NamedScalar* found = results::find_scalar(mesh.*numbers, finest.name);
      number.values.push_back(found ? found->value : results::NamedScalar::kUnknown);
    }
    number.trend = find_trend_of(finest.name, numbers, meshes, meshes.size() - 1);
    if (number.diverges()) number.trend.error = results::NamedScalar::kUnknown;
    all.push_back(std::move(number));
  }
}

std::string number_cell(double value, const char* format = "{:.6g}") {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

/// One sentence for each rope end whose tension has no limit.
std::string divergences_text(const Refinement& r, const std::vector<RefinedNumber>& numbers) {
  std::string text;
  for (const auto& n : numbers)
    if (n.diverges())
      text += divergence_text(n.name.substr(kGear.size()), r.meshes, r.meshes.size() - 1) + "\n";
  return text;
}

bool is_of_one_part(const std::string& name) { return name.find("_by_part/") != std::string::npos; }

std::string row_text(const RefinedNumber& n, std::size_t width) {
  std::string text = fmt::format("{:<{}}", n.name, width);
  for (const double value : n.values) text += fmt::format(" {:>11}", number_cell(value));
  return text +
         fmt::format(" {:>11} {:>9} {:>6} {}\n", number_cell(n.trend.limit),
                     number_cell(n.trend.error, "{:.1e}"),
                     number_cell(n.trend.steady ? n.trend.order : results::NamedScalar::kUnknown, "{:.1f}"),
                     n.unit == "1" ? "" : n.unit);
}

std::string heading_text(const Refinement& r, std::size_t width) {
  std::string counts = fmt::format("{:<{}}", r.meshes.front().mesh.of, width), work = counts;
  work = fmt::format("{:<{}}", "seconds of the solver", width);
  for (const auto& mesh : r.meshes) {
    counts += fmt::format(" {:>11}", mesh.mesh.count);
    work += fmt::format(" {:>11.3g}", mesh.seconds);
  }
  return counts + fmt::format(" {:>11} {:>9} {:>6}\n", "tends to", "error", "order") + work + "\n";
}

}  // namespace

bool RefinedNumber::diverges() const {
  return trend.diverges && name.starts_with(kGear) && is_of_rope_end(name);
}

bool RefinedNumber::varies() const {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return !(*most - *least <= kRoundOff * std::max(std::abs(*least), std::abs(*most)));
}

Refinement refine(const runs::CaseSource& source, Registry& registry, const std::vector<MeshLevel>& levels,
                  const runs::Watch& watch) {
  Refinement refinement;
  for (const auto& level : levels) {
    std::string why_not;
    auto solved = solve_on(level, source, registry, watch, why_not);
    refinement.is_interrupted = watch.interrupt && *watch.interrupt;
    if (solved)
      refinement.meshes.push_back(std::move(*solved));
    else if (!refinement.is_interrupted)
      refinement.missing.push_back(why_not);
    if (refinement.is_interrupted) break;
  }
  std::sort(refinement.meshes.begin(), refinement.meshes.end(),
            [](const auto& a, const auto& b) { return a.mesh.width > b.mesh.width; });
  return refinement;
}

std::vector<RefinedNumber> find_trends(const Refinement& refinement) {
  std::vector<RefinedNumber> all;
  if (refinement.meshes.size() < 2) return all;
  add_trends(refinement, kResults, &NumbersOnMesh::scalars, all);
  add_trends(refinement, kGear, &NumbersOnMesh::gear, all);
  return all;
}

std::string refinement_text(const Refinement& r) {
  auto numbers = find_trends(r);
  std::erase_if(numbers, [](const auto& n) { return !n.varies() || is_of_one_part(n.name); });
  std::size_t width = 22;
  for (const auto& n : numbers) width = std::max(width, n.name.size());
  std::string text = r.scene + "\n";
  if (!r.meshes.empty()) text += heading_text(r, width);
  for (const auto& n : numbers) text += row_text(n, width);
  if (!numbers.empty())
    text +=
        "error: the error of the finest mesh, estimated as 1.25 times its largest difference from the two "
        "meshes before it and from the values extrapolated with the first and the observed order\n";
  text += divergences_text(r, numbers);
  for (const auto& sentence : r.missing) text += "missing: " + sentence + "\n";
  text.pop_back();
  return text;
}

std::string refinement_json(const Refinement& r) {
  Json meshes = Json::array(), rows = Json::array();
  for (const auto& m : r.meshes)
    meshes.push_back({{"count", m.mesh.count},
                      {"of", m.mesh.of},
                      {"unknowns", m.unknowns},
                      {"seconds", m.seconds},
                      {"stable", m.is_stable}});
  for (const auto& n : find_trends(r))
    rows.push_back({{"name", n.name},
                    {"unit", n.unit},
                    {"values", n.values},
                    {"limit", n.trend.limit},
                    {"error", n.trend.error},
                    {"order", n.trend.steady ? Json(n.trend.order) : Json(nullptr)},
                    {"diverges", n.diverges()}});
  const Json json = {{"scene", r.scene},
                     {"status", r.is_interrupted    ? "interrupted"
                                : r.missing.empty() ? "done"
                                                    : "not converged"},
                     {"meshes", meshes},
                     {"quantities", rows},
                     {"missing", r.missing}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::studies
