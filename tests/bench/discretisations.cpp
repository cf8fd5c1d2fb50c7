// SPDX-License-Identifier: BSD-3-Clause
//
// Error against CPU time of netting by triangles and by lumped masses, in three cases: the hanging panel of
// fig. 6a of the trawl-gear paper, 40 x 40 meshes, compared with an independent program that models every
// twine; the same panel in a current across it, compared with lumped/net with one mesh per cell (the row
// without an error); a cod-end with a catch, compared with an axisymmetric membrane. Times are the best of
// three on one thread; run with OMP_THREAD_LIMIT=1, and compare rows of one run only.
#include "tests/verification/scene_file.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace {

using namespace netloft;
using test::SolvedFile;

/// The results that rows compare.
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
              r.result.solved.plan.unknowns, solution.cost.statistics.iterations, r.seconds,
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

/// Stiffness of a twine of the cod-end, and length, largest radius and drag of the axisymmetric membrane of
/// the same netting.
struct Codend {
  double EA, length, radius, drag;  // [N], [m], [m], [N]
};

void print_codend(const std::string& type, const std::string& cells, const Codend& want) {
  double seconds = 1e300;
  SolvedFile s;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const std::clock_t begin = std::clock();
    s = test::solve_file("verification/codend-with-catch.toml",
                         {"parts.codend.type=" + type, "parts.codend.cells=" + cells,
                          "parts.codend.twine.EA=" + std::to_string(want.EA)});
    seconds = std::min(seconds, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  double radius = 0;
  for (const auto node : s.part("codend").nodes) {
    const auto x = s.solved.position(node);
    radius = std::max(radius, std::hypot(x[1], x[2]));
  }
  const auto error = [](double found, double exact) { return 100 * (found / exact - 1); };
  std::printf("%-16s %9s %9zu %11d %9.3f %10.3f %10.3f %10.3f  %s\n", type.c_str(), cells.c_str(),
              s.solved.plan.unknowns, s.solved.solution.cost.statistics.iterations, seconds,
              error(s.solved.position(s.node("codend", "aft"))[0], want.length), error(radius, want.radius),
              error(-s.solved.total_reaction()[0], want.drag), name_of(s.solved.solution.status));
}

void compare_codends(const Codend& want) {
  std::printf(
      "\ncod-end with a catch, EA %g N, against the axisymmetric membrane\ntype                 cells  "
      "unknowns"
      "  iterations     CPU s  length [%%] radius [%%]   drag [%%]\n",
      want.EA);
  for (const char* cells : {"[24,24]", "[24,48]", "[48,48]", "[100,100]"})
    print_codend("priour/triangle", cells, want);
  for (const char* cells : {"[20,20]", "[25,25]", "[50,50]", "[100,100]"})
    print_codend("lumped/net", cells, want);
}

}  // namespace

int main() {
  compare("hanging in still water, against the net twine by twine", {-42.67468699107, 15.0040926972}, {});
  const std::vector<std::string> current{"water.current=[0,0.5,0]"};
  compare("the same in a current of 0.5 m/s across it", shape_of(run("lumped/net", 40, current).result),
          current);
  compare_codends({1e4, 8.897802, 1.536439, 7275.728});
  compare_codends({1e3, 9.366688, 1.687495, 8415.734});
}
