// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/questions.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/formats/units/units.hpp"
#include "io/formats/work/interruptible_work.hpp"
#include "io/pictures/picture/base64.hpp"
#include "io/pictures/picture/pdf_picture.hpp"
#include "io/pictures/view/page.hpp"
#include "io/pictures/view/report_html.hpp"
#include "io/pictures/view/result_json.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::design {

namespace {

constexpr int kMostPoints = 201;      // of a sweep
constexpr int kMostSteps = 25;        // towards a target
constexpr double kOnTarget = 1e-6;    // tolerance over the target, or over the first value if the target is 0
constexpr double kLongestStep = 0.5;  // largest change of all numbers in one step, as a fraction of them
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
    auto next = scene.neighbour(from, number.to(values[i]), interrupt, why_not);
    on_point(i, next.get());
    if (next) before = std::move(next);
  }
}

}  // namespace

Json picture_json(const results::StoredShape& shape) {
  return Json::parse(pictures::results_json({&shape}, 1));
}

Json picture_json(const LiveScene& scene) { return picture_json(scene.shape()); }

Json beside_json(const results::StoredShape& shape) {
  return {{"figures", figures_json(shape.result)}, {"picture", picture_json(shape)}};
}

Json report_json(const LiveScene& scene) {
  const Equilibrium& now = need_last(scene);
  return {{"figures", figures_json(now.result)},
          {"summary", pictures::summary_html(now.result)},
          {"materials", pictures::materials_html(now.result)},
          {"deck", pictures::deck_html(now.result)}};
}

Json plan_json(LiveScene& scene) {
  formats::SvgPicture picture;
  const auto size = scene.draw_plan(picture);
  return {{"svg", size ? picture.finish(*size, size->width) : ""}};
}

Json export_json(LiveScene& scene, const std::string& kind) {
  const results::StoredShape shape = scene.shape();
  std::string bytes;
  if (kind == "hdf") {
    bytes = formats::read_whole(shape.result.path).value_or("");
  } else if (kind == "html") {
    bytes = pictures::view_page({&shape}, 1);
  } else if (kind == "pdf") {
    pictures::PdfPicture picture;
    const auto size = scene.draw_plan(picture);
    if (!size) throw Refused("there is no plan, or it has errors");
    bytes = picture.finish(*size);
  } else {
    throw WrongRequest("\"as\" has to be \"hdf\", \"html\" or \"pdf\"");
  }
  return {{"name", std::filesystem::path(shape.result.path).stem().string() + "." + kind},
          {"base64", pictures::base64(pictures::bytes_of(bytes))}};
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

/// The search for values of numbers at which a figure has its target. The values lie on a line through the
/// present ones: value + t · share · scale, with the size of the value as its scale.
class TargetSearch {
 public:
  TargetSearch(LiveScene& scene, const ReachQuestion& question, const std::atomic<bool>& interrupt)
      : scene_(scene),
        question_(question),
        interrupt_(interrupt),
        at_(&need_last(scene)),
        figure_(value_of(*at_, question.figure)),
        scale_(std::abs(question.target) > 0 ? std::abs(question.target) : std::abs(figure_)) {
    for (const std::string& path : question.paths) numbers_.push_back(scene.number(path));
  }

  Json find() {
    double slope = choose_line();
    for (int step = 0; step < kMostSteps && !is_there(); ++step) {
      const double before = t_, then = figure_;
      if (!(std::abs(slope) > 0) || !go(limited((question_.target - figure_) / slope)))
        throw Refused(nearest_so_far());
      if (figure_ != then) slope = (figure_ - then) / (t_ - before);
    }
    if (!is_there()) throw Refused(nearest_so_far());
    Json json = {{"numbers", Json::array()}, {"figure", question_.figure}, {"reached", figure_}};
    for (std::size_t n = 0; n < numbers_.size(); ++n)
      json["numbers"].push_back(
          {{"path", numbers_[n].path}, {"value", value(n, t_)}, {"unit", numbers_[n].unit}});
    return json;
  }

 private:
  /// Whether the target is reached, up to the accuracy of the solver.
  bool is_there() const {
    const auto figures = studies::all_figures(at_->result);
    const double error = results::find_scalar(figures, question_.figure)->solver_error;
    return std::abs(figure_ - question_.target) <= std::fmax(kOnTarget * scale_, error);
  }

  static double size_of(const studies::SceneNumber& number) {
    return number.value != 0 ? std::abs(number.value) : 1;
  }
  double value(std::size_t n, double t) const {
    return numbers_[n].value + t * shares_[n] * size_of(numbers_[n]);
  }

  /// Chooses the line along which the figure changes most, and returns its slope there.
  double choose_line() {
    const std::size_t figure = figure_called(*at_, question_.figure);
    double square = 0;
    for (const studies::SceneNumber& number : numbers_) {
      const Tangents& tangents = scene_.tangents(number.path);
      if (!tangents.effect.why_not.empty()) throw Refused(number.path + ": " + tangents.effect.why_not);
      shares_.push_back(tangents.effect.per_unit[figure] * size_of(number));
      square += shares_.back() * shares_.back();
    }
    const double length = std::sqrt(square);
    if (length > 0)
      for (double& share : shares_) share /= length;
    return length;
  }

  static double limited(double step) { return std::clamp(step, -kLongestStep, kLongestStep); }

  /// Goes a step along the line, or less if there is no equilibrium at that distance.
  bool go(double step) {
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2) {
      std::vector<formats::Change> changes;
      for (std::size_t n = 0; n < numbers_.size(); ++n)
        formats::append(changes, numbers_[n].to(value(n, t_ + step)));
      auto next = scene_.neighbour(*at_, changes, interrupt_, why_not_);
      if (!next) continue;
      kept_ = std::move(next);
      at_ = kept_.get();
      t_ += step;
      figure_ = value_of(*at_, question_.figure);
      return std::isfinite(figure_);
    }
    return false;
  }

  std::string nearest_so_far() const {
    std::string names, values;
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      const std::string& unit = numbers_[n].unit;
      names += (n ? ", " : "") + numbers_[n].path;
      values += (n ? ", " : "") + formats::format(value(n, t_)) + (unit.empty() ? "" : " " + unit);
    }
    return question_.figure + " does not reach " + formats::format(question_.target) + " with " + names +
           " alone; it is " + formats::format(figure_) + " at " + values +
           (why_not_.empty() ? "" : "; beyond, " + why_not_);
  }

  LiveScene& scene_;
  const ReachQuestion& question_;
  const std::atomic<bool>& interrupt_;
  std::vector<studies::SceneNumber> numbers_;
  std::vector<double> shares_;
  const Equilibrium* at_;
  std::unique_ptr<Equilibrium> kept_;
  double t_ = 0, figure_, scale_;
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
      auto next = scene_.neighbour(*at, number_.to(value + step), interrupt_, why_not);
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
