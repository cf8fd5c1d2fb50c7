// SPDX-License-Identifier: BSD-3-Clause
//
// The header for authors of strategies. A strategy is a struct with `Parameters` and one function,
//
//   static void run(const Parameters&, Search&);
//
// that brings a scene to equilibrium with solvers: directly, through easier variants or coarser meshes, or
// from other initial guesses. It passes every equilibrium of the given scene to `search.answer`. The host
// counts the work, assesses every stage and chooses among the answers; a strategy does not decide on
// convergence. With
//
//   static std::string explain(const Parameters&, Search&);
//
// it also describes its plan before anything is solved, one line for each stage with the reason.
#pragma once
#include <netloft/ext/strategy.h>
#include <netloft/imbalance.hpp>
#include <netloft/parameters.hpp>
#include <netloft/scatter.hpp>
#include <netloft/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace netloft {

using Displacements = std::vector<double>;  // displacements of the unknowns of a level of mesh [m]

/// Moves every unknown by up to `amplitude` [m], which breaks every symmetry. The result is the same on every
/// machine, and different for every value of `turn`.
inline Displacements perturbed(Displacements u, double amplitude, int turn = 0) {
  constexpr double kSilver = 0.41421356237309505;  // shift between turns, from the silver ratio
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += amplitude * scattered(i, kSilver * turn);
  return u;
}

/// An easier variant of a scene. The defaults are the scene itself.
struct Variant {
  unsigned level = 0;        // mesh: 0 is the scene's own; 1, 2, … are coarser
  double stiffness_cap = 0;  // upper limit of stiffnesses [N]; 0: unchanged
  double compression = 1;    // factor on the stiffness of slack members
  double current = 1;        // factor on the current

  netloft_variant c() const { return {sizeof(netloft_variant), level, stiffness_cap, compression, current}; }
};

/// Tolerance of a stage whose result is only an initial guess for the next stage. A smaller imbalance would
/// be useless, because the easier problem differs from the scene by more than that.
inline constexpr double kOnlyAStart = kMatters;

/// The task of one stage (one solve): a variant, its solver, the tolerance and the budget.
struct Ask {
  const char* name = "";  // purpose of the stage in a few words, for the report
  Variant variant{};
  const char* solver = nullptr;      // nullptr: the solver of the analysis, with its parameters
  const char* parameters = nullptr;  // such as "method=classic,damping=1"
  double tolerance = 0;              // 0: the tolerance of the analysis
  double work = 0;                   // budget; 0: all that is left
  double path = 0;  // limit of the path: sum of the largest nodal displacements of all steps, divided by the
                    // gear size; 0: none
  unsigned iterations = 0;   // limit of iterations; 0: the limit of the analysis
  bool compensated = false;  // whether positions keep the digits that double precision rounds off
};

enum class Ending {
  converged = NETLOFT_ENDED_CONVERGED,
  unstable = NETLOFT_ENDED_UNSTABLE,
  not_converged = NETLOFT_ENDED_NOT_CONVERGED,
  out_of_work = NETLOFT_ENDED_OUT_OF_WORK,
  unsettled = NETLOFT_ENDED_UNSETTLED,
  interrupted = NETLOFT_ENDED_INTERRUPTED
};

/// A solver or a strategy and its parameters in one text, as users write it: "auto:restarts=0;slice=100".
struct Specification {
  std::string name, parameters;  // parameters, as in Ask::parameters and Search::call
};

inline Specification specification_of(const std::string& word) {
  const auto colon = word.find(':');
  if (colon == std::string::npos) return {word, ""};
  Specification s{word.substr(0, colon), word.substr(colon + 1)};
  std::replace(s.parameters.begin(), s.parameters.end(), ';', ',');
  return s;
}

