// SPDX-License-Identifier: BSD-3-Clause
//
// bench_outputs [FOLDER]: measures the cost of writing the outputs of a motion and its result to the disk,
// and the number of system calls that read or write. For comparison, it measures the simplest other way to
// keep outputs after a kill: an HDF5 file that is flushed at every output.
#include "io/formats/hdf5/fold.hpp"
#include "io/formats/hdf5/result_file.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace {

using namespace netloft;
using Clock = std::chrono::steady_clock;

/// A gear of a given size: a rope has few nodes, netting has many.
struct Gear {
  const char* name;
  std::size_t nodes, cells, outputs;
};

struct Cost {
  double microseconds, processor, processor_at_the_end, calls, megabytes;
};

/// Number of system calls of this process that read or write.
double count_calls() {
  std::ifstream counts("/proc/self/io");
  double sum = 0;
  std::string name;
  for (double value; counts >> name >> value;)
    if (name == "syscr:" || name == "syscw:") sum += value;
  return sum;
}

std::vector<double> digits(std::size_t count, std::size_t seed) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(12.9898 * static_cast<double>(i + seed));
  return values;
}

formats::SeriesLayout make_layout(const Gear& gear) {
  formats::SeriesLayout layout;
  layout.mesh.n_points = gear.nodes;
  for (std::size_t c = 0; c < gear.cells; ++c) {
    const auto node = static_cast<std::int64_t>(c % (gear.nodes - 1));
    layout.mesh.connectivity.insert(layout.mesh.connectivity.end(), {node, node + 1});
    layout.mesh.offsets.push_back(static_cast<std::int64_t>(layout.mesh.connectivity.size()));
    layout.mesh.types.push_back(formats::kLine);
  }
  for (const char* name : {"displacement", "velocity", "reaction"})
    layout.changing.push_back({name, "m", "field", formats::Location::kPoint, 3, false});
  for (const char* name : {"tension", "strain", "drag", "mass", "angle"})
    layout.changing.push_back({name, "N", "field", formats::Location::kCell, 1, false});
  for (int k = 0; k < 12; ++k) layout.columns.push_back({"column" + std::to_string(k), "N", "column"});
  return layout;
}

std::vector<formats::SeriesState> make_states(const Gear& gear, const formats::SeriesLayout& layout) {
  std::vector<formats::SeriesState> states(4);
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].points = digits(3 * gear.nodes, i);
    for (const auto& field : layout.changing)
      states[i].fields.push_back(digits(
          (field.location == formats::Location::kPoint ? gear.nodes : gear.cells) * field.components, i));
    states[i].row = digits(layout.columns.size(), i);
  }
  return states;
}

/// Processor time [s], which other programs on the machine hardly change.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Measures `write(i)` for every output and then `finish`.
template <class Write, class Finish>
Cost measure(const Gear& gear, const std::filesystem::path& result, Write&& write, Finish&& finish) {
  const auto seconds = [begun = Clock::now()] {
    return std::chrono::duration<double>(Clock::now() - begun).count();
  };
  const double calls = count_calls(), each = 1e6 / static_cast<double>(gear.outputs);
  const double begun = processor_seconds();
  for (std::size_t i = 0; i < gear.outputs; ++i) write(i);
  const double written = processor_seconds();
  finish();
  const double ended = processor_seconds();
  return {each * seconds(), each * (ended - begun), each * (ended - written),
          (count_calls() - calls) / static_cast<double>(gear.outputs),
          static_cast<double>(std::filesystem::file_size(result)) / 1e6};
}

Cost measure_journal(const Gear& gear, const std::filesystem::path& result) {
  const formats::SeriesLayout layout = make_layout(gear);
  auto states = make_states(gear, layout);
  const auto unknowns = digits(9 * gear.nodes, 0);
  const std::string checkpoint(reinterpret_cast<const char*>(unknowns.data()), 8 * unknowns.size());
  auto journal = formats::SeriesJournal::create(result.string() + ".part", "bench", "", layout);
  return measure(
      gear, result,
      [&](std::size_t i) {
        states[i % 4].time = static_cast<double>(i);
        journal.write(states[i % 4], checkpoint);
      },
      [&] {
        formats::make_result(journal, result, [](formats::Tree&) {});
        journal.remove();
      });
}

Cost measure_flushes(const Gear& gear, const std::filesystem::path& result) {
  const formats::SeriesLayout layout = make_layout(gear);
  const auto states = make_states(gear, layout);
  const auto unknowns = digits(9 * gear.nodes, 0);
  formats::ResultFile file(result);
  file.begin(layout.mesh, layout.changing, layout.fixed, gear.outputs);
  return measure(
      gear, result,
      [&](std::size_t i) {
        const formats::SeriesState& state = states[i % 4];
        const std::vector<std::span<const double>> fields(state.fields.begin(), state.fields.end());
        file.write_state(static_cast<double>(i), state.points, fields);
        for (std::size_t k = 0; k < layout.columns.size(); ++k)
          file.tree().write_real("/netloft/row/" + layout.columns[k].name, state.row[k], "N");
        file.tree().write_reals("/netloft/checkpoint", unknowns, "m");
        file.flush();
      },
      [&] { file.finish(); });
}

void print(const Gear& gear, const char* way, const Cost& cost) {
  std::printf("| %s, %zu nodes | %s | %.0f | %.0f | %.0f | %.1f | %.1f |\n", gear.name, gear.nodes, way,
              cost.microseconds, cost.processor, cost.processor_at_the_end, cost.calls, cost.megabytes);
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path result = std::filesystem::path(argc > 1 ? argv[1] : ".") / "bench_outputs.hdf";
  std::puts(
      "| gear | way | µs an output | of the processor | of these at the end | reads and writes | MB |\n"
      "|---|---|---|---|---|---|---|");
  for (const Gear& gear : {Gear{"rope", 21, 20, 2501}, Gear{"panel", 1000, 2000, 501}}) {
    std::filesystem::remove(result);
    print(gear, "journal", measure_journal(gear, result));
    std::filesystem::remove(result);
    print(gear, "HDF5, flushed", measure_flushes(gear, result));
  }
  std::filesystem::remove(result);
}
