// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/live/live_scene.hpp"

#include "framework/balance/scales.hpp"
#include "framework/judging/correction.hpp"
#include "io/design/live/switched_parts.hpp"
#include "io/design/texts/scene_texts.hpp"
#include "io/formats/work/interruptible_work.hpp"
#include "io/gears/drawing/drawing.hpp"
#include "io/results/file/start_from.hpp"
#include "io/runs/coarser.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"
#include "io/studies/compare/mesh_error.hpp"
#include "io/studies/sweep/branch.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace netloft::design {

namespace {

// Limit of iterations for one step to a neighbouring value. In the trawl 83-112, steps of 5 % take up to 10
// iterations, and up to 50 where the net folds. If there is no equilibrium, a low limit saves time, because
// half the step is then tried, or the search begins at the sketch.
constexpr int kIterationsOfNeighbour = 60;
// The same for numbers that divide the net plan anew, such as lengths. Measured in the trawl 83-112: if such
// a step takes more iterations, it takes 50 to 100, which is longer than a search from the sketch.
constexpr int kIterationsOnAnotherMesh = 15;

/// While it exists, searches for the equilibrium of a scene do not examine its stability, which takes several
/// times as long as a step to a neighbour.
class WithoutStability {
 public:
  explicit WithoutStability(runs::PreparedScene& scene)
      : examines_(scene.loaded().analysis.limits.judging.examine_growth),
        before_(std::exchange(examines_, false)) {}
  ~WithoutStability() { examines_ = before_; }
  WithoutStability(const WithoutStability&) = delete;
  WithoutStability& operator=(const WithoutStability&) = delete;

 private:
  bool& examines_;
  bool before_;
};

Outcome::Status status_of(const Solution& solution) {
  switch (solution.status) {
    case SolveStatus::converged:
      return Outcome::Status::converged;
    case SolveStatus::interrupted:
      return Outcome::Status::interrupted;
    default:
      return Outcome::Status::not_converged;
  }
}

void put_verdict(const Solution& solution, Outcome& outcome) {
  outcome.solving_seconds = solution.cost.statistics.total_seconds;
  outcome.status = status_of(solution);
  outcome.sentence = solution.reason;
  outcome.at_fault = solution.at_fault;
}

double distance_between(const runs::PreparedScene& scene, const std::vector<double>& a,
                        const std::vector<double>& b) {
  return largest_node_distance(scene.loaded().scene, scene.assembler().numbering(), a, b);
}

/// Returns the positions `x` + `times` · `dx`.
std::vector<double> led(const std::vector<double>& x, const std::vector<double>& dx, double times) {
  return runs::moved({x, {}}, dx, times).x;
}

}  // namespace

const char* name_of(Outcome::Status status) {
  switch (status) {
    case Outcome::Status::wrong_input:
      return "wrong input";
    case Outcome::Status::refused:
      return "plugin refused";
    case Outcome::Status::no_equilibrium_sought:
      return "no equilibrium sought";
    case Outcome::Status::converged:
      return "converged";
    case Outcome::Status::not_converged:
      return "not converged";
    case Outcome::Status::interrupted:
      return "interrupted";
    case Outcome::Status::ended:
      return "solver ended";
  }
  return "";
}

LiveScene::LiveScene(const std::filesystem::path& file, Registry& registry, int threads)
    : registry_(registry), source_(file, {}, threads) {}

Outcome LiveScene::follow(const std::filesystem::path& file, const formats::StoredTexts& texts,
                          const std::optional<MovedNumber>& moved, const std::atomic<bool>& interrupt,
                          Mesh mesh) {
  Outcome outcome;
  source_.scene = source_.scene.with_texts(file, texts);
  const formats::InterruptibleWork reading(interrupt);
  formats::CollectedWords collected;
  try {
    auto scene = prepare(source_, factorisations(), outcome);
    collected.by_path.merge(words_);
    words_ = std::move(collected.by_path);
    if (!scene) return outcome;
    if (last_ && follow_near(scene, moved, mesh, interrupt, outcome)) return outcome;
    if (last_) scene = prepare(source_, {}, outcome);
    search_from_sketch(scene, last_ && moved ? ghost_of(moved) : std::vector<double>(),
                       /*examines=*/!last_, interrupt, outcome);
  } catch (const formats::Interrupted&) {
    outcome.status = Outcome::Status::interrupted;
  }
  return outcome;
}