/// The end of a stage (one solve of one variant), and the host's judgement of it.
struct Stage {
  Displacements u;
  Ending ending = Ending::not_converged;
  int stability = NETLOFT_STABILITY_UNKNOWN;
  // Largest residual and load on a node [N], [N]; energy [J]; all zero if has_forces() is false.
  double residual = 0, load = 0, energy = 0;
  double rounding = 0;  // residual that rounding of the positions can cause [N]
  double spent = 0;     // work of the stage
  unsigned iterations = 0, factorisations = 0;
  Displacements growing = {};                    // a disturbance that grows; empty if not known
  double growth_rate = 0, growth_frequency = 0;  // [1/s], [rad/s]; frequency 0: it does not oscillate

  /// Whether the forces of the requested variant were evaluated at `u`. False if the forces of an element are
  /// not defined at `u`, or if another strategy was called and solved no stage of the variant, so that `u` is
  /// the initial guess.
  bool has_forces() const { return load > 0; }
  /// Whether the end of the stage is an equilibrium, stable or unstable.
  bool is_stationary() const { return ending == Ending::converged || ending == Ending::unstable; }
  bool has_converged() const { return ending == Ending::converged; }
  /// Whether the stage did some work and then ended because its budget was used up.
  bool was_cut_off() const { return ending == Ending::out_of_work && spent > 0; }
  /// Whether the equilibrium has a flutter instability (an oscillation that grows): a motion that starts at
  /// the equilibrium does not come to rest nearby.
  bool flutters() const { return ending == Ending::unstable && growth_frequency > 0; }
  double imbalance() const { return has_forces() ? residual / load : residual > 0 ? 1 : 0; }
};

/// A scene and its easier variants as a strategy sees them.
class Search {
 public:
  explicit Search(netloft_search& s) : s_(s) {}

  std::size_t size(unsigned level = 0) const { return s_.size_of(s_.host, level); }
  unsigned levels() const { return s_.levels; }
  bool conservative() const { return s_.traits & NETLOFT_CONSERVATIVE; }
  bool symmetric() const { return s_.traits & NETLOFT_SYMMETRIC; }
  bool remembers() const { return s_.traits & NETLOFT_SEARCH_REMEMBERS; }
  bool flows() const { return s_.traits & NETLOFT_SEARCH_FLOWS; }
  bool resists_compression() const { return s_.traits & NETLOFT_SEARCH_COMPRESSION; }
  bool resists_bending() const { return s_.traits & NETLOFT_SEARCH_BENDING; }
  bool has_members() const { return s_.traits & NETLOFT_SEARCH_MEMBERS; }
  std::size_t members() const { return s_.member_count; }
  double gear_size() const { return s_.gear_size; }        // [m]
  double element_size() const { return s_.element_size; }  // [m]
  double load() const { return s_.load; }  // sum of the forces that drive the gear at the start [N]
  double largest_load() const { return s_.largest_load; }  // largest driving force on a node [N]
  double stiffness() const { return s_.stiffness; }        // largest axial stiffness [N]

  /// The initial displacements of the unknowns of the scene itself.
  Displacements start() const {
    Displacements u(s_.unknowns, 0.0);
    if (s_.start) std::copy_n(s_.start, u.size(), u.begin());
    return u;
  }
  bool starts_from_sketch() const { return s_.start == nullptr; }

