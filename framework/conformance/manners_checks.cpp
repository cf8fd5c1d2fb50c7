// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <barrier>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <thread>

namespace netloft::conformance {

namespace {

using conformance::same_lane;

bool same_lane(const Answer& a, std::size_t i, const Answer& b, std::size_t j) {
  return same_lane(a.energy, i, b.energy, j) && same_lane(a.force, i, b.force, j) &&
         same_lane(a.matrix, i, b.matrix, j) && same_lane(a.memory, i, b.memory, j);
}

/// The first element below `count` for which two answers differ; `count` if there is none.
std::size_t first_difference(const Answer& a, const Answer& b, std::size_t count) {
  std::size_t lane = 0;
  while (lane < count && same_lane(a, lane, b, lane)) ++lane;
  return lane;
}

/// Calls `ask(term, states, want)` for all terms, tiles and combinations of outputs. `ask` returns a fault or
/// an empty string.
template <class Ask>
Finding ask_all(Bench& b, Ask&& ask) {
  for (const auto& term : b.type.terms)
    for (const auto& s : b.tiles)
      for (const auto want : wants_of(term))
        if (const std::string fault = ask(term, s, want); !fault.empty())
          return failed(fault + ", output " + want_text(want));
  return {};
}

void copy_lane(const States& from, std::size_t i, States& to, std::size_t j) {
  for (const auto field : kFields)
    for (std::size_t row = 0; row * kLanes < (from.*field).size(); ++row)
      (to.*field)[at(row, j)] = (from.*field)[at(row, i)];
}

}  // namespace

Finding no_hidden_state(Bench& b) {
  return ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    const Answer before = b.specimen->evaluate(term, s, want);
    const std::vector<double> step(kLanes, 0.1);
    b.specimen->evaluate(term, moved(s, b.random_field(), step), want);
    const Answer after = b.specimen->evaluate(term, s, want);
    const std::size_t lane = first_difference(before, after, s.count);
    return lane == s.count ? "" : b.place(term, s, lane) + ": two calls give different answers";
  });
}

namespace {

constexpr double kCanary = -7.25e-300;  // small, so that adding any number to it is visible
constexpr std::size_t kMargin = 4 * kLanes;

/// An array to which a term may add, initially zero. The entries before and after the array, and the entries
/// of unused lanes (from `count` on), hold a known number.
struct Guarded {
  Guarded(std::size_t rows, std::size_t count) : values(rows * kLanes + 2 * kMargin, kCanary) {
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t lane = 0; lane < count; ++lane) values[kMargin + at(row, lane)] = 0;
  }
  bool is_intact(std::size_t rows, std::size_t count) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool inside = i >= kMargin && i < kMargin + rows * kLanes && (i - kMargin) % kLanes < count;
      if (!inside && !same_bits(values[i], kCanary)) return false;
    }
    return true;
  }
  double* data() { return values.data() + kMargin; }
  std::vector<double> values;
};

/// Calls a term with guarded arrays, and with inputs that are NaN in unused lanes (from `count` on). Returns
/// a sentence if the term wrote outside the permitted entries.
std::string trespass(const Bench& b, const netloft_term& term, States s, std::uint32_t count,
                     std::uint32_t want) {
  for (const auto field : kFields)
    for (std::size_t i = 0; i < (s.*field).size(); ++i)
      if (i % kLanes >= count) (s.*field)[i] = std::numeric_limits<double>::quiet_NaN();
  s.count = count;
  const std::size_t dofs = b.dofs(), entries = b.specimen->entries(term),
                    remembered = b.specimen->remembered(term);
  Guarded energy(1, count), force(dofs, count), matrix(entries, count), memory(remembered, count);
  const States before = s;
  b.specimen->evaluate_into(term, s, want, {}, energy.data(), force.data(), matrix.data(), memory.data());
  const std::string who = "term " + std::string(term.name) + ", " + std::to_string(count) + " elements: ";
  if ((want & NETLOFT_WANT_ENERGY) && !energy.is_intact(1, count)) return who + "wrote outside the energies";
  if ((want & NETLOFT_WANT_FORCE) && !force.is_intact(dofs, count)) return who + "wrote outside the forces";
  if (wants_matrix(want) && !matrix.is_intact(entries, count)) return who + "wrote outside the matrix";
  if (!memory.is_intact(remembered, count)) return who + "wrote outside state_new";
  for (const auto field : kFields)
    if (!(s.*field).empty() &&
        std::memcmp((s.*field).data(), (before.*field).data(), (s.*field).size() * sizeof(double)) != 0)
      return who + "wrote to its inputs";
  return {};
}

}  // namespace

