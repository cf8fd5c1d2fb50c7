// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/field_scale.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::results {

namespace {

// A logarithmic scale begins at least at this fraction of its upper end.
constexpr double kLeastOfLargest = 1e-4;
// The middle range of n values excludes the n/kBeyond smallest and the n/kBeyond largest values.
constexpr std::size_t kBeyond = 50;
constexpr std::size_t kSample = 20000;  // at most so many values of a state give the middle range
constexpr double kTicks = 6;            // largest number of ticks of a legend

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
double round_below(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1) * power;
}

double round_above(double least) {
  const double below = round_below(least), power = std::pow(10, std::floor(std::log10(least)));
  if (below >= least) return below;
  return (below < 1.5 * power ? 2 : below < 3 * power ? 5 : 10) * power;
}

std::vector<double> round_steps(double lo, double hi) {
  const double step = round_above((hi - lo) / kTicks);
  std::vector<double> ticks;
  for (double k = std::ceil(lo / step - 1e-9); k * step <= hi + 1e-9 * step; ++k)
    ticks.push_back(k * step + 0.0);  // turns -0 into 0
  return ticks;
}

/// Returns 1, 10, 100 …, or, if the range is shorter than two decades, 1, 2, 5, 10 …
std::vector<double> round_powers(double lo, double hi) {
  const bool is_short = hi < 100 * lo;
  std::vector<double> ticks;
  for (double power = std::pow(10, std::floor(std::log10(lo))); power <= hi; power *= 10)
    for (const double digit : {1.0, 2.0, 5.0})
      if ((digit == 1 || is_short) && digit * power >= lo * (1 - 1e-9) && digit * power <= hi * (1 + 1e-9))
        ticks.push_back(digit * power);
  return ticks;
}

CellKind kind_of(std::size_t kind) { return static_cast<CellKind>(kind); }

const std::vector<std::uint32_t>& cells_of(const StoredMesh& mesh, CellKind kind) {
  return kind == CellKind::netting ? mesh.triangle_cells
         : kind == CellKind::rope  ? mesh.bar_cells
                                   : mesh.dot_cells;
}

}  // namespace

double Scale::place(double value) const {
  const double at =
      is_logarithmic ? std::log(std::max(value, lo) / lo) / std::log(hi / lo) : (value - lo) / (hi - lo);
  return std::clamp(at, 0.0, 1.0);
}

double Scale::value(double place) const {
  return is_logarithmic ? lo * std::pow(hi / lo, place) : lo + place * (hi - lo);
}

std::vector<double> Scale::ticks() const {
  return is_logarithmic ? round_powers(lo, hi) : round_steps(lo, hi);
}

void FieldSpread::take(std::span<const double> values) {
  const std::size_t step = 1 + values.size() / kSample;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    lo_ = std::min(lo_, values[i]);
    hi_ = std::max(hi_, values[i]);
    if (i % step == 0 || sample_.empty()) sample_.push_back(values[i]);
  }
}

FieldSpread::Ends FieldSpread::ends(bool middle) const {
  if (!middle) return {lo_, hi_, lo_, hi_};
  std::vector<double> sorted = sample_;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t beyond = sorted.size() / kBeyond;
  return {lo_, hi_, sorted[beyond], sorted[sorted.size() - 1 - beyond]};
}

Scale FieldSpread::linear(bool middle) const {
  if (!is_known()) return {};
  const Ends e = ends(middle);
  Scale scale{e.low >= 0 && e.low < e.high / 2 ? 0 : e.low, e.high};
  if (!(scale.hi > scale.lo)) scale.hi = scale.lo + (scale.lo == 0 ? 1 : std::abs(scale.lo));
  scale.is_cut_below = e.lo < scale.lo;
  scale.is_cut_above = e.hi > scale.hi;
  return scale;
}

Scale FieldSpread::logarithmic(bool middle) const {
  if (!is_known() || ends(middle).high <= 0) return linear(middle);
  const Ends e = ends(middle);
  Scale scale{std::max(e.low, kLeastOfLargest * e.high), e.high, true};
  if (!(scale.hi > scale.lo)) scale.hi = 2 * scale.lo;
  scale.is_cut_below = e.lo < scale.lo;
  scale.is_cut_above = e.hi > scale.hi;
  return scale;
}

FieldSpreads spreads_of(const StoredShape& stored, const std::string& field) {
  FieldSpreads spreads;
  // In a static solve, only the last state counts, because the earlier states, the ends of stages, are not
  // equilibria.
  const std::size_t first = stored.stages.empty() ? 0 : stored.times.size() - 1;
  for (std::size_t state = first; state < stored.times.size(); ++state) {
    const auto values = stored.field(field, state);
    for (std::size_t kind = 0; kind < kCellKinds; ++kind) {
      std::vector<double> of_kind;
      for (const auto cell : cells_of(stored.mesh, kind_of(kind))) of_kind.push_back(values[cell]);
      spreads[kind].take(of_kind);
    }
  }
  return spreads;
}

FieldScales scales_of(const FieldSpreads& spreads, bool is_logarithmic) {
  FieldScales scales;
  for (std::size_t kind = 0; kind < kCellKinds; ++kind) {
    const bool middle = kind_of(kind) == CellKind::netting;
    if (spreads[kind].is_known())
      scales[kind] = is_logarithmic ? spreads[kind].logarithmic(middle) : spreads[kind].linear(middle);
  }
  return scales;
}

std::vector<std::array<double, 3>> values_at_corners(const StoredMesh& mesh,
                                                     const std::vector<double>& by_cell) {
  struct Mean {
    double sum = 0, count = 0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Mean> means;  // means by part and node
  const auto mean_at = [&](std::size_t t, std::size_t corner) -> Mean& {
    return means[{mesh.cell_part[mesh.triangle_cells[t]], mesh.triangles[t][corner]}];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      if (const double value = by_cell[mesh.triangle_cells[t]]; std::isfinite(value)) {
        mean_at(t, c).sum += value;
        mean_at(t, c).count += 1;
      }
  std::vector<std::array<double, 3>> corners(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      corners[t][c] =
          std::isfinite(by_cell[mesh.triangle_cells[t]]) ? mean_at(t, c).sum / mean_at(t, c).count : NAN;
  return corners;
}

}  // namespace netloft::results