  Stage solve(const Ask& ask, Displacements u) {
    return ended(ask, std::move(u), [&](netloft_stage& stage) { return s_.solve(s_.host, &stage); });
  }
  /// Lets another strategy bring a variant to equilibrium from `u`, with a budget of its own (Ask::work).
  /// Returns the answer of that strategy; the host chooses if there are several. If there is no answer, the
  /// result is the point of the variant closest to balance, or the initial guess, with the ending of the last
  /// stage of the variant (out_of_work if that stage was cut off or no work is left).
  Stage call(const char* strategy, const char* parameters, const Ask& ask, Displacements u) {
    return ended(ask, std::move(u),
                 [&](netloft_stage& stage) { return s_.call(s_.host, strategy, parameters, &stage); });
  }
  /// Assesses `u` without solving anything.
  Stage assess(const Ask& ask, Displacements u) {
    return ended(ask, std::move(u), [&](netloft_stage& stage) { return s_.assess(s_.host, &stage); });
  }
  /// Interpolates displacements from one level of mesh to another.
  Displacements transfer(unsigned from, const Displacements& u, unsigned to) {
    Displacements out(size(to));
    check(s_.transfer(s_.host, from, u.data(), to, out.data()));
    return out;
  }
  /// Calls method(Problem&) on the problem r(u) = 0 of a variant and returns its final u. Call `assess` for
  /// the residual and stability at this u.
  template <class Method>
  Displacements with_problem(const Ask& ask, Displacements u, Method&& method) {
    u.resize(size(ask.variant.level));
    netloft_stage stage = stage_of(ask, u);
    netloft_problem problem{};
    problem.size = sizeof problem;
    check(s_.problem(s_.host, &stage, &problem));
    Problem p(problem);
    method(p);
    return u;
  }
  /// Calls method(netloft_members&, u) on the members of a variant (lines that bear tension, ext/members.h).
  /// The method changes u. Returns the changed u.
  template <class Method>
  Displacements with_members(const Ask& ask, Displacements u, Method&& method) {
    u.resize(size(ask.variant.level));
    netloft_stage stage = stage_of(ask, u);
    netloft_members members{};
    members.size = sizeof members;
    check(s_.members(s_.host, &stage, &members));
    method(members, std::span<double>(u));
    return u;
  }

  /// States why the strategy does not solve the scene or does not continue ("there is no current"). The
  /// strategy must return after this call. The reason is reported to the user if there is nothing else to
  /// report.
  void decline(const char* why) { std::snprintf(s_.message, s_.message ? s_.message_size : 0, "%s", why); }

  /// Largest bending force on a node along one axis [N]. Bending forces are the elastic forces of meshes held
  /// open and of bent ropes and netting, but not of members. `u` must be an equilibrium of the scene itself,
  /// and all forces must be conservative. If the tangent of all other forces is positive definite, the result
  /// is zero, because the gear then keeps its shape without bending forces.
  double bending(const Displacements& u) { return s_.bending(s_.host, u.data()); }
  double work_left() { return s_.work_left(s_.host); }
  /// Reports an equilibrium of the scene itself. May be called again for another equilibrium.
  void answer(const Displacements& u) {
    if (u.size() != s_.unknowns)
      throw std::invalid_argument("an answer has one number for each unknown of the scene");
    check(s_.answer(s_.host, u.data()));
  }

 private:
  netloft_stage stage_of(const Ask& ask, Displacements& u) const {
    netloft_stage stage{};
    stage.size = sizeof stage, stage.flags = ask.compensated ? std::uint32_t{NETLOFT_COMPENSATED} : 0u;
    stage.variant = ask.variant.c();
    stage.name = ask.name;
    stage.solver = ask.solver;
    stage.parameters = ask.parameters;
    stage.tolerance = ask.tolerance;
    stage.work = ask.work;
    stage.path = ask.path;
    stage.iterations = ask.iterations;
    stage.u = u.data();
    return stage;
  }

  template <class Call>
  Stage ended(const Ask& ask, Displacements u, const Call& call) {
    u.resize(size(ask.variant.level));
    netloft_stage s = stage_of(ask, u);
    check(call(s));
    Stage stage;
    stage.u = std::move(u);
    stage.ending = static_cast<Ending>(s.ending);
    stage.stability = static_cast<int>(s.stability);
    stage.residual = s.residual;
    stage.load = s.load;
    stage.energy = s.energy;
    stage.rounding = s.rounding;
    stage.spent = s.spent;
    stage.iterations = s.iterations_done;
    stage.factorisations = s.factorisations;
    stage.growth_rate = s.growth_rate;
    stage.growth_frequency = s.growth_frequency;
    if (s.growing) stage.growing.assign(s.growing, s.growing + stage.u.size());
    return stage;
  }

