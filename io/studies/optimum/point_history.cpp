// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/optimum/point_history.hpp"

#include "io/formats/files/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const KnownPoint& point, const std::string& inputs) {
  Json figures = Json::array();
  for (const StudyFigure& f : point.figures)
    figures.push_back({f.name, f.unit, std::isfinite(f.value) ? Json(f.value) : Json()});
  const Json line{{"inputs", inputs},
                  {"parameters", point.parameters},
                  {"reason", point.reason},
                  {"figures", std::move(figures)},
                  {"slopes", point.slopes}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The point in a line; nullopt if the line is damaged or belongs to other inputs.
std::optional<KnownPoint> read_line(const std::string& text, const std::string& inputs) {
  try {
    const Json line = Json::parse(text);
    if (line.at("inputs") != inputs) return std::nullopt;
    KnownPoint point{line.at("parameters"), line.at("reason"), {}, line.at("slopes")};
    for (const Json& f : line.at("figures"))
      point.figures.push_back({f.at(0), f.at(1), f.at(2).is_null() ? std::nan("") : f.at(2).get<double>()});
    return point;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

PointHistory::PointHistory(std::filesystem::path file, std::string inputs)
    : file_(std::move(file)), inputs_(std::move(inputs)) {
  std::istringstream lines(formats::read_whole(file_).value_or(""));
  for (std::string line; std::getline(lines, line);) {
    if (auto point = read_line(line, inputs_))
      points_.push_back(std::move(*point));
    else
      others_ += line + "\n";
  }
}

const KnownPoint* PointHistory::find(const std::vector<double>& parameters) const {
  const auto at = std::ranges::find(points_, parameters, &KnownPoint::parameters);
  return at == points_.end() ? nullptr : &*at;
}

void PointHistory::store(KnownPoint point) {
  const auto at = std::ranges::find(points_, point.parameters, &KnownPoint::parameters);
  (at == points_.end() ? points_.emplace_back() : *at) = std::move(point);
  std::string text = others_;
  for (const KnownPoint& known : points_) text += line_of(known, inputs_);
  formats::write_whole(file_, text);
}

}  // namespace netloft::studies
