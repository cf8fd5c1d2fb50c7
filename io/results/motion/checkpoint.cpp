// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/checkpoint.hpp"

#include "io/formats/hdf5/bytes.hpp"
#include "io/formats/hdf5/handle.hpp"

namespace netloft::results {

std::string pack_checkpoint(const MarchState& s) {
  formats::ByteWriter to;
  to.put(s.t);
  to.put(s.h);
  for (const auto* values : {&s.u, &s.v, &s.a, &s.memory, &s.budget, &s.judged, &s.winches})
    to.put_array(*values);
  to.put(s.least_load);
  to.put(s.stable_step);
  to.put(s.error_sum);
  to.put(s.largest_error);
  to.put(s.largest_at);
  to.put(s.largest_of);
  to.put(std::uint64_t{s.outputs});
  to.put(static_cast<std::uint64_t>(s.steps));
  to.put(static_cast<std::uint64_t>(s.rejected));
  to.put(s.t_before);
  to.put_array(s.u_before);
  to.put_array(s.v_before);
  to.put(s.path_error);
  to.put(s.path_at);
  to.put(s.path_of);
  to.put(s.parted_at);
  to.put(std::uint64_t{s.other.size()});
  for (const MarchState& other : s.other) to.put(std::string_view(pack_checkpoint(other)));
  return to.bytes();
}

MarchState unpack_checkpoint(const std::string& bytes) {
  formats::ByteReader from(bytes);
  MarchState s;
  s.t = from.real();
  s.h = from.real();
  for (auto* values : {&s.u, &s.v, &s.a, &s.memory, &s.budget, &s.judged, &s.winches}) *values = from.reals();
  s.least_load = from.real();
  s.stable_step = from.real();
  s.error_sum = from.real();
  s.largest_error = from.real();
  s.largest_at = from.real();
  s.largest_of = from.integer();
  s.outputs = from.integer();
  s.steps = static_cast<std::int64_t>(from.integer());
  s.rejected = static_cast<std::int64_t>(from.integer());
  s.t_before = from.real();
  s.u_before = from.reals();
  s.v_before = from.reals();
  s.path_error = from.real();
  s.path_at = from.real();
  s.path_of = from.integer();
  s.parted_at = from.real();
  for (std::uint64_t k = from.integer(); k > 0; --k)
    s.other.push_back(unpack_checkpoint(std::string(from.text())));
  if (!from.is_at_end()) throw formats::FileError("it is damaged: there is more than a checkpoint");
  return s;
}

}  // namespace netloft::results
