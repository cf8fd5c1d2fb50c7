// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/matrix.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace netloft::hard_cases {

namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity.
Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

Json history_json(const std::vector<IterationRecord>& history) {
  Json all = Json::array();
  for (const auto& r : history)
    all.push_back({{"iteration", r.iteration},
                   {"residual", number(r.residual)},
                   {"load", number(r.scale)},
                   {"energy", number(r.energy)},
                   {"note", r.note}});
  return all;
}

Json stages_json(const std::vector<StageRecord>& stages) {
  Json all = Json::array();
  for (const StageRecord& stage : stages)
    all.push_back({{"name", stage.name},
                   {"unknowns", stage.unknowns},
                   {"status", name_of(stage.status)},
                   {"iterations", stage.statistics.iterations},
                   {"factorisations", stage.statistics.factorisations},
                   {"seconds", number(stage.statistics.total_seconds)},
                   {"reason", stage.reason}});
  return all;
}

Json shapes_json(const Shapes& shapes) {
  Json others = Json::array();
  for (const OtherShape& other : shapes.others)
    others.push_back({{"energy", number(other.energy)},
                      {"distance", other.distance},
                      {"furthest", other.furthest},
                      {"times", other.times}});
  return {{"restarts", shapes.restarts}, {"times", shapes.times}, {"others", others}};
}

/// Overrides in the form of `--set`.
Json overrides_json(const HardCase& c, const std::string& size) {
  Json all(c.overrides);
  if (const auto more = c.sizes.find(size); more != c.sizes.end())
    for (const auto& one : more->second) all.push_back(one);
  return all;
}

Json start_json(const std::vector<StartStep>& start) {
  Json all = Json::array();
  for (const StartStep& step : start) switch (step.kind) {
      case StartStep::Kind::noise:
        all.push_back({{"noise", step.amplitude}, {"seed", step.seed}});
        break;
      case StartStep::Kind::scale:
        all.push_back({{"scale", step.factor}, {"about", step.about}});
        break;
      case StartStep::Kind::turn:
        all.push_back(
            {{"turn", step.angle}, {"axis", std::string(1, "xyz"[step.axis])}, {"about", step.about}});
        break;
      case StartStep::Kind::shift:
        all.push_back({{"shift", step.shift}});
        break;
      case StartStep::Kind::shuffle:
        all.push_back({{"shuffle", true}, {"seed", step.seed}});
        break;
    }
  return all;
}

Json cell_json(const Cell& c, const Row& row) {
  return {{"name", c.name},
          {"scene", row.about->scene.lexically_normal().generic_string()},
          {"set", overrides_json(*row.about, c.size)},
          {"start", start_json(row.about->start)},
          {"size", c.size},
          {"solver", c.solver},
          {"unknowns", c.unknowns},
          {"where", name_of(c.verdict.where)},
          {"right", is_right(c.verdict.where)},
          {"claimed_wrong", is_claimed_wrong(c.verdict.where)},
          {"confirmed", c.confirmed},
          {"expected", name_of(c.expected)},
          {"random", row.about->is_random},
          {"stable_shapes", row.shapes},
          {"iterations", c.iterations},
          {"factorisations", c.factorisations},
          {"cpu_seconds", c.cpu_seconds},
          {"energy", number(c.energy)},
          {"energy_gap", number(c.verdict.gap)},
          {"distance", number(c.verdict.distance)},
          {"status", c.status},
          {"stability", c.stability},
          {"reason", c.reason},
          {"stages", stages_json(c.stages)},
          {"shapes", shapes_json(c.shapes)},
          {"history", history_json(c.history)}};
}

Json tally_json(const Tally& t) {
  return {{"solver", t.solver},
          {"cases", t.cases},
          {"right", t.right},
          {"claimed_wrong", t.claimed_wrong},
          {"unconfirmed", t.unconfirmed},
          {"factorisations", t.factorisations},
          {"cpu_seconds", t.cpu_seconds}};
}

}  // namespace

std::string matrix_json(const MatrixTitle& title, const std::vector<Row>& rows) {
  Json cases = Json::array(), solvers = Json::array(), kinds = Json::array();
  for (const auto& row : rows)
    for (const auto& cell : row.cells) cases.push_back(cell_json(cell, row));
  for (const auto& t : tally(rows)) solvers.push_back(tally_json(t));
  for (const auto& kind : tally_by_kind(rows))
    for (const auto& t : kind.columns) {
      kinds.push_back({{"kind", kind.kind}});
      kinds.back().update(tally_json(t));
    }
  const Json all = {{"suite", title.folder},
                    {"seed", title.seed},
                    {"solvers", solvers},
                    {"kinds", kinds},
                    {"cases", cases}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::hard_cases
