// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/conformance.hpp"
#include "framework/conformance/sampler.hpp"
#include "framework/conformance/specimen.hpp"

#include <cmath>
#include <limits>
#include <memory>

namespace netloft::conformance {

/// The numbers that the system gives the threads of this program, in ascending order; empty if the system
/// does not report them.
using Threads = std::vector<int>;
Threads threads_now();
int number_of_this_thread();
/// Waits until the system no longer shows a thread that was joined.
void wait_until_gone(int thread);

/// The fixture of the checks of an element type: sampled elements, each in a sampled state at which all of
/// its terms are defined.
struct Bench {
  Bench(const ElementType& type, const ConformanceOptions& options);

  std::size_t dofs() const { return static_cast<std::size_t>(type.dofs()); }
  /// Whether this degree of freedom belongs to the rotation of a body.
  bool is_turn(std::size_t dof) const { return type.is_on_body() && dof / 3 == 1; }
  /// An element in words: "term elastic, element 12".
  std::string place(const netloft_term& term, const States& states, std::size_t lane) const;
  /// Shortest distance between two nodes of element `lane` [m], at least 1e-6 of its size; 1 m if the element
  /// has a single node or belongs to a body.
  double spacing(const States& states, std::size_t lane) const;
  double size(const States& states, std::size_t lane) const {
    return sampler.size(sample, states.first + lane);
  }
  /// Largest force of each element, in this state and in three states nearby [N].
  std::vector<double> force_scale(const netloft_term& term, const States& states);
  /// States for `count` elements from `first` on, filled with zeros.
  States blank(std::uint32_t first, std::uint32_t count) const;
  /// A random field [dof][64], with a vector of length 1 at every node.
  std::vector<double> random_field();

  const ElementType& type;
  ConformanceOptions options;
  Sampler sampler;
  Threads threads_before;
  Sample sample;
  std::unique_ptr<Specimen> specimen;  // nullptr if refused or failed, see `refusal` and `escape`
  std::vector<States> tiles;
  std::string refusal;  // why the plugin refused all sampled elements
  std::string escape;   // the exception that the plugin threw
  std::string error;    // the evaluation that failed

 private:
  void make_elements();
  void make_states();
  void settle(States& states);
  void remember(States& states);
  bool is_settled(States& states, const netloft_term& term);
};

/// Returns states displaced by step × direction, with one step per element and `direction` [dof][64]. The
/// current is changed according to its derivative with respect to depth.
States moved(const States& states, const std::vector<double>& direction, const std::vector<double>& step);

bool same_bits(double a, double b);
/// Whether the numbers of element `i` in one array and of element `j` in another are bit-identical.
bool same_lane(const std::vector<double>& a, std::size_t i, const std::vector<double>& b, std::size_t j);

/// The largest (worst) figure of a check and its place. NaN counts as infinite.
class Worst {
 public:
  explicit Worst(double limit) : limit_(limit) {}
  template <class Where>
  void note(double figure, Where&& where) {
    ++count_;
    if (std::isnan(figure)) figure = std::numeric_limits<double>::infinity();
    if (figure <= figure_) return;
    figure_ = figure;
    where_ = where();
  }
  std::size_t count() const { return count_; }
  double figure() const { return figure_; }
  double limit() const { return limit_; }
  const std::string& where() const { return where_; }

 private:
  double limit_, figure_ = 0;
  std::size_t count_ = 0;
  std::string where_;
};

/// |a| / |b|; zero if a is zero.
double ratio(double a, double b);
std::string number_text(double value);

}  // namespace netloft::conformance
