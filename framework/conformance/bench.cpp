// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/bench.hpp"

#include "framework/conformance/checks.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>

namespace netloft::conformance {

namespace {

constexpr int kTriesPerElement = 50;
constexpr int kTriesPerState = 200;

}  // namespace

Bench::Bench(const ElementType& t, const ConformanceOptions& o)
    : type(t), options(o), sampler(t, o.seed), threads_before(threads_now()) {
  make_elements();
  if (specimen) make_states();
}

void Bench::make_elements() {
  const auto count = static_cast<std::size_t>(std::clamp(options.elements, 1, 640));
  sample.law_kind = options.law_kind;
  for (std::size_t p = 0; p < sampler.parts(); ++p) sample.parameters.push_back(sampler.parameters(p));
  for (std::size_t e = 0; e < count; ++e)
    sample.part.push_back(static_cast<std::uint32_t>(e % sample.parameters.size()));
  for (std::size_t e = 0; e < count; ++e) sampler.data(sample, e);
  for (std::size_t tries = 0; tries < kTriesPerElement * count; ++tries) try {
      refusal.clear();
      specimen = std::make_unique<Specimen>(type, sample);
      return;
    } catch (const Refused& e) {
      refusal = e.what();
      const std::size_t part = sample.part[e.element];
      sampler.data(sample, e.element);
      // The plugin may refuse a combination of defaults. Therefore parameters are drawn again, too.
      if (tries % 10 == 9) sample.parameters[part] = sampler.parameters(std::max<std::size_t>(part, 1));
    } catch (const Escaped& e) {
      escape = e.what();
      return;
    }
}

void Bench::make_states() {
  for (std::size_t first = 0; first < sample.part.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, sample.part.size() - first);
    States s = blank(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
    for (std::size_t lane = 0; lane < count; ++lane) sampler.state(sample, first + lane, s, lane);
    settle(s);
    if (!error.empty() || !escape.empty()) return;
    remember(s);
    tiles.push_back(std::move(s));
  }
  for (std::size_t tile = 1; tile < tiles.size(); tile += 2)  // every other tile has a moving ground
    tiles[tile].ground = {sampler.uniform(0.5, 2), sampler.uniform(-1, 1), 0};
}

/// Draws states again until all terms are inside their domain.
void Bench::settle(States& s) {
  for (int tries = 0; tries < kTriesPerState; ++tries) {
    bool settled = true;
    for (const auto& term : type.terms) settled = settled && is_settled(s, term);
    if (settled || !error.empty() || !escape.empty()) return;
  }
  error = "all of " + std::to_string(kTriesPerState) + " sampled states are outside the domain of some term";
}

/// Every other element gets the memory that it would have after a state nearby.
void Bench::remember(States& s) {
  if (s.memory.empty()) return;
  std::vector<double> step(kLanes, 0.0);
  for (std::size_t lane = 0; lane < s.count; ++lane) step[lane] = 0.1 * spacing(s, lane);
  for (const auto& term : type.terms) {
    const Answer past = specimen->evaluate(term, moved(s, random_field(), step), NETLOFT_WANT_FORCE);
    if (past.ok())
      for (std::size_t i = 0; i < past.memory.size(); ++i)
        if (i % 2) s.memory[i] = past.memory[i];
  }
}

bool Bench::is_settled(States& s, const netloft_term& term) {
  for (const auto want : wants_of(term)) {
    const Answer answer = specimen->evaluate(term, s, want);
    if (answer.ok()) continue;
    const std::size_t lane = std::min(answer.lane_at_fault, s.count - 1);
    const std::string told =
        place(term, s, lane) + ", output " + want_text(want) + ": " +
        (answer.message.empty() ? "status " + std::to_string(answer.status) : answer.message);
    if (answer.status == kThrew)
      escape = told;
    else if (answer.status != NETLOFT_OUTSIDE_DOMAIN)
      error = told;
    else
      sampler.state(sample, s.first + lane, s, lane);
    return false;
  }
  return true;
}

States Bench::blank(std::uint32_t first, std::uint32_t count) const {
  const std::vector<double> zero(dofs() * kLanes, 0.0);
  const std::vector<double> nothing(type.state_width * kLanes, 0.0);
  States s{first, count, zero, zero, zero, zero, zero, nothing};
  const auto some_read = [&](std::uint32_t trait) {
    return std::any_of(type.terms.begin(), type.terms.end(),
                       [&](const auto& t) { return (t.traits & trait) != 0; });
  };
  if (some_read(NETLOFT_READS_WAVES)) s.swing = zero;
  if (some_read(NETLOFT_READS_BED)) s.bed.assign(6 * static_cast<std::size_t>(type.nodes()) * kLanes, 0.0);
  return s;
}

std::string Bench::place(const netloft_term& term, const States& s, std::size_t lane) const {
  return "term " + std::string(term.name) + ", element " + std::to_string(s.first + lane);
}

double Bench::spacing(const States& s, std::size_t lane) const {
  if (type.is_on_body()) return 1;  // a rotation is not a position
  double least = dofs() == 3 ? 1 : size(s, lane) * 1e9;
  for (std::size_t p = 0; p < dofs(); p += 3)
    for (std::size_t q = 0; q < p; q += 3) {
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        square += std::pow(s.x[at(p + axis, lane)] - s.x[at(q + axis, lane)], 2);
      least = std::min(least, std::sqrt(square));
    }
  return std::max(least, 1e-6 * size(s, lane));
}

std::vector<double> Bench::random_field() {
  std::vector<double> field(dofs() * kLanes);
  for (std::size_t node = 0; node < dofs(); node += 3)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double d[3];
      sampler.direction(d);
      for (std::size_t axis = 0; axis < 3; ++axis) field[at(node + axis, lane)] = d[axis];
    }
  return field;
}

