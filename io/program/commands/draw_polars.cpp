// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/draw_polars.hpp"

#include <netloft/interpolation.hpp>
#include <netloft/parameters.hpp>

#include "framework/parameters/parameter_values.hpp"
#include "io/formats/svg/plot.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/units/degrees.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/scenes/reading/parameter_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <set>

namespace netloft::program {

namespace {

constexpr const char *kPolar = "polar", *kSlip = "sideslip";

/// The polar of a board: coefficients of its force over the angles of the flow.
struct Polar {
  netloft_table attack{}, slip{}, centre{};
};

const std::vector<netloft_parameter>& columns() {
  static const auto table = [] {
    ParameterTable<Polar> t;
    t.table("attack", &Polar::attack, "coefficients over the angle of attack",
            {{"attack", "rad"}, {"lift", "1"}, {"drag", "1"}});
    t.grid("slip", &Polar::slip, "coefficients over attack and sideslip",
           {{"attack", "rad"}, {"sideslip", "rad"}, {"lift", "1"}, {"drag", "1"}, {"side", "1"}});
    t.table("centre", &Polar::centre, "centre of pressure over the angle of attack",
            {{"attack", "rad"}, {"chord", "1"}, {"span", "1"}});
    return t;
  }();
  static const std::vector<netloft_parameter> rows(table.rows().begin(), table.rows().end());
  return rows;
}

/// Adds a table to `all`, under the name of `table`: those of its columns that the part has.
void add_polar(const gears::CataloguePart& part, const netloft_parameter& table, formats::Table& all) {
  formats::Table own;
  formats::Place place;
  for (std::size_t k = 0; table.columns[k]; ++k)
    if (const auto column = part.tables.find(table.columns[k]); column != part.tables.end()) {
      own.members.push_back({table.columns[k], column->second.place, column->second});
      place = column->second.place;
    }
  if (own.members.size() > 1) all.members.push_back({table.name, place, {place, std::move(own)}});
}

Values read_polar(const gears::CataloguePart& part, formats::Diagnostics& diagnostics) {
  formats::Value all{{}, formats::Table{}};
  const bool has_slip = part.tables.contains(kSlip);
  for (const auto& table : columns())
    if (std::string_view(table.name) != (has_slip ? "attack" : "slip"))
      add_polar(part, table, *all.as<formats::Table>());
  formats::TableReader reader(all, diagnostics, formats::join_path(kPolar, part.name));
  return scenes::read_parameters(columns(), reader);
}

/// One line of a plot over the angle in degrees: the points of a table, and the curve interpolated between
/// them. `x` are the angles [rad].
formats::PlotSeries series_of(const std::string& name, const std::vector<double>& x,
                              const std::vector<double>& y, const std::function<double(double)>& curve) {
  constexpr int kPieces = 120;  // pieces of a curve, each a tenth of a millimetre in print
  formats::PlotSeries series{name, {}};
  for (std::size_t i = 0; i < x.size(); ++i)
    series.points.push_back({formats::kDegreesPerRadian * x[i], y[i]});
  for (int i = 0; i <= kPieces && !x.empty(); ++i) {
    const double at = std::lerp(x.front(), x.back(), static_cast<double>(i) / kPieces);
    series.curve.push_back({formats::kDegreesPerRadian * at, curve(at)});
  }
  return series;
}

void add_curves(const std::string& prefix, const netloft_table& table, const std::vector<std::string>& names,
                formats::LinePlot& plot) {
  for (std::uint32_t k = 0; k < names.size() && table.rows > 0; ++k) {
    const Curve curve(table, k + 1);
    plot.series.push_back(series_of(prefix + names[k], Curve::read(table, 0), Curve::read(table, k + 1),
                                    [&](double at) { return curve.at(at); }));
  }
}

/// Adds a line for each angle of sideslip.
void add_sections(const std::string& prefix, const netloft_table& table, formats::LinePlot& plot) {
  static constexpr const char* names[] = {"lift", "drag", "side"};
  const auto attack = Curve::read(table, 0), slip = Curve::read(table, 1);
  const std::set<double> slips(slip.begin(), slip.end());
  for (std::uint32_t k = 0; k < std::size(names); ++k)
    for (const double s : slips) {
      const Surface surface(table, k + 2);
      const auto values = Curve::read(table, k + 2);
      std::vector<double> x, y;
      for (std::size_t i = 0; i < slip.size(); ++i)
        if (slip[i] == s) {
          x.push_back(attack[i]);
          y.push_back(values[i]);
        }
      plot.series.push_back(
          series_of(fmt::format("{}{}, sideslip {:.3g}°", prefix, names[k], formats::kDegreesPerRadian * s),
                    x, y, [&](double at) { return surface.at(at, s); }));
    }
}

void add_polar(const gears::CataloguePart& part, const std::string& prefix, formats::LinePlot& plot,
               formats::Diagnostics& diagnostics) {
  const int errors_before = diagnostics.errors();
  const Values values = read_polar(part, diagnostics);
  std::vector<std::string> faults;
  const ParameterBlock block(columns(), sizeof(Polar), values, faults);
  if (diagnostics.errors() > errors_before || !faults.empty()) return;
  const Polar& polar = *static_cast<const Polar*>(block.data());
  add_curves(prefix, polar.attack, {"lift", "drag"}, plot);
  if (polar.slip.rows > 0) add_sections(prefix, polar.slip, plot);
  add_curves(prefix, polar.centre,
             {"centre of pressure, from the nose over the chord",
              "centre of pressure, above the middle over the span"},
             plot);
}

formats::LinePlot empty_plot(const std::string& title) {
  return {title, "angle of attack [°]",      "coefficient [1]",         {},
          {},    formats::AxisScale::linear, formats::AxisScale::linear};
}

}  // namespace

bool holds_polars(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  formats::Diagnostics silent;
  const formats::Document document = formats::Document::load(file, {}, silent);
  const formats::Table* root = document.root().as<formats::Table>();
  return root && root->find(kPolar);
}

std::string draw_polars(const std::filesystem::path& file, bool is_page, formats::Diagnostics& diagnostics) {
  const gears::Catalogue catalogue = gears::Catalogue::load_file(file, diagnostics);
  std::vector<const gears::CataloguePart*> polars;
  for (const auto& part : catalogue.parts())
    if (std::string_view(part.kind->name) == kPolar) polars.push_back(&part);
  const std::string heading = polars.size() == 1 ? polars[0]->name : file.stem().string();
  std::vector<formats::LinePlot> plots;
  if (!is_page) plots.push_back(empty_plot(heading));
  for (const gears::CataloguePart* polar : polars) {
    if (is_page) plots.push_back(empty_plot(polar->name));
    add_polar(*polar, is_page || polars.size() == 1 ? "" : polar->name + ": ", plots.back(), diagnostics);
  }
  return is_page ? formats::draw_html(heading, plots) : formats::draw_svg(plots.front());
}

}  // namespace netloft::program
