// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/record.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/formats/hdf5/checksum.hpp"
#include "io/formats/text/printable.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <map>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;

std::string sum_line(std::string_view text) { return fmt::format("crc32 {:08x}\n", formats::checksum(text)); }

/// Checks the name of a figure, which becomes a path in the table of the study, and its unit.
void require_plain(const StudyFigure& figure) {
  const std::string& name = figure.name;
  const bool is_path =
      !name.empty() && name.front() != '/' && name.back() != '/' && name.find("//") == std::string::npos;
  if (!is_path || formats::has_control_characters(name + figure.unit))
    throw StudyError("a figure cannot be called " + formats::in_quotes(name) + " with the unit " +
                     formats::in_quotes(figure.unit));
}

/// The names of all figures of a record, each once, in the order in which they first occur.
class FigureNames {
 public:
  explicit FigureNames(const std::vector<PointRecord>& points) {
    for (const PointRecord& point : points)
      for (const StudyFigure& figure : point.figures)
        if (places_.emplace(figure.name, all_.size()).second)
          all_.push_back({figure.name, figure.unit, std::numeric_limits<double>::quiet_NaN()});
  }
  const std::vector<StudyFigure>& all() const { return all_; }
  /// The values of a point in the order of all(); NaN if a figure is missing.
  std::vector<double> values_of(const PointRecord& point) const {
    std::vector<double> values(all_.size(), std::numeric_limits<double>::quiet_NaN());
    for (const StudyFigure& figure : point.figures) values[places_.at(figure.name)] = figure.value;
    return values;
  }

 private:
  std::vector<StudyFigure> all_;
  std::map<std::string, std::size_t> places_;
};

Json point_json(const PointRecord& point, const FigureNames& names) {
  Json values = Json::array();
  for (const double value : names.values_of(point))
    values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
  return {{"status", point.status},     {"stability", point.stability},
          {"reason", point.reason},     {"start", point.start},
          {"events", point.events},     {"iterations", point.iterations},
          {"work", point.work},         {"factorisations", point.factorisations},
          {"values", std::move(values)}};
}

PointRecord read_point(const Json& json, const std::vector<StudyFigure>& names) {
  PointRecord point;
  json.at("status").get_to(point.status);
  point.stability = json.value("stability", "");  // missing in records of older versions
  json.at("reason").get_to(point.reason);
  json.at("start").get_to(point.start);
  json.at("events").get_to(point.events);
  json.at("iterations").get_to(point.iterations);
  json.at("factorisations").get_to(point.factorisations);
  json.at("work").get_to(point.work);
  const Json& values = json.at("values");
  if (values.size() != names.size())
    throw StudyError("a point has another number of figures than there are names");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!values[i].is_null())
      point.figures.push_back({names[i].name, names[i].unit, values[i].get<double>()});
  return point;
}

}  // namespace

std::string record_text(const ItemRecord& record) {
  const FigureNames names(record.points);
  Json figures = Json::array(), points = Json::array();
  for (const StudyFigure& figure : names.all())
    figures.push_back({{"name", figure.name}, {"unit", figure.unit}});
  for (const PointRecord& point : record.points) points.push_back(point_json(point, names));
  const Json json = {{"hash", record.hash},
                     {"program", record.program},
                     {"figures", std::move(figures)},
                     {"points", std::move(points)},
                     {"cost",
                      {{"wall_seconds", record.cost.wall_seconds},
                       {"cpu_seconds", record.cost.cpu_seconds},
                       {"host", record.cost.host},
                       {"started", record.cost.started}}}};
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return text + sum_line(text);
}

ItemRecord read_record(const std::string& text, const StudyItem& item) {
  const std::size_t sum = std::string("crc32 00000000\n").size();
  if (text.size() <= sum || text.substr(text.size() - sum) != sum_line({text.data(), text.size() - sum}))
    throw StudyError("it is damaged: it does not match its checksum");
  try {
    const Json json = Json::parse(text.begin(), text.end() - static_cast<std::ptrdiff_t>(sum));
    ItemRecord record;
    json.at("hash").get_to(record.hash);
    json.at("program").get_to(record.program);
    std::vector<StudyFigure> names;
    for (const Json& f : json.at("figures"))
      require_plain(names.emplace_back(
          StudyFigure{f.at("name").get<std::string>(), f.at("unit").get<std::string>(), 0}));
    for (const Json& point : json.at("points")) record.points.push_back(read_point(point, names));
    const Json& cost = json.at("cost");
    cost.at("wall_seconds").get_to(record.cost.wall_seconds);
    cost.at("cpu_seconds").get_to(record.cost.cpu_seconds);
    cost.at("host").get_to(record.cost.host);
    cost.at("started").get_to(record.cost.started);
    if (record.hash != item.hash || record.points.size() != item.points.size())
      throw StudyError("it is the record of another item");
    return record;
  } catch (const Json::exception& e) {
    throw StudyError(std::string("it cannot be understood (") + e.what() + ")");
  }
}

std::optional<ItemRecord> find_record(const std::filesystem::path& folder, const StudyItem& item,
                                      std::string& fault) {
  const auto path = record_path(folder, item);
  try {
    const auto text = formats::read_whole(path);
    return text ? std::optional(read_record(*text, item)) : std::nullopt;
  } catch (const StudyError& e) {
    fault = path.string() + ": " + e.what();
  } catch (const formats::ReadError& e) {
    fault = e.what();
  }
  return std::nullopt;
}

}  // namespace netloft::studies