/// Seeks the equilibrium near the last one, in few iterations. Returns false if there is none so near.
bool LiveScene::follow_near(std::shared_ptr<runs::PreparedScene> scene,
                            const std::optional<MovedNumber>& moved, Mesh mesh,
                            const std::atomic<bool>& interrupt, Outcome& outcome) {
  outcome.has_same_mesh = runs::have_same_topology(*last_->scene, *scene);
  const int most = outcome.has_same_mesh ? kIterationsOfNeighbour : kIterationsOnAnotherMesh;
  if (mesh == Mesh::kept && moved && !outcome.has_same_mesh)
    if (auto kept = on_last_mesh()) {
      scene = std::move(kept);
      outcome.has_same_mesh = true;
      outcome.has_own_mesh = false;
    }
  const std::vector<double> ghost = carried(*last_, ghost_of(moved), *scene);
  if (ghost.empty()) return false;
  auto next = std::make_unique<Equilibrium>();
  next->scene = scene;
  {
    const WithoutStability none(*scene);
    next->solution = runs::continue_equilibrium(*scene, ghost, most, watch_with(interrupt));
  }
  const bool is_found = take_verdict(*next, outcome);
  if (is_found && outcome.has_same_mesh && moved) compare(*next, ghost, outcome);
  if (is_found) take(std::move(next));
  return is_found || outcome.status == Outcome::Status::interrupted;
}

/// Seeks the equilibrium as a run does, exactly so if its stability is examined, and compares it with
/// `ghost`, positions on the last mesh, unless these are empty. The scene is prepared without analyses of
/// earlier factorisations, because they change the last bits.
void LiveScene::search_from_sketch(const std::shared_ptr<runs::PreparedScene>& scene,
                                   const std::vector<double>& ghost, bool examines,
                                   const std::atomic<bool>& interrupt, Outcome& outcome) {
  if (!scene) return;
  outcome.has_own_mesh = true;
  outcome.is_as_run = examines;
  outcome.has_same_mesh = last_ && runs::have_same_topology(*last_->scene, *scene);
  auto next = std::make_unique<Equilibrium>();
  next->scene = scene;
  {
    const auto none = examines ? nullptr : std::make_unique<WithoutStability>(*scene);
    next->solution = runs::find_equilibrium(*scene, watch_with(interrupt));
  }
  if (!take_verdict(*next, outcome)) return;
  if (!ghost.empty()) compare(*next, carried(*last_, ghost, *scene), outcome);
  take(std::move(next));
}

void LiveScene::take(std::unique_ptr<Equilibrium> next) {
  last_ = std::move(next);
  tangents_.clear();
}

/// Completes an equilibrium that was sought. Returns whether it is one.
bool LiveScene::take_verdict(Equilibrium& next, Outcome& outcome) const {
  put_verdict(next.solution, outcome);
  if (outcome.status != Outcome::Status::converged) return false;
  next.points = next.scene->assembler().node_positions(next.solution.x);
  next.result = results::make_result(next.scene->loaded(), next.scene->assembler(), next.solution);
  return true;
}

Outcome LiveScene::rerun(const std::atomic<bool>& interrupt) {
  Outcome outcome;
  const formats::InterruptibleWork reading(interrupt);
  try {
    auto scene = prepare(source_, {}, outcome);
    if (!scene) return outcome;
    const bool is_comparable = runs::have_same_topology(*last_->scene, *scene);
    search_from_sketch(scene, is_comparable ? last_->solution.x : std::vector<double>(), /*examines=*/true,
                       interrupt, outcome);
  } catch (const formats::Interrupted&) {
    outcome.status = Outcome::Status::interrupted;
  }
  return outcome;
}

MakeFactorisation LiveScene::factorisations() const {
  return last_ ? last_->scene->factorisations() : MakeFactorisation{};
}

/// Reads the scene; nullptr if the text has errors, which the outcome then contains.
std::shared_ptr<runs::PreparedScene> LiveScene::prepare(const runs::CaseSource& source,
                                                        const MakeFactorisation& make,
                                                        Outcome& outcome) const {
  auto scene = std::make_shared<runs::PreparedScene>(source, registry_, make);
  const auto state = scene->prepare();
  outcome.diagnostics = scene->diagnostics();
  outcome.reading_seconds = scene->seconds().reading + scene->seconds().setup;
  if (state != runs::PreparedScene::State::ready) {
    outcome.status = state == runs::PreparedScene::State::refused ? Outcome::Status::refused
                                                                  : Outcome::Status::wrong_input;
    return nullptr;
  }
  outcome.status = Outcome::Status::no_equilibrium_sought;
  if (scene->loaded().analysis.kind == AnalysisKind::dynamics)
    outcome.sentence =
        "this scene is a motion, but `netloft design` shows equilibria only; set analysis.kind = \"static\"";
  else if (const auto why_not = runs::why_unfit(*scene))
    outcome.sentence = *why_not;
  else
    return scene;
  return nullptr;
}

