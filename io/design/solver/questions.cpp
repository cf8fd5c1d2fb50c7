// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/questions.hpp"

#include "io/formats/units/units.hpp"
#include "io/formats/work/interruptible_work.hpp"
#include "io/pictures/view/report_html.hpp"
#include "io/pictures/view/result_json.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::design {

namespace {

constexpr int kMostPoints = 201;      // of a sweep
constexpr int kMostSteps = 25;        // towards a target
constexpr double kOnTarget = 1e-6;    // tolerance over the target, or over the first value if the target is 0
constexpr double kLongestStep = 0.5;  // largest change of the number in one step, as a fraction of the number
constexpr double kStepOfLimit = 0.05;  // first step of a search for a limit, as a fraction of the number
constexpr int kMostStepsOfLimit = 40;  // limits beyond three times the number are not searched
constexpr int kHalvings = 6;           // how often a step without an equilibrium is halved

const Equilibrium& need_last(const LiveScene& scene) {
  if (!scene.last()) throw Refused("there is no equilibrium yet");
  return *scene.last();
}

std::size_t figure_called(const Equilibrium& at, const std::string& name) {
  const auto figures = studies::all_figures(at.result);
  const auto found = std::ranges::find(figures, name, &results::NamedScalar::name);
  if (found == figures.end()) throw Refused("there is no figure \"" + name + "\"");
  return static_cast<std::size_t>(found - figures.begin());
}

double value_of(const Equilibrium& at, const std::string& figure) {
  const auto figures = studies::all_figures(at.result);
  const auto* found = results::find_scalar(figures, figure);
  return found ? found->value : results::NamedScalar::kUnknown;
}

Json number_or_nothing(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json effect_json(const studies::NumberEffect& effect, std::size_t figure) {
  return {{"path", effect.number.path},
          {"value", effect.number.value},
          {"unit", effect.number.unit},
          {"slope", number_or_nothing(effect.per_unit[figure])},
          {"per_percent", number_or_nothing(studies::effect_of_percent(effect, figure))}};
}

/// Computes the figures at all values on one side of the present value, each starting from the equilibrium at
/// its neighbour.
template <class Indices>
void sweep_side(LiveScene& scene, const studies::SceneNumber& number, const std::vector<double>& values,
                const Indices& indices, const std::function<void(std::size_t, const Equilibrium*)>& on_point,
                const std::atomic<bool>& interrupt) {
  std::unique_ptr<Equilibrium> before;
  for (const std::size_t i : indices) {
    const Equilibrium& from = before ? *before : need_last(scene);
    std::string why_not;
    auto next = scene.neighbour(from, number, values[i], interrupt, why_not);
    on_point(i, next.get());
    if (next) before = std::move(next);
  }
}

}  // namespace

Json picture_json(const LiveScene& scene) {
  const results::StoredShape shape = scene.shape();
  return Json::parse(pictures::results_json({&shape}, 1));
}

Json report_json(const LiveScene& scene) {
  const Equilibrium& now = need_last(scene);
  return {{"figures", figures_json(now)},
          {"summary", pictures::summary_html(now.result)},
          {"materials", pictures::materials_html(now.result)},
          {"deck", pictures::deck_html(now.result)}};
}

Json influences_json(LiveScene& scene, const std::string& figure, const std::atomic<bool>& interrupt,
                     const OnProgress& on_done) {
  const std::size_t f = figure_called(need_last(scene), figure);
  const studies::Sensitivities found = scene.influences(interrupt, on_done);
  if (found.is_interrupted) throw formats::Interrupted{};
  Json json = {{"figure", figure}, {"ranked", Json::array()}, {"without", Json::array()}};
  for (const auto* effect : studies::ranked_effects(found, f))
    json["ranked"].push_back(effect_json(*effect, f));
  for (const auto& effect : found.effects)
    if (!effect.why_not.empty())
      json["without"].push_back({{"path", effect.number.path}, {"why", effect.why_not}});
  return json;
}

Json sweep_json(LiveScene& scene, const SweepQuestion& question, const std::atomic<bool>& interrupt,
                const OnProgress& on_done) {
  if (question.points < 2 || question.points > kMostPoints)
    throw WrongRequest("\"points\" is " + std::to_string(question.points) + "; it has to be between 2 and " +
                       std::to_string(kMostPoints));
  const formats::InterruptibleWork work(interrupt);
  const studies::SceneNumber number = scene.number(question.path);
  const auto names = studies::all_figures(need_last(scene).result);
  const auto count = static_cast<std::size_t>(question.points);
  std::vector<double> values;
  std::vector<std::size_t> up, down;
  Json figures = Json::object();
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    values.push_back(question.from + share * (question.to - question.from));
    (values.back() >= number.value ? up : down).push_back(i);
  }
  std::ranges::sort(up, {}, [&](std::size_t i) { return values[i]; });
  std::ranges::sort(down, std::greater{}, [&](std::size_t i) { return values[i]; });
  for (const auto& figure : names) figures[figure.name] = Json(std::vector<Json>(count));
  std::size_t done = 0;
  const auto put = [&](std::size_t i, const Equilibrium* at) {
    for (const auto& figure : names)
      figures[figure.name][i] = at ? number_or_nothing(value_of(*at, figure.name)) : Json(nullptr);
    on_done(++done, count);
  };
  sweep_side(scene, number, values, up, put, interrupt);
  sweep_side(scene, number, values, down, put, interrupt);
  return {{"path", number.path}, {"unit", number.unit}, {"values", values}, {"figures", figures}};
}

