// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/shared_front.hpp"

#include <algorithm>

namespace netloft {
namespace {

// Least work [floating-point operations] for several threads. With less, which one thread does in 25
// microseconds, threads cost more than they save.
constexpr double kWorthwhile = 1e6;
constexpr std::ptrdiff_t kSlicesPerThread = 4;  // so that none waits long for a thread without a core

/// Divides the numbers from `begin` to `end` into slices, for which threads call body(from, to). Slices begin
/// at multiples of `grain` after `begin`.
template <class Body>
void divide(Workers& workers, std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t grain, double flops,
            const Body& body) {
  if (begin >= end) return;
  const auto threads = static_cast<std::ptrdiff_t>(workers.size());
  const std::ptrdiff_t grains = (end - begin + grain - 1) / grain;
  const std::ptrdiff_t slices = flops < kWorthwhile ? 1 : std::min(grains, kSlicesPerThread * threads);
  const std::ptrdiff_t length = (grains + slices - 1) / slices * grain;
  const auto count = static_cast<std::size_t>((end - begin + length - 1) / length);
  workers.run(count, 2, [&](std::size_t, std::size_t i) {
    const std::ptrdiff_t from = begin + static_cast<std::ptrdiff_t>(i) * length;
    body(from, std::min(from + length, end));
  });
}

double product(std::ptrdiff_t a, std::ptrdiff_t b, std::ptrdiff_t c) {
  return 2.0 * static_cast<double>(a) * static_cast<double>(b) * static_cast<double>(c);
}

/// Computes L₁₁, U₁₁ and L₂₁ of front_kernels.hpp (1).
Elimination eliminate_left(const FrontKernels& kernels, const FrontPanels& f, const PivotRule& rule,
                           std::int32_t* exchanged, Workers& workers) {
  const std::ptrdiff_t n = f.pivots, rows = n + f.others;
  for (std::ptrdiff_t done = 0; done < n;) {
    const std::ptrdiff_t end = std::min(done + kPivotBlock, n);
    if (const Elimination e = kernels.eliminate_block(f, done, end, rule, exchanged); e.stopped_at >= 0)
      return e;
    done = end;
    if (end == n) break;
    const std::ptrdiff_t width = eliminated_together(end), begin = end - width,
                         last = std::min(end + width, n);
    divide(workers, end, last, kTileRows, product(width, width, last - end) / 2,
           [&](std::ptrdiff_t from, std::ptrdiff_t to) { kernels.solve_rows(f, begin, end, from, to); });
    divide(workers, end, rows, kTileRows, product(rows - end, last - end, width),
           [&](std::ptrdiff_t from, std::ptrdiff_t to) {
             kernels.subtract_rows(f, begin, end, last, from, to);
           });
  }
  return {};
}

}  // namespace

Elimination eliminate_together(const FrontKernels& kernels, const FrontPanels& f, const PivotRule& rule,
                               std::int32_t* exchanged, Workers& workers) {
  const Elimination e = eliminate_left(kernels, f, rule, exchanged, workers);
  if (e.stopped_at >= 0) return e;
  divide(workers, 0, f.others, kTileRows, product(f.pivots, f.pivots, f.others) / 2,
         [&](std::ptrdiff_t from, std::ptrdiff_t to) { kernels.solve_upper(f, exchanged, from, to); });
  return e;
}

void update_together(const FrontKernels& kernels, const FrontPanels& f, double* C, Workers& workers) {
  divide(workers, 0, f.others, kTileRows, product(f.others, f.others, f.pivots),
         [&](std::ptrdiff_t from, std::ptrdiff_t to) { kernels.update_columns(f, C, from, to); });
}

}  // namespace netloft