Finding nothing_written_past_count(Bench& b) {
  return ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    for (const std::uint32_t count : {1u, 2u, 3u, 5u, 8u, 31u, 63u, 64u})
      if (count <= s.count)
        if (auto fault = trespass(b, term, s, count, want); !fault.empty()) return fault;
    return {};
  });
}

namespace {

double largest(const std::vector<double>& values, std::size_t lane) {
  double most = 0;
  for (std::size_t row = 0; row * kLanes < values.size(); ++row)
    most = std::max(most, std::abs(values[at(row, lane)]));
  return most;
}

/// Fills an array with numbers of the size of the answer, different in every entry.
void prefill(std::vector<double>& values, const std::vector<double>& like) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (largest(like, i % kLanes) + 1) * (1 + 0.01 * static_cast<double>(i / kLanes % 7));
}

/// Error of `sum`, relative to the largest number of the element. The correct sum is the result of prefill()
/// plus `answer`.
double adding_error(const std::vector<double>& sum, const std::vector<double>& answer, std::size_t lane) {
  std::vector<double> before(answer.size());
  prefill(before, answer);
  double worst = 0;
  for (std::size_t row = 0; row * kLanes < answer.size(); ++row) {
    const std::size_t i = at(row, lane);
    worst = std::max(worst, std::abs(sum[i] - (before[i] + answer[i])) / (largest(answer, lane) + 1));
  }
  return worst;
}

}  // namespace

Finding adds_not_overwrites(Bench& b) {
  Worst worst(1e-10);
  ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    const Answer answer = b.specimen->evaluate(term, s, want);
    Answer sum = answer;
    prefill(sum.energy, answer.energy);
    prefill(sum.force, answer.force);
    prefill(sum.matrix, answer.matrix);
    b.specimen->evaluate(term, s, want, {}, sum);
    for (std::size_t lane = 0; lane < s.count; ++lane)
      worst.note(std::max({adding_error(sum.energy, answer.energy, lane),
                           adding_error(sum.force, answer.force, lane),
                           adding_error(sum.matrix, answer.matrix, lane)}),
                 [&] { return b.place(term, s, lane) + ", output " + want_text(want); });
    return {};
  });
  return judged(worst, "the element has no terms");
}

namespace {

/// The sampled elements in another order, each with its state.
struct Shuffled {
  explicit Shuffled(Bench& b) : order(b.sample.part.size()), sample(b.sample), states(b.tiles) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[b.sampler.below(i)]);
    for (std::size_t to = 0; to < order.size(); ++to) move(b, order[to], to);
  }
  void move(const Bench& b, std::size_t from, std::size_t to) {
    sample.part[to] = b.sample.part[from];
    for (std::size_t k = 0; k < sample.data.size(); ++k) {
      const std::size_t width = b.type.data[k].width;
      std::copy_n(&b.sample.data[k][from * width], width, &sample.data[k][to * width]);
    }
    copy_lane(b.tiles[from / kLanes], from % kLanes, states[to / kLanes], to % kLanes);
  }
  std::vector<std::size_t> order;  // index in `states` -> element of the fixture
  Sample sample;
  std::vector<States> states;
};

/// Gives states the same ground velocity, so that elements can be moved between tiles.
States over(States s, const std::vector<double>& ground) {
  s.ground = ground;
  return s;
}

