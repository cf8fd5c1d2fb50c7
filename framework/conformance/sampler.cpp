// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/sampler.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

struct Usual {
  const char* unit;
  double least, most;
};

/// Usual values of a parameter in fishing gears, by unit; 0.1 to 10 for other units.
constexpr Usual kUsual[] = {
    {"N", 1e2, 1e5},   {"N/m", 1e2, 1e5},   {"N/m2", 1e8, 1e10}, {"Pa", 1e8, 1e10},
    {"m", 0.01, 1},    {"m2", 1e-4, 1},     {"m3", 1e-4, 1},     {"kg", 1, 100},
    {"kg/m", 0.1, 10}, {"kg/m3", 500, 8e3}, {"rad", 0.1, 1.5},   {"1", 0.1, 2},
};

Usual usual(const char* unit) {
  for (const auto& u : kUsual)
    if (std::string_view(u.unit) == unit) return u;
  return {unit, 0.1, 10};
}

std::size_t count_words(const netloft_parameter& p) {
  std::size_t count = 0;
  while (p.choices[count]) ++count;
  return count;
}

bool has_default(const netloft_parameter& p) {
  if (p.flags & NETLOFT_REQUIRED) return false;
  if (p.kind != NETLOFT_REAL && p.kind != NETLOFT_INTEGER) return true;
  return p.fallback_of || (p.fallback >= p.lo && p.fallback <= p.hi);
}

}  // namespace

double ParameterSampler::uniform(
    double lo,
    double hi) {  // std::uniform_real_distribution is not used, because it differs between libraries
  return lo + (hi - lo) * (static_cast<double>(random_() >> 11) * 0x1p-53);
}

void ParameterSampler::direction(double (&d)[3]) {
  double square = 2;
  while (square > 1 || square < 0.01) {
    for (double& c : d) c = uniform(-1, 1);
    square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  }
  for (double& c : d) c /= std::sqrt(square);
}

std::size_t ParameterSampler::parts() const {
  std::size_t parts = 6;
  for (const auto& p : table_)
    if (p.kind == NETLOFT_CHOICE) parts = std::max(parts, count_words(p));
  return parts;
}

Values ParameterSampler::parameters(std::size_t part) {
  Values values;
  for (const auto& p : table_) {
    if (p.kind > NETLOFT_TABLE) continue;  // an unknown kind keeps its default
    const auto before = random_;  // restored below, so that a table does not affect the samples after it
    const bool leave_out = part == 0 || (p.kind != NETLOFT_CHOICE && uniform(0, 1) < 0.5);
    if (!leave_out || !has_default(p)) values[p.name] = value(p, part);
    if (p.kind == NETLOFT_TABLE) random_ = before;
  }
  return values;
}

Values required_of(std::span<const netloft_parameter> table, const Values& sampled) {
  Values required;
  for (const auto& p : table)
    if (p.flags & NETLOFT_REQUIRED) required[p.name] = sampled.at(p.name);
  return required;
}

Value ParameterSampler::value(const netloft_parameter& p, std::size_t part) {
  switch (p.kind) {
    case NETLOFT_INTEGER:
      return static_cast<std::int64_t>(std::floor(uniform(p.lo, std::min(p.hi, p.lo + 99) + 1)));
    case NETLOFT_BOOLEAN:
      return uniform(0, 1) < 0.5;
    case NETLOFT_CHOICE:
      return std::string(p.choices[part % count_words(p)]);
    case NETLOFT_TEXT:
      return std::string(p.fallback_text ? p.fallback_text : "sample");
    case NETLOFT_TABLE:
      return rows(p);
    default:
      return real(p.lo, p.hi, usual(p.unit).least, usual(p.unit).most);
  }
}

Samples ParameterSampler::rows(const netloft_parameter& p) {
  Samples rows(4);
  for (std::size_t column = 0; p.columns[column]; ++column) {
    std::vector<double> numbers(rows.size());
    const Usual range = usual(p.column_units[column]);
    for (double& n : numbers) n = real(0, 1e300, range.least, range.most);
    if (column < std::max(p.arguments, 1u)) std::sort(numbers.begin(), numbers.end());
    if (p.arguments == 2 && column < 2)  // two values of each argument: a grid of four rows
      numbers = column == 0 ? std::vector{numbers[0], numbers[0], numbers[3], numbers[3]}
                            : std::vector{numbers[0], numbers[3], numbers[0], numbers[3]};
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].push_back(numbers[row]);
  }
  return rows;
}

double ParameterSampler::real(double lo, double hi, double least, double most) {
  if (lo <= most && hi >= least)
    return std::exp(uniform(std::log(std::max(lo, least)), std::log(std::min(hi, most))));
  const double near = std::isfinite(lo) ? lo : hi - std::abs(hi);  // the range contains no usual value
  const double far = std::isfinite(hi) ? hi : lo + std::abs(lo);
  return uniform(near, far);
}