/// The scene of the last text, on the mesh of the last equilibrium; nullptr if it cannot be divided in that
/// way.
std::shared_ptr<runs::PreparedScene> LiveScene::on_last_mesh() const {
  auto scene = std::make_shared<runs::PreparedScene>(source_, registry_, last_->scene->factorisations());
  const bool is_ready = scene->prepare_like(*last_->scene) == runs::PreparedScene::State::ready;
  return is_ready && runs::have_same_topology(*last_->scene, *scene) ? scene : nullptr;
}

/// The positions to which the tangent of a moved number leads; the last ones if there is no tangent.
std::vector<double> LiveScene::ghost_of(const std::optional<MovedNumber>& moved) {
  const std::vector<double>& x = last_->solution.x;
  if (!moved) return x;
  try {
    const double by = moved->to - number(moved->path).value;
    if (by == 0) return x;  // the second search for one text
    const studies::NumberEffect& effect = tangents(moved->path).effect;
    return effect.motion.empty() ? x : led(x, effect.motion, by);
  } catch (const Refused&) {  // the last text did not contain the number
    return x;
  }
}

/// Displacements of a scene that give it the shape of an equilibrium with positions `x`; empty if the two
/// scenes have no part in common.
std::vector<double> LiveScene::carried(const Equilibrium& from, const std::vector<double>& x,
                                       const runs::PreparedScene& to) const {
  if (runs::have_same_topology(*from.scene, to)) return to.assembler().displacements_to(x);
  if (const auto positions =
          runs::carried_over(from.scene->loaded(), from.scene->assembler().node_positions(x), to.loaded()))
    return to.assembler().displacements(*positions);
  try {  // the scenes have different parts
    return to.assembler().displacements(results::positions_from(store_.shape_of(from), to.loaded()));
  } catch (const formats::FileError&) {
    return {};
  }
}

/// Computes how far the equilibrium is from the displacements that the tangent predicted, and whether it has
/// jumped. It has jumped, by the rule of studies::Branch, if this distance is noticeable and larger than the
/// whole predicted displacement.
void LiveScene::compare(const Equilibrium& next, const std::vector<double>& expected, Outcome& outcome) {
  Assembler& assembler = next.scene->assembler();
  const auto place = [&](const std::vector<double>& u) {
    std::vector<double> x(assembler.start().begin(), assembler.start().end());
    assembler.place(u, x);
    return x;
  };
  const std::vector<double> ghost = place(expected);
  const std::vector<double> before = place(carried(*last_, last_->solution.x, *next.scene));
  const double off = distance_between(*next.scene, next.solution.x, ghost);
  outcome.ghost_off = off;
  const double size = Scales(assembler).gear_size(), led_to = distance_between(*next.scene, ghost, before);
  if (off <= studies::BranchOptions{}.noticed * size || off <= led_to) return;
  outcome.jump = Jump{off, distance_between(*next.scene, next.solution.x, before),
                      switched_parts(*last_->scene, last_->solution.x, *next.scene, next.solution.x)};
}

const Equilibrium& LiveScene::need_equilibrium() const {
  if (!last_) throw Refused("there is no equilibrium yet");
  for (const auto& why_not :
       {studies::why_no_derivatives(last_->solution), studies::why_no_derivatives(last_->scene->loaded())})
    if (why_not) throw Refused(*why_not);
  return *last_;
}

studies::SceneNumber LiveScene::number(const std::string& path) {
  if (!last_) throw Refused("there is no equilibrium yet");
  try {
    auto chosen = studies::chosen_numbers(*last_->scene, {path});
    if (chosen.size() == 1) return std::move(chosen.front());
  } catch (const std::invalid_argument& e) {
    throw Refused(e.what());
  }
  throw Refused(path + " is a table of several numbers; name one of them");
}

const Tangents& LiveScene::tangents(const std::string& path) {
  const Equilibrium& at = need_equilibrium();
  for (const auto& known : tangents_)
    if (known->effect.number.path == path) return *known;
  auto found = std::make_unique<Tangents>();
  auto effects =
      studies::find_sensitivities(
          *at.scene, at.solution,
          {.figures = studies::all_figures(at.result), .numbers = {number(path)}, .with_motion = true})
          .effects;
  if (effects.empty()) throw formats::Interrupted{};
  found->effect = std::move(effects.front());
  if (!found->effect.motion.empty()) {
    const auto there = at.scene->assembler().node_positions(led(at.solution.x, found->effect.motion, 1));
    for (std::size_t i = 0; i < there.size(); ++i) found->motion.push_back(there[i] - at.points[i]);
  }
  tangents_.push_back(std::move(found));
  return *tangents_.back();
}