std::string differs_when_shuffled(const Bench& b, const Specimen& other, const Shuffled& shuffled,
                                  const netloft_term& term, std::uint32_t want) {
  std::vector<Answer> answers;
  const auto& ground = b.tiles.back().ground;
  for (const auto& s : b.tiles) answers.push_back(b.specimen->evaluate(term, over(s, ground), want));
  for (const auto& s : shuffled.states) {
    const Answer moved_answer = other.evaluate(term, over(s, ground), want);
    for (std::size_t lane = 0; lane < s.count; ++lane) {
      const std::size_t from = shuffled.order[s.first + lane];
      if (!same_lane(moved_answer, lane, answers[from / kLanes], from % kLanes))
        return b.place(term, b.tiles[from / kLanes], from % kLanes) + ": differs as element " +
               std::to_string(s.first + lane);
    }
  }
  return {};
}

std::string differs_in_shorter_tile(const Bench& b, const netloft_term& term, const States& s,
                                    std::uint32_t want) {
  const Answer full = b.specimen->evaluate(term, s, want);
  States shorter = s;
  for (shorter.count = 1; shorter.count < s.count; ++shorter.count) {
    const Answer part = b.specimen->evaluate(term, shorter, want);
    if (const auto lane = first_difference(full, part, shorter.count); lane < shorter.count)
      return b.place(term, s, lane) + ": differs in a tile of " + std::to_string(shorter.count);
  }
  return {};
}

}  // namespace

Finding same_in_any_lane(Bench& b) {
  const Shuffled shuffled(b);
  const Specimen other(b.type, shuffled.sample);
  return ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    if (auto fault = differs_in_shorter_tile(b, term, s, want); !fault.empty()) return fault;
    return s.first == 0 ? differs_when_shuffled(b, other, shuffled, term, want) : "";
  });
}

namespace {

/// Checks that one output has the same bits whether or not other outputs are requested.
Finding same_alone(Bench& b, std::uint32_t part, std::vector<double> Answer::*values) {
  return ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    if (!(want & part)) return {};
    const Answer alone = b.specimen->evaluate(term, s, part), with = b.specimen->evaluate(term, s, want);
    for (std::size_t lane = 0; lane < s.count; ++lane)
      if (!same_lane(alone.*values, lane, with.*values, lane))
        return b.place(term, s, lane) + ": differs from the same output alone";
    return {};
  });
}

}  // namespace

Finding same_force_without_tangent(Bench& b) { return same_alone(b, NETLOFT_WANT_FORCE, &Answer::force); }

Finding same_energy_alone(Bench& b) { return same_alone(b, NETLOFT_WANT_ENERGY, &Answer::energy); }

namespace {

constexpr int kRoundsPerThread = 50, kRoundsApart = 10;

/// Evaluates a tile repeatedly, in one of two threads. The threads wait for each other from time to time: on
/// a busy machine, the second thread could otherwise start after the first has ended.
std::size_t count_differences(const Bench& b, const netloft_term& term, const States& s, std::uint32_t want,
                              const Answer& expected, std::barrier<>& both) {
  std::size_t differences = 0;
  for (int round = 0; round < kRoundsPerThread; ++round) {
    if (round % kRoundsApart == 0) both.arrive_and_wait();
    differences += first_difference(expected, b.specimen->evaluate(term, s, want), s.count) < s.count;
  }
  return differences;
}

std::string differs_between_threads(const Bench& b, const netloft_term& term, const States& one,
                                    const States& two, std::uint32_t want) {
  const Answer first = b.specimen->evaluate(term, one, want), second = b.specimen->evaluate(term, two, want);
  std::size_t there = 0;
  int number = 0;
  std::barrier both(2);
  std::thread other([&] {
    number = number_of_this_thread();
    there = count_differences(b, term, two, want, second, both);
  });
  const std::size_t here = count_differences(b, term, one, want, first, both);
  other.join();
  wait_until_gone(number);
  return here + there == 0 ? ""
                           : "term " + std::string(term.name) + ": differs when two threads evaluate at once";
}

}  // namespace

Finding same_from_two_threads(Bench& b) {
  return ask_all(b, [&](const netloft_term& term, const States& s, std::uint32_t want) -> std::string {
    if (s.first != 0) return {};
    const std::vector<double> step(kLanes, 0.1);
    return differs_between_threads(b, term, s, moved(b.tiles.back(), b.random_field(), step), want);
  });
}

