// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study_plots.hpp"

#include "io/formats/text/likely_path.hpp"
#include "io/studies/sweep/study_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

constexpr std::size_t kMostLines = 8;  // more markers could not be told apart

std::string axis_title(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " [" + unit + "]";
}

/// Chooses rows and figures, and draws them. The member functions are the steps, in the order of execution.
class Plotter {
 public:
  Plotter(const StudyTable& table, const PlotRequest& request) : table_(table) {
    over_ = request.over.empty() ? first_number() : column(request.over);
    if (!table_.columns[over_].is_number)
      throw StudyError(name(over_) +
                       " has values that are no numbers; use --by to draw a line for each of them");
    by_ = choose_lines(request.by);
    for (const auto& [variable, value] : request.at) hold(column(variable), value);
    for (std::size_t v = 0; v < table_.columns.size(); ++v)
      if (is_listed(v) && v != over_ && v != by_ && !held_.contains(v)) hold_at_first(v);
    choose_rows();
    choose_figures(request.figures);
  }

  std::vector<formats::LinePlot> draw() const {
    std::vector<formats::LinePlot> plots;
    for (const std::size_t f : figures_) plots.push_back(draw_figure(f));
    return plots;
  }

 private:
  const std::string& name(std::size_t v) const { return table_.columns[v].variable.name; }
  bool is_listed(std::size_t v) const { return !table_.columns[v].is_sampled; }

  std::size_t column(const std::string& wanted) const {
    std::vector<std::string> names;
    for (std::size_t v = 0; v < table_.columns.size(); ++v) {
      if (name(v) == wanted) return v;
      names.push_back(name(v));
    }
    const auto near = nearest(wanted, names);
    throw StudyError("there is no variable \"" + wanted + "\"" +
                     (near ? "; did you mean \"" + *near + "\"?" : ""));
  }

  std::size_t first_number() const {
    for (const bool in_path : {true, false})
      for (std::size_t v = 0; v < table_.columns.size(); ++v)
        if (table_.columns[v].is_number && table_.columns[v].is_in_path == in_path) return v;
    throw StudyError("no variable of this study is a number that could be an axis");
  }

  /// All values of a listed variable, in the order of the table.
  std::vector<VariableValue> values_of(std::size_t v) const {
    std::vector<VariableValue> values;
    for (const StudyRow& row : table_.rows)
      if (std::none_of(values.begin(), values.end(),
                       [&](const auto& known) { return known.text == row.values[v].text; }))
        values.push_back(row.values[v]);
    return values;
  }

  /// The column of the variable that has a line for each of its values; the number of columns if there is
  /// none.
  std::size_t choose_lines(const std::string& wanted) const {
    const std::size_t none = table_.columns.size();
    if (!wanted.empty()) {
      const std::size_t v = column(wanted);
      if (v == over_) throw StudyError(wanted + " is the axis; --by names another variable");
      if (!is_listed(v))
        throw StudyError(wanted + " is sampled; --by needs a variable whose values are listed");
      if (values_of(v).size() > kMostLines)
        throw StudyError(fmt::format("{} has {} values, but a picture has room for {} lines only", wanted,
                                     values_of(v).size(), kMostLines));
      return v;
    }
    for (std::size_t v = 0; v < none; ++v)
      if (is_listed(v) && v != over_ && values_of(v).size() > 1 && values_of(v).size() <= kMostLines)
        return v;
    return none;
  }

  void hold(std::size_t v, const std::string& value) {
    if (!is_listed(v))
      throw StudyError(name(v) + " is sampled; only a variable with listed values can be held fixed");
    std::string known;
    for (const auto& one : values_of(v)) {
      if (one.text == value) held_[v] = value;
      known += (known.empty() ? "" : ", ") + one.text;
    }
    if (!held_.contains(v))
      throw StudyError(name(v) + " is never " + value + " in the study; its values are " + known);
  }

  void hold_at_first(std::size_t v) {
    if (const auto values = values_of(v); values.size() > 1) held_[v] = values.front().text;
  }

  bool is_wanted(const StudyRow& row) const {
    return std::all_of(held_.begin(), held_.end(),
                       [&](const auto& h) { return row.values[h.first].text == h.second; });
  }

