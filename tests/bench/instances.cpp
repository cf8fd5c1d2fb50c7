// SPDX-License-Identifier: BSD-3-Clause
// Processor time to change one number of a scene whose file has been read
// (io/scenes/reading/scene_source.hpp), divided by the time to read the file with the changed number. Each
// time is the least of several runs, and each run has a new value of the number.
//
//   bench_instances [SCENE [NODES…]]
#include "framework/balance/statistics.hpp"
#include "io/formats/units/units.hpp"
#include "io/scenes/reading/scene_source.hpp"
#include "tests/folders.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace netloft {
namespace {

using Changes = std::vector<formats::Change>;

/// A number of a scene: what it is, its path, its value and its unit.
struct Number {
  const char *kind, *path;
  double value;
  std::string unit;
  std::string part = "", key = "";  // "{ part = "16mm", " and "diameter = ", for a number of a named part

  /// Returns the change to the i-th value of the number; all values are within 1 %.
  formats::Change at(int i) const {
    const double other = value * (1 + 5e-5 * i);
    const std::string text = unit.empty() ? formats::format(other) : '"' + formats::format(other, unit) + '"';
    return formats::read_change(std::string(path) + "=" + part + key + text + (part.empty() ? "" : " }"));
  }
};

/// A gear of the library with `numbers` that do not change the mesh, and numbers `of_mesh` that do.
struct GearScene {
  const char* file;
  std::vector<Number> numbers, of_mesh;
};

constexpr const char* kWire = "{ part = \"6x19-fc-16mm\", ";

/// Returns a gear with the numbers `own` and the numbers that every gear has.
GearScene gear_scene(const char* file, std::vector<Number> own, const char* panel_mesh, double mesh,
                     double footrope) {
  own.insert(own.end(), {{"stiffness in [elements]", "elements.netting.twine.EA_compression", 10, "N"},
                         {"diameter of a rope", "ropes.footrope.rope", 16, "mm", kWire, "diameter = "},
                         {"EA of a rope", "ropes.footrope.rope", 9, "MN", kWire, "EA = "},
                         {"tolerance", "analysis.tolerance", 1e-6, ""}});
  return {file,
          std::move(own),
          {{"mesh size of a panel", panel_mesh, mesh, "mm"},
           {"length of a rope", "ropes.footrope.length", footrope, "m"}}};
}

std::vector<GearScene> gear_scenes() {
  return {gear_scene("83-112-flume-3.0kn",
                     {{"speed of the tow", "tow.speed", 3, "kn"},
                      {"position of a hold", "points.towing-point.at[2]", -19.6, "m"},
                      {"depth of the bed", "parts.bed.seabed.depth", 20, "m"}},
                     "panels.top-body.mesh", 101.6, 34.1),
          gear_scene("83-112-at-sea-66m",
                     {{"speed of the ship", "ship.speed", 3, "kn"},
                      {"position of a hold", "ship.block.height", 4, "m"},
                      {"depth of the bed", "bed.depth", 66, "m"}},
                     "panels.top-body.mesh", 101.6, 34.1),
          gear_scene("two-panel",
                     {{"speed of the current", "water.current[0]", 1.2, "m/s"},
                      {"position of a hold", "points.door.at[2]", -30, "m"}},
                     "panels.upper.mesh", 60, 4.2),
          gear_scene("pelagic-with-doors",
                     {{"speed of the ship", "ship.speed", 3, "kn"},
                      {"position of a hold", "ship.block.height", 4, "m"}},
                     "panels.top.mesh", 120, 6),
          gear_scene("four-panel",
                     {{"speed of the current", "water.current[0]", 1.5, "m/s"},
                      {"position of a hold", "points.door.at[2]", -30, "m"}},
                     "panels.top.mesh", 120, 6)};
}

Registry& plugins() {
  static Registry registry = [] {
    Registry shipped;
    shipped.add_folder(netloft::test::plugin_folder());
    return shipped;
  }();
  return registry;
}

std::size_t read(const scenes::SceneSource& source, const Changes& changes) {
  formats::Diagnostics diagnostics;
  bool refused = false;
  const auto loaded = source.instance(changes, plugins(), diagnostics, refused);
  if (diagnostics.errors() == 0) return loaded.scene.node_count();
  std::fprintf(stderr, "%s", diagnostics.render(false).c_str());
  std::exit(2);
}

/// The least processor time of several runs [s]. `run` receives another index each time.
double least(int times, const std::function<void(int)>& run) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= times; ++i) {
    const double begun = cpu_seconds();
    run(i);
    best = std::min(best, cpu_seconds() - begun);
  }
  return best;
}

void print_rows(const GearScene& gear, int nodes) {
  constexpr int kReadings = 5, kInstances = 15;
  const std::string file = netloft::test::source_folder() + "/gear-library/scenes/" + gear.file + ".toml";
  const formats::Change mesh = formats::make_change({"gear", "nodes"}, {{}, std::int64_t{nodes}});
  const scenes::SceneSource source(file);
  std::printf("\n%s, %zu nodes\n", gear.file, read(source, {mesh}));
  const auto print_row = [&](const Number& number) {
    const double reading = least(kReadings, [&](int i) {
      read(scenes::SceneSource(file), {mesh, number.at(100 + i)});
    });
    const double instance = least(kInstances, [&](int i) { read(source, {mesh, number.at(i)}); });
    std::printf("  %-26s reading %7.2f ms, instance %6.2f ms, ratio %5.1f %%\n", number.kind, 1e3 * reading,
                1e3 * instance, 100 * instance / reading);
  };
  for (const Number& number : gear.numbers) print_row(number);
  std::printf("  -- change the mesh --\n");
  for (const Number& number : gear.of_mesh) print_row(number);
}

}  // namespace
}  // namespace netloft

int main(int count, char** arguments) {
  if (!std::getenv("NETLOFT_CATALOGUE"))
    setenv("NETLOFT_CATALOGUE", (netloft::test::source_folder() + "/gear-library/catalogue").c_str(), 1);
  std::vector<int> nodes;
  for (int i = 2; i < count; ++i) nodes.push_back(std::atoi(arguments[i]));
  if (nodes.empty()) nodes = {1000, 4000};
  for (const auto& gear : netloft::gear_scenes())
    for (const int n : nodes)
      if (count < 2 || std::string_view(gear.file).find(arguments[1]) != std::string_view::npos)
        netloft::print_rows(gear, n);
  return 0;
}