  void check(int status) const {
    if (status != NETLOFT_OK) throw std::runtime_error("");  // the host reports the cause itself
  }

  netloft_search& s_;
};

namespace detail {
template <class S>
int run_strategy(const void* parameters, netloft_search* search) noexcept {
  try {
    Search s(*search);
    S::run(OwnParameters<S>::from(parameters), s);
    return NETLOFT_OK;
  } catch (const std::exception& e) {
    if (search->message && e.what()[0]) std::snprintf(search->message, search->message_size, "%s", e.what());
  } catch (...) {
  }
  return NETLOFT_ERROR;
}

template <class S>
int explain_strategy(const void* parameters, netloft_search* search, char* text,
                     std::uint32_t size) noexcept {
  try {
    Search s(*search);
    const std::string words = S::explain(OwnParameters<S>::from(parameters), s);
    std::snprintf(text, size, "%s", words.c_str());
    return NETLOFT_OK;
  } catch (const std::exception& e) {
    if (search->message && e.what()[0]) std::snprintf(search->message, search->message_size, "%s", e.what());
  } catch (...) {
  }
  return NETLOFT_ERROR;
}
}  // namespace detail

/// Describes one strategy to the host. `needs` are traits that the search must have.
///
/// The value of a parameter declared by `strategy` or `solver` is a Specification. Before anything is solved,
/// the host refuses a value if its strategy or solver does not exist or its parameters are wrong. In C, such
/// a parameter is a text whose `unit` is "strategy" or "solver". A parameter declared by `several` is a text
/// with `choices` in C.
template <class S>
class StrategyTable : public ParameterTable<typename S::Parameters> {
  using P = typename S::Parameters;
  using Word = const char* P::*;

 public:
  using Offer = netloft_strategies;  // the list in which a plugin offers its strategies
  static constexpr const char* extension = NETLOFT_EXT_STRATEGY;

  StrategyTable(const char* name, const char* doc) : name_(name), doc_(doc) {}
  void needs(std::uint32_t traits) { needs_ = traits; }

  /// Declares a parameter that names a strategy. The text may be empty only if the default is empty.
  void strategy(const char* name, Word member, const char* doc, const char* fallback) {
    this->text(name, member, doc, fallback);
    last_row().unit = "strategy";
  }
  void solver(const char* name, Word member, const char* doc, const char* fallback) {
    this->text(name, member, doc, fallback);
    last_row().unit = "solver";
  }
  /// Declares a parameter whose value is any number of `words`, joined by plus signs; none by default.
  void several(const char* name, Word member, const char* doc, std::vector<const char*> words) {
    this->text(name, member, doc, "");
    words.push_back(nullptr);
    last_row().choices = words_.emplace_back(std::move(words)).data();
  }

  netloft_strategy descriptor() const {
    detail::OwnParameters<S>::declare(this->rows());
    netloft_strategy s{};
    s.size = sizeof s;
    s.needs = needs_;
    s.name = name_;
    s.doc = doc_;
    s.parameter_bytes = sizeof(typename S::Parameters);
    rows_ = this->rows();
    for (const auto& [at, row] : described_) rows_[at] = row;
    s.parameter_count = static_cast<std::uint32_t>(rows_.size());
    s.parameters = rows_.data();
    s.run = &detail::run_strategy<S>;
    if constexpr (requires(const typename S::Parameters& p, Search& search) { S::explain(p, search); })
      s.explain = &detail::explain_strategy<S>;
    return s;
  }

 private:
  /// Returns a copy of the last row of the table, which replaces that row in the descriptor.
  netloft_parameter& last_row() {
    return described_.emplace_back(this->rows().size() - 1, this->rows().back()).second;
  }

  const char *name_, *doc_;
  std::uint32_t needs_ = 0;
  std::vector<std::pair<std::size_t, netloft_parameter>> described_;
  std::deque<std::vector<const char*>> words_;
  mutable std::vector<netloft_parameter> rows_;
};

}  // namespace netloft

#include <netloft/register.hpp>
