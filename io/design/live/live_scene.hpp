// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/live/equilibrium.hpp"
#include "io/formats/svg/svg.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/number_words.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace netloft::design {

/// A change of the scene that consists of a new value for one number.
struct MovedNumber {
  std::string path;
  double to = 0;  // in the unit in which it is written
};

/// How the equilibrium and the figures change with one number, to first order (studies::NumberEffect).
struct Tangents {
  studies::NumberEffect effect;
  std::vector<double> motion;  // of the nodes, 3 each, per unit of the number [m]; empty: see effect.why_not
};

/// An equilibrium that is not where the tangent predicted it.
struct Jump {
  double off = 0, moved = 0;  // largest distances of a node from its predicted and its previous place [m]
  std::string why;            // what changed between the two equilibria, as far as it is known
};

/// The result of reading a text and searching for its equilibrium.
struct Outcome {
  // `ended`: the process of the solver has ended
  enum class Status {
    wrong_input,
    refused,
    no_equilibrium_sought,
    converged,
    not_converged,
    interrupted,
    ended
  };
  Status status = Status::wrong_input;
  formats::Diagnostics diagnostics = {};  // messages about the text
  std::string sentence = {}, at_fault = {};
  bool has_same_mesh = false;  // whether the nodes are those of the last equilibrium
  bool has_own_mesh = true;    // whether the mesh is made from this text, not kept from the last equilibrium
  bool is_as_run = false;      // whether a run of the text, from its sketch, has found the equilibrium
  std::optional<double> ghost_off = {};  // largest distance from the predicted place, as Jump::off [m]
  std::optional<Jump> jump = {};
  double reading_seconds = 0, solving_seconds = 0;
};
const char* name_of(Outcome::Status status);

/// A scene whose text changes, and its equilibrium. The search for each equilibrium starts from the one
/// before. If there is none so near, it is sought from the sketch; if this does not converge either, the last
/// equilibrium is kept. Only that of the first text and rerun() examine its stability. For use by one thread.
class LiveScene {
 public:
  LiveScene(const std::filesystem::path& file, Registry& registry, int threads);

  /// The mesh on which the equilibrium of a text is found. `own`: the mesh that any run of this text has.
  /// `kept`: the mesh of the last equilibrium, if only one number has changed. A new mesh has other nodes, on
  /// which the search takes several times as long.
  enum class Mesh { own, kept };

  /// Reads the scene with these texts of its files, and finds its equilibrium. `moved` is the only difference
  /// from the last text, if known. When `interrupt` is set, the search ends with Status::interrupted.
  Outcome follow(const std::filesystem::path& file, const formats::StoredTexts& texts,
                 const std::optional<MovedNumber>& moved, const std::atomic<bool>& interrupt,
                 Mesh mesh = Mesh::own);

  /// Finds the equilibrium of the last text from its sketch, exactly as a run does, and takes it in place of
  /// the last one. If they differ noticeably, the outcome has a jump. There must be an equilibrium.
  Outcome rerun(const std::atomic<bool>& interrupt);

  /// The last equilibrium; nullptr before there is any.
  const Equilibrium* last() const { return last_.get(); }

  /// The tangents at the last equilibrium for a number of its scene. They are computed only once for each
  /// number. Throws Refused if there is no such number, or no equilibrium.
  const Tangents& tangents(const std::string& path);
  /// The derivatives of all figures with respect to all numbers of the scene. Throws Refused.
  studies::Sensitivities influences(const std::atomic<bool>& interrupt,
                                    const std::function<void(std::size_t, std::size_t)>& on_number);
  /// The shape and the fields of the last equilibrium, for pictures. Throws Refused.
  results::StoredShape shape() const;
  /// All messages about the plan of the last text, its warnings with tried cures.
  formats::Diagnostics check();
  /// All messages about a plan that is only considered.
  formats::Diagnostics check(const std::filesystem::path& file, const formats::StoredTexts& texts);
  /// The nodes of the points of the plan in the last equilibrium, by their names in the plan, such as
  /// "headrope.end"; of pairs the starboard one. Empty without an equilibrium or a plan.
  std::map<std::string, std::uint32_t> points_of_plan() const;
  /// Draws the plan of the last text, and returns the size of the drawing; nullopt without a plan, or if it
  /// has errors.
  std::optional<formats::DrawingSize> draw_plan(formats::LineDrawing& picture);
  /// The equilibrium after changes of numbers, found by continuation from a given equilibrium and by no other
  /// search. If there is none, the result is nullptr and `why_not` a sentence. Throws formats::Interrupted.
  std::unique_ptr<Equilibrium> neighbour(const Equilibrium& from, std::span<const formats::Change> changes,
                                         const std::atomic<bool>& interrupt, std::string& why_not);
  /// The result of the last equilibrium with the errors of its mesh, for which the scene is solved on other
  /// meshes. Throws Refused and formats::Interrupted.
  results::Result with_mesh_errors(const std::atomic<bool>& interrupt) const;
  /// Units, ranges and descriptions of the numbers that were read so far, by their paths.
  const std::map<std::string, formats::NumberWords>& words() const { return words_; }
  /// A number of the scene of the last equilibrium. Throws Refused.
  studies::SceneNumber number(const std::string& path);

  /// It is told the processor time that a search may take (runs::Watch::on_budget).
  std::function<void(double)> on_budget;

 private:
  std::shared_ptr<runs::PreparedScene> prepare(const runs::CaseSource& source, const MakeFactorisation& make,
                                               Outcome& outcome) const;
  std::shared_ptr<runs::PreparedScene> on_last_mesh() const;
  std::vector<double> ghost_of(const std::optional<MovedNumber>& moved);
  MakeFactorisation factorisations() const;
  runs::Watch watch_with(const std::atomic<bool>& interrupt) const {
    return {.interrupt = &interrupt, .on_budget = on_budget};
  }
  bool follow_near(std::shared_ptr<runs::PreparedScene> scene, const std::optional<MovedNumber>& moved,
                   Mesh mesh, const std::atomic<bool>& interrupt, Outcome& outcome);
  void search_from_sketch(const std::shared_ptr<runs::PreparedScene>& scene, const std::vector<double>& ghost,
                          bool examines, const std::atomic<bool>& interrupt, Outcome& outcome);
  bool take_verdict(Equilibrium& next, Outcome& outcome) const;
  void take(std::unique_ptr<Equilibrium> next);
  void compare(const Equilibrium& next, const std::vector<double>& expected, Outcome& outcome);
  std::vector<double> carried(const Equilibrium& from, const std::vector<double>& x,
                              const runs::PreparedScene& to) const;
  const Equilibrium& need_equilibrium() const;

  EquilibriumStore store_;
  std::map<std::string, formats::NumberWords> words_;
  Registry& registry_;
  runs::CaseSource source_;  // the last text, which may contain errors
  std::unique_ptr<Equilibrium> last_;
  std::vector<std::unique_ptr<Tangents>> tangents_;  // at last_
};

}  // namespace netloft::design