bool Sampler::is_corner(const netloft_datum& datum) const {
  return static_cast<int>(datum.width) == type_.nodes() && datum.width > 1 &&
         std::string_view(datum.unit) == "1";
}

double Sampler::number(const netloft_datum& datum) {
  if (is_corner(datum)) return uniform(-4, 4);
  if (const HostDatum* of_host = find_datum_on(type_.element.stencil, datum.name);
      of_host && of_host->is_sign)
    return uniform(0, 1) < 0.5 ? -1 : 1;
  const std::string_view unit = datum.unit;
  if (unit == "m") return std::exp(uniform(std::log(0.5), std::log(2.0)));
  if (unit != "1") return real(0, 1e300, usual(datum.unit).least, usual(datum.unit).most);
  return uniform(0, 1) < 0.25 ? double(below(3)) - 1 : uniform(0.2, 1.8);
}

void Sampler::data(Sample& sample, std::size_t element) {
  sample.data.resize(type_.data.size());
  do {
    for (std::size_t k = 0; k < type_.data.size(); ++k) {
      const std::size_t width = type_.data[k].width;
      sample.data[k].resize(sample.part.size() * width);
      for (std::size_t i = 0; i < width; ++i) sample.data[k][element * width + i] = number(type_.data[k]);
    }
  } while (covers_nothing(sample, element));
}

bool Sampler::covers_nothing(const Sample& sample, std::size_t element) const {
  std::vector<const double*> corners;
  for (std::size_t k = 0; k < type_.data.size(); ++k)
    if (is_corner(type_.data[k])) corners.push_back(&sample.data[k][element * type_.data[k].width]);
  if (type_.nodes() != 3 || corners.size() < 2) return false;
  const double *u = corners[0], *v = corners[1];
  return std::abs((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0])) < 4;
}

double Sampler::length(const Sample& sample, std::size_t element) const {
  for (std::size_t k = 0; k < type_.data.size(); ++k)
    if (std::string_view(type_.data[k].unit) == "m")
      return std::abs(sample.data[k][element * type_.data[k].width]);
  return 1;
}

double Sampler::size(const Sample& sample, std::size_t element) const {
  double extent = 0;
  for (std::size_t k = 0; k < type_.data.size(); ++k) {
    if (!is_corner(type_.data[k])) continue;
    const double* c = &sample.data[k][element * type_.data[k].width];
    const auto [lo, hi] = std::minmax_element(c, c + type_.data[k].width);
    extent = std::max(extent, *hi - *lo);
  }
  return length(sample, element) * (extent > 0 ? extent : 1);
}

void Sampler::state(const Sample& sample, std::size_t element, States& s, std::size_t lane) {
  const auto dofs = static_cast<std::size_t>(type_.dofs());
  const double length = size(sample, element);
  const double nearly_collapsed = element % 8 == 7 ? 1e-3 : 1;
  const double width = length * nearly_collapsed * std::exp(uniform(std::log(0.1), std::log(3.0)));
  const double centre[3] = {uniform(-2, 2), uniform(-2, 2), uniform(-12, -8)};
  for (std::size_t d = 0; d < dofs; ++d) {
    s.x[at(d, lane)] = centre[d % 3] + width * uniform(-0.5, 0.5);
    s.v[at(d, lane)] = uniform(-1, 1);
    s.a[at(d, lane)] = uniform(-1, 1);
    s.current[at(d, lane)] = uniform(-1, 1);
    s.current_dz[at(d, lane)] = uniform(-0.1, 0.1);
    // This draws no random number, so that all other samples are the same as without waves.
    if (!s.swing.empty()) s.swing[at(d, lane)] = 10 * s.current_dz[at(d, lane)];
  }
  if (type_.is_on_body()) turn(s, lane);
  for (std::size_t node = 0; 6 * (node + 1) * kLanes <= s.bed.size(); ++node) lay_bed(s, node, length, lane);
}

/// Draws a bed for a node. The bed is as often above the node as below it.
void Sampler::lay_bed(States& s, std::size_t node, double length, std::size_t lane) {
  s.bed[at(6 * node, lane)] = s.x[at(3 * node + 2, lane)] + length * uniform(-0.5, 0.5);
  for (std::size_t k = 1; k < 6; ++k)
    s.bed[at(6 * node + k, lane)] = uniform(-0.2, 0.2) / (k < 3 ? 1 : length);
}

void Sampler::turn(States& s, std::size_t lane) {
  constexpr double kTwoTurns = 12.566370614359172;
  double axis[3];
  direction(axis);
  const double angle = uniform(0, kTwoTurns);
  for (std::size_t k = 0; k < 3; ++k) s.x[at(3 + k, lane)] = angle * axis[k];
}

}  // namespace netloft::conformance