namespace {

/// The search for the value of a number at which a figure has its target.
class TargetSearch {
 public:
  TargetSearch(LiveScene& scene, const ReachQuestion& question, const std::atomic<bool>& interrupt)
      : scene_(scene),
        question_(question),
        interrupt_(interrupt),
        number_(scene.number(question.path)),
        at_(&need_last(scene)),
        value_(number_.value),
        figure_(value_of(*at_, question.figure)),
        scale_(std::abs(question.target) > 0 ? std::abs(question.target) : std::abs(figure_)) {}

  Json find() {
    double slope = slope_by_tangent();
    for (int step = 0; step < kMostSteps && !is_there(); ++step) {
      const double before = value_, then = figure_;
      if (!(std::abs(slope) > 0) || !go(limited((question_.target - figure_) / slope)))
        throw Refused(nearest_so_far());
      if (figure_ != then) slope = (figure_ - then) / (value_ - before);
    }
    if (!is_there()) throw Refused(nearest_so_far());
    return {{"path", number_.path},
            {"value", value_},
            {"unit", number_.unit},
            {"figure", question_.figure},
            {"reached", figure_}};
  }

 private:
  /// Whether the target is reached, up to the accuracy of the solver.
  bool is_there() const {
    const auto figures = studies::all_figures(at_->result);
    const double error = results::find_scalar(figures, question_.figure)->solver_error;
    return std::abs(figure_ - question_.target) <= std::fmax(kOnTarget * scale_, error);
  }

  double slope_by_tangent() {
    const Tangents& tangents = scene_.tangents(number_.path);
    if (!tangents.effect.why_not.empty()) throw Refused(number_.path + ": " + tangents.effect.why_not);
    return tangents.effect.per_unit[figure_called(*at_, question_.figure)];
  }

  double limited(double step) const {
    const double most = kLongestStep * (value_ != 0 ? std::abs(value_) : 1);
    return std::clamp(step, -most, most);
  }

  /// Changes the number by `step`, or by less if there is no equilibrium at that distance.
  bool go(double step) {
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2) {
      auto next = scene_.neighbour(*at_, number_, value_ + step, interrupt_, why_not_);
      if (!next) continue;
      kept_ = std::move(next);
      at_ = kept_.get();
      value_ += step;
      figure_ = value_of(*at_, question_.figure);
      return std::isfinite(figure_);
    }
    return false;
  }

  std::string nearest_so_far() const {
    return question_.figure + " does not reach " + formats::format(question_.target) + " with " +
           number_.path + " alone; it is " + formats::format(figure_) + " at " + formats::format(value_) +
           (number_.unit.empty() ? "" : " " + number_.unit) +
           (why_not_.empty() ? "" : "; beyond, " + why_not_);
  }

  LiveScene& scene_;
  const ReachQuestion& question_;
  const std::atomic<bool>& interrupt_;
  studies::SceneNumber number_;
  const Equilibrium* at_;
  std::unique_ptr<Equilibrium> kept_;
  double value_, figure_, scale_;
  std::string why_not_;  // why the last attempted step has no equilibrium
};

}  // namespace

Json reach_json(LiveScene& scene, const ReachQuestion& question, const std::atomic<bool>& interrupt) {
  const formats::InterruptibleWork work(interrupt);
  figure_called(need_last(scene), question.figure);
  return TargetSearch(scene, question, interrupt).find();
}

namespace {

/// The search for the smallest and the largest value of a number for which a design works.
class LimitSearch {
 public:
  LimitSearch(LiveScene& scene, const RangeQuestion& question, const std::atomic<bool>& interrupt)
      : scene_(scene), question_(question), interrupt_(interrupt), number_(scene.number(question.path)) {}

  /// Steps from the present value in one direction. Near the limit, steps are halved.
  Json limit(double direction) {
    const Equilibrium* at = &need_last(scene_);
    std::unique_ptr<Equilibrium> kept;
    double value = number_.value, step = direction * kStepOfLimit * (value != 0 ? std::abs(value) : 1);
    std::string why;
    int halvings = 0;
    for (int steps = 0; steps < kMostStepsOfLimit && halvings <= kHalvings; ++steps) {
      std::string why_not;
      auto next = scene_.neighbour(*at, number_, value + step, interrupt_, why_not);
      if (next) why_not = fault_of(*next);
      if (!why_not.empty()) {
        why = why_not;
        step /= 2;
        ++halvings;
        continue;
      }
      kept = std::move(next);
      at = kept.get();
      value += step;
      if (halvings) step /= 2, ++halvings;
    }
    return {{"value", value}, {"why", why.empty() ? "nothing ends it so far" : why}};
  }

  const studies::SceneNumber& number() const { return number_; }

 private:
  /// A sentence about a part that bears more than its breaking load, or about a violated bound of the
  /// question.
  std::string fault_of(const Equilibrium& at) const {
    for (const results::Material& material : at.result.materials)
      if (material.utilisation() > 1) return material.item.name + " bears more than its breaking load";
    const double figure = question_.figure.empty() ? 0 : value_of(at, question_.figure);
    if (figure < question_.least)
      return question_.figure + " falls below " + formats::format(question_.least);
    if (figure > question_.largest)
      return question_.figure + " exceeds " + formats::format(question_.largest);
    return "";
  }

  LiveScene& scene_;
  const RangeQuestion& question_;
  const std::atomic<bool>& interrupt_;
  studies::SceneNumber number_;
};

}  // namespace

Json range_json(LiveScene& scene, const RangeQuestion& question, const std::atomic<bool>& interrupt) {
  const formats::InterruptibleWork work(interrupt);
  if (!question.figure.empty()) figure_called(need_last(scene), question.figure);
  LimitSearch search(scene, question, interrupt);
  const Json down = search.limit(-1), up = search.limit(1);
  return {{"path", search.number().path}, {"unit", search.number().unit}, {"down", down}, {"up", up}};
}

}  // namespace netloft::design