std::vector<double> Bench::force_scale(const netloft_term& term, const States& s) {
  std::vector<double> scale(kLanes, 0.0), step(kLanes, 0.0);
  for (int k = 0; k < 4; ++k) {
    const Answer answer = specimen->evaluate(term, moved(s, random_field(), step), NETLOFT_WANT_FORCE);
    for (std::size_t lane = 0; lane < s.count; ++lane) {
      step[lane] = 0.1 * spacing(s, lane);
      for (std::size_t d = 0; d < dofs() && answer.ok(); ++d)
        scale[lane] = std::max(scale[lane], std::abs(answer.force[at(d, lane)]));
    }
  }
  return scale;
}

Threads threads_now() {
  Threads numbers;
  std::error_code none;
  for (std::filesystem::directory_iterator task("/proc/self/task", none), end; task != end;
       task.increment(none))
    numbers.push_back(std::stoi(task->path().filename().string()));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

int number_of_this_thread() {
#if defined(__linux__)
  return gettid();
#else
  return 0;
#endif
}

void wait_until_gone(int thread) {
  const std::filesystem::path task = "/proc/self/task/" + std::to_string(thread);
  while (std::filesystem::exists(task)) std::this_thread::yield();
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_lane(const std::vector<double>& a, std::size_t i, const std::vector<double>& b, std::size_t j) {
  for (std::size_t row = 0; row * kLanes < a.size(); ++row)
    if (!same_bits(a[at(row, i)], b[at(row, j)])) return false;
  return true;
}

Finding judged_defaults(std::span<const netloft_parameter> table, std::size_t bytes, const Values& sampled) {
  std::vector<std::string> faults;
  const ParameterBlock block(table, bytes, required_of(table, sampled), faults);
  return judged(faults.empty() ? "" : faults.front());
}

Finding no_more_threads_than(const Threads& before) {
  if (before.empty()) return not_applicable("this system does not show the threads of a program");
  Threads more;
  std::ranges::set_difference(threads_now(), before, std::back_inserter(more));
  return more.empty() ? Finding{} : failed(std::to_string(more.size()) + " more threads");
}

States moved(const States& from, const std::vector<double>& direction, const std::vector<double>& step) {
  States to = from;
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    const std::size_t lane = i % kLanes, z = at(i / kLanes / 3 * 3 + 2, lane);
    to.x[i] += step[lane] * direction[i];
    to.current[i] += from.current_dz[i] * step[lane] * direction[z];
  }
  for (std::size_t node = 0; 6 * (node + 1) * kLanes <= to.bed.size(); ++node)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      move_bed(to, node, lane, step[lane] * direction[at(3 * node, lane)],
               step[lane] * direction[at(3 * node + 1, lane)]);
  return to;
}

double ratio(double a, double b) { return a == 0 ? 0 : std::abs(a) / std::abs(b); }

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace netloft::conformance
