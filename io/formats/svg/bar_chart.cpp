// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/bar_chart.hpp"

#include "io/formats/svg/linear_axis.hpp"
#include "io/formats/svg/style.hpp"
#include "io/formats/svg/svg.hpp"

#include <algorithm>
#include <array>

namespace netloft::formats {

namespace {

// Lengths are in units of the picture. Its width, kWidth units, is a column of 8.5 cm.
constexpr double kLeastNameRoom = 92, kEndRoom = 14, kHeadRoom = 6;
constexpr double kBar = 7, kRowGap = 5, kTitleHeight = 16, kWhisker = 1.6;
constexpr std::array<const char*, 4> kBarColours{"#0072b2", "#e69f00", "#009e73",
                                                 "#cc79a7"};  // colours of Okabe and Ito

std::vector<double> values_of(const BarChart& chart) {
  std::vector<double> values{0};
  for (const auto& group : chart.groups)
    for (const auto& row : group.rows)
      for (const auto& bar : row.bars) {
        values.push_back(bar.value + bar.error);
        values.push_back(bar.value - bar.error);
      }
  return values;
}

/// The width of the column of row names: enough for the longest name, but at most half of the picture.
double name_room(const BarChart& chart) {
  std::size_t longest = 0;
  for (const auto& group : chart.groups)
    for (const auto& row : group.rows) longest = std::max(longest, row.name.size());
  return std::clamp(kLetter * kText * static_cast<double>(longest) + 8, kLeastNameRoom, kWidth / 2);
}

/// Draws a chart from the top downwards.
class BarDrawing {
 public:
  explicit BarDrawing(const BarChart& chart)
      : chart_(chart), name_room_(name_room(chart)), axis_(values_of(chart)) {}

  std::string draw() {
    draw_grid();
    for (const auto& group : chart_.groups) draw_group(group);
    draw_axis();
    draw_legend();
    return picture_.finish(kWidth, y_);
  }

 private:
  double x(double value) const { return name_room_ + axis_.place(value) * (kWidth - name_room_ - kEndRoom); }

  double bottom() const {
    double y = kHeadRoom;
    for (const auto& group : chart_.groups)
      y += kTitleHeight + static_cast<double>(group.rows.size()) * row_height();
    return y;
  }
  double row_height() const { return kBar * static_cast<double>(chart_.kinds.size()) + kRowGap; }

  void draw_grid() {
    for (const auto& tick : axis_.ticks())
      picture_.line({x(tick.value), kHeadRoom}, {x(tick.value), bottom()}, kGrid, 0.6);
  }

  void draw_group(const BarChart::Group& group) {
    picture_.text({name_room_ + 5, y_ + 11}, group.title, kText, kInk, Anchor::start);
    y_ += kTitleHeight;
    for (const auto& row : group.rows) {
      picture_.text({name_room_ - 5, y_ + row_height() / 2 + 1}, row.name, kText, kInk, Anchor::end);
      for (std::size_t k = 0; k < row.bars.size(); ++k)
        draw_bar(row.bars[k], k, y_ + kBar * static_cast<double>(k));
      y_ += row_height();
    }
  }

  void draw_bar(const BarChart::Bar& bar, std::size_t kind, double y) {
    const double from = x(0), to = x(bar.value), low = x(bar.value - bar.error),
                 high = x(bar.value + bar.error);
    picture_.area({{from, y}, {to, y}, {to, y + kBar - 1}, {from, y + kBar - 1}}, colour(kind), 1);
    const double middle = y + (kBar - 1) / 2;
    picture_.line({low, middle}, {high, middle}, kInk, 0.8);
    for (const double end : {low, high})
      picture_.line({end, middle - kWhisker}, {end, middle + kWhisker}, kInk, 0.8);
  }

  void draw_axis() {
    picture_.frame({name_room_, kHeadRoom}, {kWidth - kEndRoom, bottom()}, kInk);
    picture_.line({x(0), kHeadRoom}, {x(0), bottom()}, kInk, 0.8);
    for (const auto& tick : axis_.ticks())
      if (tick.labelled)
        picture_.number({x(tick.value), bottom() + 13}, tick.value, false, kText, Anchor::middle);
    picture_.text({(name_room_ + kWidth - kEndRoom) / 2, bottom() + 28}, chart_.x_label, kText, kInk,
                  Anchor::middle);
    y_ = bottom() + kAxisRoom;
  }

  void draw_legend() {
    for (std::size_t k = 0; k < chart_.kinds.size(); ++k, y_ += kLegendLine) {
      picture_.area(
          {{name_room_, y_}, {name_room_ + 14, y_}, {name_room_ + 14, y_ + 7}, {name_room_, y_ + 7}},
          colour(k), 1);
      picture_.text({name_room_ + 20, y_ + 7.5}, chart_.kinds[k], kText, kInk, Anchor::start);
    }
  }

  static const char* colour(std::size_t kind) { return kBarColours[kind % kBarColours.size()]; }

  const BarChart& chart_;
  double name_room_;
  LinearAxis axis_;
  SvgPicture picture_;
  double y_ = kHeadRoom;
};

}  // namespace

std::string draw_svg(const BarChart& chart) { return BarDrawing(chart).draw(); }

}  // namespace netloft::formats
