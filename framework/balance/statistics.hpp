// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <ctime>

namespace netloft {

inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Processor time of the whole process, summed over its threads [s].
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Cost of a solve, counted and timed by the host in the same way for every solver.
struct Statistics {
  int iterations = 0;
  int energies = 0, residuals = 0, matrices = 0;  // numbers of evaluations
  int factorisations = 0, refused_factorisations = 0, solves = 0;
  double assembly_seconds = 0, analysis_seconds = 0, factorisation_seconds = 0, solve_seconds = 0;
  double total_seconds = 0, total_cpu_seconds = 0;  // times including the host's final checks
  double solver_cpu_seconds = 0;                    // processor time without the host's final checks

  void add(const Statistics& other) {
    iterations += other.iterations;
    energies += other.energies;
    residuals += other.residuals;
    matrices += other.matrices;
    factorisations += other.factorisations;
    refused_factorisations += other.refused_factorisations;
    solves += other.solves;
    assembly_seconds += other.assembly_seconds;
    analysis_seconds += other.analysis_seconds;
    factorisation_seconds += other.factorisation_seconds;
    solve_seconds += other.solve_seconds;
    total_seconds += other.total_seconds;
    total_cpu_seconds += other.total_cpu_seconds;
    solver_cpu_seconds += other.solver_cpu_seconds;
  }
};

/// Adds the wall time between its construction and its destruction to `account`.
class Timed {
 public:
  explicit Timed(double& account) : account_(account), start_(wall_seconds()) {}
  ~Timed() { account_ += wall_seconds() - start_; }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& account_;
  double start_;
};

/// Report of one accepted point.
struct IterationRecord {
  int iteration = 0;
  double residual = 0;  // largest nodal residual [N]
  double scale = 0;     // largest nodal load [N]
  double energy = 0;    // [J]
  int factorisations = 0;
  double seconds = 0;  // wall time since the start of the solve
  char note[32] = "";
};

}  // namespace netloft
