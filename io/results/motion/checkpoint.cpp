// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/checkpoint.hpp"

#include "io/formats/hdf5/bytes.hpp"
#include "io/formats/hdf5/handle.hpp"

#include <array>

namespace netloft::results {

namespace {

// Two lists of members in the order in which they are packed; `S` is Statistics, constant or not.
template <class S>
auto counts_of(S& s) {
  return std::array{&s.iterations, &s.energies,       &s.residuals,
                    &s.matrices,   &s.factorisations, &s.refused_factorisations,
                    &s.solves};
}
template <class S>
auto times_of(S& s) {
  return std::array{&s.assembly_seconds, &s.analysis_seconds,  &s.factorisation_seconds, &s.solve_seconds,
                    &s.total_seconds,    &s.total_cpu_seconds, &s.solver_cpu_seconds};
}

void put(const Statistics& s, formats::ByteWriter& to) {
  for (const int* count : counts_of(s)) to.put(static_cast<std::uint64_t>(*count));
  for (const double* time : times_of(s)) to.put(*time);
}

void take(formats::ByteReader& from, Statistics& s) {
  for (int* count : counts_of(s)) *count = static_cast<int>(from.integer());
  for (double* time : times_of(s)) *time = from.real();
}

void put(const MarchState& s, formats::ByteWriter& to) {
  to.put(s.t);
  to.put(s.h);
  for (const auto* values : {&s.u, &s.v, &s.a, &s.memory, &s.budget, &s.judged, &s.winches})
    to.put_array(*values);
  for (const double value : {s.least_load, s.stable_step, s.error_sum, s.largest_error, s.largest_at})
    to.put(value);
  to.put(s.largest_of);
  to.put(std::uint64_t{s.outputs});
  to.put(static_cast<std::uint64_t>(s.steps));
  to.put(static_cast<std::uint64_t>(s.rejected));
  for (const double value : {s.shortest, s.longest, s.start.residual, s.start.load}) to.put(value);
  to.put(std::string_view(s.start.node));
  to.put(std::string_view(s.remark));
  put(s.statistics, to);
  to.put(s.t_before);
  to.put_array(s.u_before);
  to.put_array(s.v_before);
  for (const double value : {s.path_error, s.path_at, s.parted_at}) to.put(value);
  to.put(s.path_of);
  to.put(std::string_view(s.why_lost));
  to.put(std::uint64_t{s.other.size()});
  for (const MarchState& other : s.other) put(other, to);
}

void take(formats::ByteReader& from, MarchState& s) {
  s.t = from.real();
  s.h = from.real();
  for (auto* values : {&s.u, &s.v, &s.a, &s.memory, &s.budget, &s.judged, &s.winches}) *values = from.reals();
  for (double* value : {&s.least_load, &s.stable_step, &s.error_sum, &s.largest_error, &s.largest_at})
    *value = from.real();
  s.largest_of = from.integer();
  s.outputs = from.integer();
  s.steps = static_cast<std::int64_t>(from.integer());
  s.rejected = static_cast<std::int64_t>(from.integer());
  for (double* value : {&s.shortest, &s.longest, &s.start.residual, &s.start.load}) *value = from.real();
  s.start.node = from.text();
  s.remark = from.text();
  take(from, s.statistics);
  s.t_before = from.real();
  s.u_before = from.reals();
  s.v_before = from.reals();
  for (double* value : {&s.path_error, &s.path_at, &s.parted_at}) *value = from.real();
  s.path_of = from.integer();
  s.why_lost = from.text();
  for (std::uint64_t k = from.integer(); k > 0; --k) take(from, s.other.emplace_back());
}

void put(const MotionFindings& f, formats::ByteWriter& to) {
  to.put(f.t);
  to.put(f.numerical);
  to.put_array(f.v);
  to.put(std::uint64_t{f.loss.has_value()});
  if (f.loss) {
    for (const double value :
         {f.loss->lost, f.loss->given, f.loss->negligible, f.loss->worst, f.loss->from, f.loss->until})
      to.put(value);
    to.put(std::string_view(f.loss->node));
  }
  to.put(std::uint64_t{f.fallen.size()});
  for (const auto& [board, sentence] : f.fallen) {
    to.put(std::string_view(board));
    to.put(std::string_view(sentence));
  }
}

void take(formats::ByteReader& from, MotionFindings& f) {
  f.t = from.real();
  f.numerical = from.real();
  f.v = from.reals();
  if (from.integer() != 0) {
    NumericalLoss& loss = f.loss.emplace();
    for (double* value : {&loss.lost, &loss.given, &loss.negligible, &loss.worst, &loss.from, &loss.until})
      *value = from.real();
    loss.node = from.text();
  }
  for (std::uint64_t k = from.integer(); k > 0; --k) {
    FallenBoard& fallen = f.fallen.emplace_back();
    fallen.board = from.text();
    fallen.sentence = from.text();
  }
}

}  // namespace

std::string pack_checkpoint(const MarchState& state, const MotionFindings& findings) {
  formats::ByteWriter to;
  put(state, to);
  put(findings, to);
  return to.bytes();
}

Checkpoint unpack_checkpoint(const std::string& bytes) {
  formats::ByteReader from(bytes);
  Checkpoint checkpoint;
  take(from, checkpoint.state);
  take(from, checkpoint.findings);
  if (!from.is_at_end())
    throw formats::FileError("it is damaged: there is more data after the end of the checkpoint");
  return checkpoint;
}

}  // namespace netloft::results