  void choose_rows() {
    for (const StudyRow& row : table_.rows)
      if (row.record.status == "converged" && is_wanted(row)) rows_.push_back(&row);
    if (rows_.empty()) throw StudyError("no point that would be drawn has a stable equilibrium");
  }

  /// Chooses the named figures; without names, all figures that vary, except those of single parts.
  void choose_figures(const std::vector<std::string>& wanted) {
    std::vector<std::string> names;
    for (const StudyFigure& figure : table_.figures) names.push_back(figure.name);
    for (const std::string& one : wanted) {
      const auto at = std::find(names.begin(), names.end(), one);
      const auto near = formats::likely_path(one, names);
      if (at == names.end())
        throw StudyError("there is no figure \"" + one + "\"" +
                         (near ? "; did you mean \"" + *near + "\"?" : ""));
      figures_.push_back(static_cast<std::size_t>(at - names.begin()));
    }
    for (std::size_t f = 0; f < names.size() && wanted.empty(); ++f)
      if (varies(f) && names[f].find("_by_part/") == std::string::npos) figures_.push_back(f);
    if (figures_.empty()) throw StudyError("no figure of this study varies");
  }

  bool varies(std::size_t f) const {
    return std::any_of(rows_.begin(), rows_.end(),
                       [&](const StudyRow* row) { return row->figures[f] != rows_.front()->figures[f]; });
  }

  formats::LinePlot draw_figure(std::size_t f) const {
    const StudyFigure& figure = table_.figures[f];
    formats::LinePlot plot{title(),
                           axis_title(name(over_), table_.columns[over_].variable.unit),
                           axis_title(figure.name, figure.unit),
                           {},
                           {},
                           formats::AxisScale::linear,
                           formats::AxisScale::linear,
                           "some of the samples have no stable equilibrium here"};
    if (by_ == table_.columns.size()) {
      plot.series.push_back(series("", figure.name, f));
    } else {
      for (const auto& value : values_of(by_))
        plot.series.push_back(series(value.text, name(by_) + " " + value.text, f));
    }
    std::erase_if(plot.series, [](const formats::PlotSeries& s) { return s.points.empty(); });
    return plot;
  }

  std::string title() const {
    std::string text;
    for (const auto& [v, value] : held_) text += (text.empty() ? "at " : ", ") + name(v) + " " + value;
    return text;
  }

  bool is_of_line(const StudyRow& row, const std::string& value) const {
    return by_ == table_.columns.size() || row.values[by_].text == value;
  }

  /// The number of rows of one line at each x, including those without an equilibrium.
  std::map<double, std::size_t> samples_of(const std::string& value) const {
    std::map<double, std::size_t> samples;
    for (const StudyRow& row : table_.rows)
      if (is_wanted(row) && is_of_line(row, value)) ++samples[row.values[over_].number.value_or(NAN)];
    return samples;
  }

  /// The points of one line.
  formats::PlotSeries series(const std::string& value, const std::string& label, std::size_t f) const {
    formats::PlotSeries series{label, {}};
    std::map<double, std::vector<double>> samples;  // values of the samples at each x
    for (const StudyRow* row : rows_)
      if (is_of_line(*row, value) && std::isfinite(row->figures[f]))
        samples[row->values[over_].number.value_or(NAN)].push_back(row->figures[f]);
    series.is_line = is_listed(over_);
    const std::map<double, std::size_t> asked = samples_of(value);
    for (const auto& [x, sample] : samples) {
      if (!series.is_line) {
        for (const double y : sample) series.points.push_back({x, y});
        continue;
      }
      series.points.push_back({x, quantile_of(sample, 0.5), sample.size() < asked.at(x)});
      if (sample.size() > 1)
        series.band.push_back({x, quantile_of(sample, kBandLow), quantile_of(sample, kBandHigh)});
    }
    return series;
  }

  const StudyTable& table_;
  std::size_t over_ = 0, by_ = 0;
  std::map<std::size_t, std::string> held_;
  std::vector<const StudyRow*> rows_;
  std::vector<std::size_t> figures_;
};

}  // namespace

std::vector<formats::LinePlot> plots_of(const StudyTable& table, const PlotRequest& request) {
  return Plotter(table, request).draw();
}

}  // namespace netloft::studies