studies::Sensitivities LiveScene::influences(const std::atomic<bool>& interrupt,
                                             const std::function<void(std::size_t, std::size_t)>& on_number) {
  const Equilibrium& at = need_equilibrium();
  const auto numbers = studies::chosen_numbers(*at.scene, {});
  return studies::find_sensitivities(
      *at.scene, at.solution,
      {.figures = studies::all_figures(at.result),
       .numbers = numbers,
       .interrupt = &interrupt,
       .on_number = [&](std::size_t done, const std::string&) { on_number(done, numbers.size()); }});
}

results::StoredShape LiveScene::shape() const {
  if (!last_) throw Refused("there is no equilibrium yet");
  return store_.shape_of(*last_);
}

formats::Diagnostics LiveScene::check() {
  formats::Diagnostics said;
  bool refused = false;
  source_.scene.check_plan({}, registry_, said, refused);
  return said;
}

formats::Diagnostics LiveScene::check(const std::filesystem::path& file, const formats::StoredTexts& texts) {
  formats::Diagnostics said;
  bool refused = false;
  source_.scene.with_texts(file, texts).check_plan({}, registry_, said, refused);
  return said;
}

std::map<std::string, std::uint32_t> LiveScene::points_of_plan() const {
  std::map<std::string, std::uint32_t> nodes;
  if (!last_ || !last_->scene->loaded().gear) return nodes;
  const scenes::LoadedScene& loaded = last_->scene->loaded();
  const auto put = [&](std::string name, std::uint32_t node) {
    constexpr std::string_view kStarboard = "starboard-", kEndInMesh = ".starboard";
    if (name.starts_with("port-") || name.ends_with(".port")) return;
    if (name.starts_with(kStarboard)) name.erase(0, kStarboard.size());
    if (name.ends_with(kEndInMesh)) name.replace(name.size() - kEndInMesh.size(), kEndInMesh.size(), ".end");
    nodes.emplace(std::move(name), node);
  };
  for (const auto& [name, node] : loaded.gear->points) put(name, node);
  for (std::size_t b = 0; b < loaded.bodies.size(); ++b)
    for (std::size_t i = 0; i < loaded.bodies[b].points.size() && loaded.bodies[b].side > 0; ++i)
      put(loaded.scene.bodies[b].name + "." + loaded.bodies[b].points[i],
          loaded.scene.bodies[b].points[i].node);
  return nodes;
}

std::optional<formats::DrawingSize> LiveScene::draw_plan(formats::LineDrawing& picture) {
  formats::Diagnostics said;
  bool refused = false;
  const gears::NetPlan plan = source_.scene.check_plan({}, registry_, said, refused);
  if (said.errors() || plan.panels.empty()) return std::nullopt;
  return gears::draw_plan(plan, picture);
}

results::Result LiveScene::with_mesh_errors(const std::atomic<bool>& interrupt) const {
  if (!last_) throw Refused("there is no equilibrium yet");
  results::Result result = last_->result;
  try {
    studies::find_mesh_errors(last_->scene->source(), registry_, *last_->scene, last_->solution,
                              studies::levels_around(last_->scene->loaded()), watch_with(interrupt), result);
  } catch (const std::invalid_argument& e) {
    throw Refused(e.what());
  }
  if (interrupt) throw formats::Interrupted{};
  return result;
}

std::unique_ptr<Equilibrium> LiveScene::neighbour(const Equilibrium& from,
                                                  std::span<const formats::Change> changes,
                                                  const std::atomic<bool>& interrupt, std::string& why_not) {
  Outcome outcome;
  runs::CaseSource source = from.scene->source();
  formats::append(source.changes, {changes.begin(), changes.end()});
  auto next = std::make_unique<Equilibrium>();
  next->scene = prepare(source, factorisations(), outcome);
  if (!next->scene) {
    why_not = outcome.sentence;
    for (const formats::Diagnostic& said : outcome.diagnostics.messages())
      if (said.severity == formats::Severity::error && why_not.empty()) why_not = said.message;
    return nullptr;
  }
  const auto u = carried(from, from.solution.x, *next->scene);
  next->solution = runs::continue_equilibrium(*next->scene, u, kIterationsOfNeighbour, watch_with(interrupt));
  if (next->solution.status == SolveStatus::interrupted) throw formats::Interrupted{};
  if (next->solution.status != SolveStatus::converged) {
    why_not = std::string(netloft::name_of(next->solution.status)) + ": " + next->solution.reason;
    return nullptr;
  }
  next->points = next->scene->assembler().node_positions(next->solution.x);
  next->result = results::make_result(next->scene->loaded(), next->scene->assembler(), next->solution);
  return next;
}

}  // namespace netloft::design
