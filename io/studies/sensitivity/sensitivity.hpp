// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/bar_chart.hpp"
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/studies/sensitivity/scene_numbers.hpp"
#include "io/studies/sensitivity/switches.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace netloft::studies {

/// The derivatives of all figures with respect to one number p of a scene, at an equilibrium.
struct NumberEffect {
  SceneNumber number;
  std::string why_not;               // why there are no derivatives; empty if there are some
  std::vector<double> per_unit;      // dg/dp in the units of figure and number; NaN: not defined
  std::vector<double> by_long_step;  // dg/dp by a step that is kLongStep times as long; empty: not requested
  // The value of the number at which a fold is expected; NaN if there is none within its typical change.
  double fold_at = results::NamedScalar::kUnknown;
  SwitchChanges switches = {};      // what becomes taut or slack, or touches or leaves the ground, within its
                                    // typical change
  std::vector<double> motion = {};  // dx/dp of (1) over all degrees of freedom; empty: not requested
};

struct Sensitivities {
  std::vector<results::NamedScalar> figures;  // [results] of the scene, figures of the gear, forces of holds
  std::vector<NumberEffect> effects;
  SwitchSides sides = {};       // what is slack and what touches the ground at the equilibrium
  bool is_interrupted = false;  // whether effects of further numbers are missing after an interruption
};

/// A derivative depends on the step if its values with both steps differ by more than this fraction of the
/// largest derivative of the figure. Derivatives are compared as changes of the figure by one percent of the
/// number.
inline constexpr double kSameDerivative = 0.01;

struct SensitivityRequest {
  std::vector<results::NamedScalar> figures;  // all_figures() of the equilibrium
  std::vector<SceneNumber> numbers;
  bool with_long_step = false;  // compute each derivative also with a second, longer step
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(std::size_t done, const std::string& path)> on_number = {};
  bool with_reach = false;   // find switches and folds, which limit the range of each derivative
  bool with_motion = false;  // keep dx/dp
};

/// The reason why a scene cannot have derivatives: it is a motion, or it leaves a length to the search.
/// nullopt if it can.
std::optional<std::string> why_no_derivatives(const scenes::LoadedScene& loaded);
/// The reason why a solution cannot have derivatives: its solve did not converge. nullopt if it did.
std::optional<std::string> why_no_derivatives(const Solution& solution);

/// The derivatives of all figures g(x, p) at the equilibrium x of a scene, where the residual r(x, p) is
/// zero:
///   dg/dp = ∂g/∂p + ∂g/∂x dx/dp,   K dx/dp = −∂r/∂p                                       (1)
/// K is the exact tangent at x, factorised once for all numbers. For each number, the scene is instantiated
/// at p ± h with the same mesh topology, which gives ∂r/∂p and dx/dp (runs::Tangent), and then, to second
/// order in h,
///   dg/dp = [g(x + h dx/dp, p + h) − g(x − h dx/dp, p − h)] / 2h                           (2)
/// without a search for another equilibrium. h is a millionth of the number, or of its unit if the number is
/// zero. If the number is at an end of its range, p itself replaces the value beyond the end. The long step
/// is a thousandth; with it, x ± h dx/dp is corrected by one step with K. Numbers of a net plan, its counts
/// of meshes included, move the nodes of the mesh and keep its triangles (PreparedScene::prepare_like()). A
/// number has no derivatives if the scene is not valid on either side, or has other unknowns there.
///
/// The derivatives hold while no member becomes taut or slack, and no node touches or leaves the ground. If a
/// member or node is about to do so, the derivative with the long step is different. If the reach of
/// derivatives is requested, switch_changes() finds the members and nodes that would switch within the
/// typical change of a number, to first order. A number has no derivatives if its typical change reaches a
/// fold. There are two conditions for a fold: runs::Tangent::growth() predicts it so near; and at twice its
/// distance, the solver finds no equilibrium where (1) expects it, by the rules of Branch. Without the second
/// condition, slack netting would count, because it moves so far that its stiffness soon changes.
Sensitivities find_sensitivities(runs::PreparedScene& scene, const Solution& solution,
                                 const SensitivityRequest& request);

/// The derivatives of some figures with respect to some numbers.
struct FigureSlopes {
  std::vector<std::vector<double>> rows;  // a row per figure, a column per number; empty: there are none
  std::string why_not;                    // why there are none, as a sentence; empty after an interruption
};

/// The derivatives of `figures`, named as in a study ("results/NAME", "gear/…", "held/…"), at the equilibrium
/// of a scene.
FigureSlopes slopes_of(runs::PreparedScene& scene, const Solution& solution,
                       const std::vector<std::string>& figures, const std::vector<SceneNumber>& numbers,
                       const std::atomic<bool>* interrupt);

/// The [results] of a scene, the figures of its gear, and the forces of its holds.
std::vector<results::NamedScalar> all_figures(const results::Result& result);

/// The indices in all_figures() of the figures that `names` selects. Each name is that of a figure, or of a
/// group such as "mouth". If there are no names, the key figures of the result are selected. Throws
/// std::invalid_argument with a sentence if a name is unknown.
std::vector<std::size_t> chosen_figures(const results::Result& result, const std::vector<std::string>& names);

/// Change of figure `f` if the number increases by one percent.
double effect_of_percent(const NumberEffect& effect, std::size_t f);

/// The standard deviation of a number or, if that is not known, one percent of the number.
double typical_change(const SceneNumber& number);

/// Change of figure `f` when the number increases by its typical change.
double typical_effect(const NumberEffect& effect, std::size_t f);

/// The effects on figure `f`, the largest first, by their typical_effect(). Numbers without an effect are
/// left out.
std::vector<const NumberEffect*> ranked_effects(const Sensitivities& found, std::size_t f);

/// The standard deviation of figure `f` that follows from those of the numbers, to first order, if the
/// numbers are independent:
///   σ_f² = Σ (∂f/∂p σ_p)²                                                                   (3)
/// 0 if no number has a deviation.
double propagated_deviation(const Sensitivities& found, std::size_t f);

/// Whether the derivatives of figure `f` with the long and the short step differ.
bool depends_on_step(const Sensitivities& found, const NumberEffect& effect, std::size_t f);

/// The report as text: a table for each chosen figure, with the numbers that have the largest effects on it;
/// then the numbers without derivatives, with the reasons.
std::string sensitivity_text(const Sensitivities& found, const std::vector<std::size_t>& figures);

/// The largest effects on each of the chosen figures as bars. A bar is the change of the figure in percent if
/// the number increases by one percent. Figures that are zero are left out.
formats::BarChart sensitivity_bars(const Sensitivities& found, const std::vector<std::size_t>& figures);

/// All effects as one JSON object; `status` is that of the equilibrium.
std::string sensitivity_json(const Sensitivities& found, const std::vector<std::size_t>& figures,
                             const std::string& status);

/// All effects as the bytes of an HDF5 file (io/formats/hdf5/LAYOUT.md).
std::string sensitivity_hdf(const Sensitivities& found, const std::vector<std::size_t>& figures,
                            const std::string& status);

}  // namespace netloft::studies
