// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles and lumped-mass net on one panel: error against CPU time. The hanging panel of the paper's fig.
// 6a, 40 x 40 meshes, against the same net twine by twine (independent program); and the same panel in a
// current across it, against itself twine by twine (lumped/net with one mesh a cell, the row that has no
// error). Best of three, one thread; run with OMP_THREAD_LIMIT=1, and compare rows of one run only.
#include "tests/verification/scene_file.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace {

using namespace netloft;
using test::SolvedFile;

/// What rows are judged by.
struct Shape {
  double lowest_z = 0, mid_width = 0;  // [m]
};

struct Run {
  SolvedFile result;
  double seconds = 1e300;  // of the CPU, reading included
};

Shape shape_of(const SolvedFile& s) {
  const auto& net = s.part("net");
  const auto middle = [&](const char* edge) {
    const auto& nodes = net.sets.at(edge);
    return s.solved.position(net.nodes.at(nodes.at(nodes.size() / 2)));
  };
  return {s.solved.lowest_z(), middle("right")[0] - middle("left")[0]};
}

Run run(const std::string& type, int cells, const std::vector<std::string>& more) {
  const std::string n = std::to_string(cells);
  std::vector<std::string> settings{"parts.net.type=" + type, "parts.net.cells=[" + n + "," + n + "]"};
  settings.insert(settings.end(), more.begin(), more.end());
  Run best;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const std::clock_t begin = std::clock();
    best.result = test::solve_file("dead-weight-panel.toml", settings);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    best.seconds = std::min(best.seconds, seconds);
  }
  return best;
}

void print_row(const std::string& type, int cells, const Run& r, const Shape& want) {
  const Shape found = shape_of(r.result);
  const auto& solution = r.result.solved.solution;
  std::printf("%-16s %5d %9zu %11d %9.3f %13.4f %13.4f  %s\n", type.c_str(), cells,
              r.result.solved.plan.unknowns, solution.books.iterations, r.seconds,
              std::abs(found.lowest_z - want.lowest_z), std::abs(found.mid_width - want.mid_width),
              name_of(solution.status));
}

void compare(const char* what, const Shape& want, const std::vector<std::string>& more) {
  std::printf("\n%s\ntype             cells  unknowns  iterations     CPU s  lowest z [m]  mid width [m]\n",
              what);
  for (const std::string type : {"priour/triangle", "lumped/net"})
    for (const int cells : {4, 8, 10, 16, 20, 32, 40, 64})
      print_row(type, cells, run(type, cells, more), want);
}

}  // namespace

int main() {
  compare("hanging in still water, against the net twine by twine", {-42.67468699107, 15.0040926972}, {});
  const std::vector<std::string> current{"water.current=[0,0.5,0]"};
  compare("the same in a current of 0.5 m/s across it", shape_of(run("lumped/net", 40, current).result),
          current);
}