namespace {

/// Whether no thread and no process starts during `work`. The system numbers new threads and processes
/// consecutively. If nothing else starts, a thread started before the work and one started after it have
/// consecutive numbers.
template <class Work>
bool nothing_begins_during(Work&& work) {
  int before = 0, after = 0;
  std::thread one([&] { before = number_of_this_thread(); });
  work();
  std::thread two([&] { after = number_of_this_thread(); });
  one.join(), two.join();
  return after == before + 1;
}

enum class Starts { none, some, unknown };

/// Whether `work` starts threads, however short-lived. Other programs start threads, too. Therefore each try
/// observes the work, and then an equally long pause. The answer is `none` as soon as a try sees no new
/// thread during the work. It is `some` if every try sees a new thread during the work, although kProof of
/// the pauses had none. It is `unknown` if other programs start threads all the time.
template <class Work>
Starts threads_started_by(Work&& work) {
  using Clock = std::chrono::steady_clock;
  constexpr int kProof = 20, kTries = 2000;
  for (int quiet = 0, tries = 0; tries < kTries && quiet < kProof; ++tries) {
    Clock::duration took{};
    const auto timed_work = [&] {
      const auto begun = Clock::now();
      work();
      took = Clock::now() - begun;
    };
    if (nothing_begins_during(timed_work)) return Starts::none;
    quiet += nothing_begins_during([&] {
      for (const auto end = Clock::now() + took; Clock::now() < end;) continue;
    });
    if (quiet == kProof) return Starts::some;
  }
  return Starts::unknown;
}

}  // namespace

Finding starts_no_threads(Bench& b) {
  constexpr int kRounds = 5;
  const Finding kept = no_more_threads_than(b.threads_before);
  if (!kept.passed || kept.skipped || b.tiles.empty()) return kept;
  const Starts started = threads_started_by([&] {
    for (int round = 0; round < kRounds; ++round)
      for (const auto& term : b.type.terms) b.specimen->evaluate(term, b.tiles[0], NETLOFT_WANT_FORCE);
  });
  if (started == Starts::some) return failed("a thread is started during an evaluation");
  if (started == Starts::unknown) return not_applicable("other programs start threads all the time");
  return {};
}

constexpr Factors kAllFactors{0.7, 1.3, 0.9};

Finding missing_inputs_are_zero(Bench& b) {
  Worst worst(1e-12);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & (NETLOFT_READS_VELOCITY | NETLOFT_READS_ACCELERATION | NETLOFT_READS_CURRENT |
                         NETLOFT_READS_WAVES)))
      continue;
    for (const auto& s : b.tiles) {
      States zero = b.blank(s.first, s.count);
      zero.x = s.x;
      zero.memory = s.memory;
      zero.bed = s.bed;
      States missing = {s.first, s.count, s.x, {}, {}, {}, {}, s.memory};
      missing.bed = s.bed;
      const Answer a = b.specimen->evaluate(term, zero, NETLOFT_WANT_FORCE);
      const Answer c = b.specimen->evaluate(term, missing, NETLOFT_WANT_FORCE);
      const Answer moving = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      for (std::size_t i = 0; i < a.force.size(); ++i)
        worst.note(ratio(c.force[i] - a.force[i], largest(moving.force, i % kLanes)),
                   [&] { return b.place(term, s, i % kLanes); });
      if (term.traits & NETLOFT_CONSTANT) continue;
      // Derivatives with respect to velocities and accelerations are also needed at rest, as masses and as
      // damping of small disturbances.
      const Answer there = b.specimen->evaluate(term, zero, NETLOFT_WANT_TANGENT, kAllFactors);
      const Answer none = b.specimen->evaluate(term, missing, NETLOFT_WANT_TANGENT, kAllFactors);
      for (std::size_t i = 0; i < there.matrix.size(); ++i)
        worst.note(ratio(none.matrix[i] - there.matrix[i], largest(there.matrix, i % kLanes)),
                   [&] { return b.place(term, s, i % kLanes) + ", tangent"; });
    }
  }
  return judged(worst, "no term reads velocities, accelerations, currents or waves");
}

}  // namespace netloft::conformance
