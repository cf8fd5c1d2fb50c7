// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/drums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace netloft::scenes::femnet {

namespace {

/// Thins out a sampled curve. Samples are dropped as long as the straight line between the kept samples
/// before and after them is within kHauledWithin of all dropped ones.
class Curve {
 public:
  explicit Curve(double first) : time_(0), value_(first), times_{0}, values_{first} {}

  void add(double time, double value) {
    const double slope = (value - values_.back()) / (time - times_.back());
    if (slope < low_ || slope > high_) {
      times_.push_back(time_);
      values_.push_back(value_);
      low_ = -kInfinite;
      high_ = kInfinite;
    }
    const double passed = time - times_.back();
    low_ = std::max(low_, (value - kHauledWithin - values_.back()) / passed);
    high_ = std::min(high_, (value + kHauledWithin - values_.back()) / passed);
    time_ = time;
    value_ = value;
  }
  /// Whether the value ever changed.
  bool changes() const {
    return std::any_of(values_.begin(), values_.end(), [&](double v) { return v != values_[0]; }) ||
           value_ != values_[0];
  }
  HauledBar finish(std::size_t bar, std::size_t number) {
    if (time_ > times_.back()) {
      times_.push_back(time_);
      values_.push_back(value_);
    }
    HauledBar out{bar, number, times_, {}};
    for (const double v : values_) out.shares.push_back(v / values_[0]);
    return out;
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double time_, value_;  // time and value of the last sample
  double low_ = -kInfinite, high_ = kInfinite;
  std::vector<double> times_, values_;
};

/// A cable that drums haul: its bars in the order of the file, the present length of each bar, and its length
/// over time.
struct Hauled {
  std::vector<std::size_t> bars;
  std::vector<double> lengths;
  std::vector<Curve> curves;
};

Hauled cable_of(const GearFile& gear, const MeshFile& file, int cable) {
  Hauled out;
  for (std::size_t b = 0; b < file.bars.size(); ++b) {
    const auto& bar = file.bars[b];
    if (bar.cable != cable + 1) continue;
    out.bars.push_back(b);
    out.lengths.push_back(gear.cables[static_cast<std::size_t>(cable)].length *
                          (bar.shares[1] - bar.shares[0]));
    out.curves.emplace_back(out.lengths.back());
  }
  return out;
}

/// The index of the interval of a drum's times that contains `time`; nullopt if `time` is before the first or
/// after the last of them.
std::optional<std::size_t> interval_at(const Drum& drum, double time) {
  for (std::size_t i = 0; i + 1 < drum.times.size(); ++i)
    if (time >= drum.times[i] && time <= drum.times[i + 1] && drum.times[i + 1] > drum.times[i]) return i;
  return {};
}

void step(const Drum& drum, double time, double dt, std::vector<double>& lengths) {
  const auto interval = interval_at(drum, time);
  if (!interval) return;
  const std::size_t i = *interval;
  const double s = drum.speeds[i] + (drum.speeds[i + 1] - drum.speeds[i]) * (time - drum.times[i]) /
                                        (drum.times[i + 1] - drum.times[i]);
  double left = std::abs(s) * dt;  // (1)
  const bool hauls = s >= 0, from_first = (drum.ends[i] == 1) == hauls;
  for (std::size_t n = 0; n < lengths.size() && left > 0; ++n) {
    double& l = lengths[from_first ? n : lengths.size() - 1 - n];
    const double room = std::max(0.0, hauls ? l - drum.shortest : drum.longest - l);
    const double taken = std::min(left, room);
    l += hauls ? -taken : taken;
    left -= taken;
  }
}

/// The position of each bar along its cable, from 0.
std::vector<std::size_t> places(const Hauled& cable, const MeshFile& file) {
  std::vector<std::size_t> order(cable.bars.size()), place(cable.bars.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return file.bars[cable.bars[a]].shares[0] < file.bars[cable.bars[b]].shares[0];
  });
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

}  // namespace

std::optional<std::vector<HauledBar>> haul(const GearFile& gear, const MeshFile& file) {
  std::map<int, Hauled> cables;
  double bars = 0;
  for (const Drum& drum : gear.drums)
    if (cables.try_emplace(drum.cable, cable_of(gear, file, drum.cable)).second)
      bars += static_cast<double>(cables.at(drum.cable).bars.size());
  const double dt = gear.environment.time_step,
               steps = dt > 0 ? std::floor(gear.environment.end / dt + 0.5) : 0;
  if (steps * (bars + 1) > kMostHauls) return {};
  for (double k = 0; k <= steps; ++k) {
    for (const Drum& drum : gear.drums) step(drum, k * dt, dt, cables.at(drum.cable).lengths);
    for (auto& [cable, c] : cables)
      for (std::size_t b = 0; b < c.bars.size() && k > 0; ++b) c.curves[b].add(k * dt, c.lengths[b]);
  }
  std::vector<HauledBar> out;
  for (auto& [cable, c] : cables) {
    const auto place = places(c, file);
    for (std::size_t b = 0; b < c.bars.size(); ++b)
      if (c.curves[b].changes()) out.push_back(c.curves[b].finish(c.bars[b], place[b]));
  }
  return out;
}

}  // namespace netloft::scenes::femnet
