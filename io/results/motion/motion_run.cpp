// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/motion_run.hpp"
#include "io/runs/march.hpp"

#include "io/formats/hdf5/image.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/results/figures/fallen_boards.hpp"
#include "io/results/figures/materials.hpp"
#include "io/results/file/grid_fields.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/motion/checkpoint.hpp"
#include "io/results/motion/motion_watch.hpp"
#include "io/results/motion/warp_figures.hpp"
#include "io/results/motion/xdmf.hpp"
#include "io/scenes/reading/result_request.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

namespace netloft::results {

namespace {

const std::string kEnergy = "energy/", kGear = "gear/";

/// Computes one motion. The journal, the file NAME.hdf.part, is created at the first output, because the
/// layout of outputs is unknown before.
class MotionRun {
 public:
  MotionRun(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options)
      : scene_(scene),
        loaded_(scene.loaded()),
        options_(options),
        watch_(loaded_.scene, scene.assembler()),
        result_(describe_scene(loaded_, scene.assembler())) {
    result_.origins = make_origins(loaded_, context);
    result_.motion.emplace();
  }

  MotionResult run() {
    if (options_.resume) from_ = read_killed();
    if (!from_ && options_.start) from_ = rest_at(*options_.start);
    const MarchWatch watch{[&](const Snapshot& at) { write(at); },
                           [&](const StepRecord& step, std::span<const double>) {
                             if (options_.on_step) options_.on_step(step);
                             return false;
                           }};
    MarchResult march =
        runs::march(scene_, watch, {.interrupt = options_.interrupt, .on_iteration = options_.on_iteration},
                    from_ ? &*from_ : nullptr);
    note_march(march);
    if (!journal_) return {std::move(result_), march};
    if (outputs_ == outputs_before_) recall_last_output();
    finish(march);
    return {std::move(result_), march};
  }

 private:
  /// The state of rest at the displacements u, in which a motion starts. Elements store u as their last
  /// accepted step.
  MarchState rest_at(std::span<const double> u) {
    runs::remember(scene_, u);
    return state_at_rest(scene_.assembler(), u);
  }
  MarchState read_killed() {
    const std::filesystem::path part = part_path();
    if (!std::filesystem::exists(part))
      throw formats::FileError("there is no " + part.string() + " to go on from");
    journal_.emplace(formats::SeriesJournal::go_on(part, options_.identity));
    Checkpoint kept =
        formats::with_context(part.string(), [&] { return unpack_checkpoint(journal_->checkpoint()); });
    watch_.go_on_from(std::move(kept.findings));
    result_.motion->resumed_from = kept.state.t;
    outputs_ = outputs_before_ = journal_->size();
    if (!journal_->damage().empty()) warn_of_damage();
    return std::move(kept.state);
  }
  void warn_of_damage() const {
    if (options_.warn)
      options_.warn(part_path() + ": " + journal_->damage() + "; the run goes on from the " +
                    std::to_string(outputs_before_) +
                    " outputs before the damage, and the damaged file is kept as " +
                    journal_->path_of_damaged().string());
  }
  std::string part_path() const { return options_.output.string() + ".part"; }

  void write(const Snapshot& at) {
    const formats::SeriesState state = describe(at);
    watch_.note(at, find_fallen_boards(loaded_, result_.figures));
    if (!journal_) begin_journal();
    if (outputs_ == outputs_before_) journal_->require_layout(layout_);
    journal_->write(state, at.state ? pack_checkpoint(*at.state, watch_.findings()) : "");
    ++outputs_;
  }
  void begin_journal() {
    // The bill is made again, because the search for the initial equilibrium may have set lengths of ropes.
    result_.materials = find_bill(loaded_);
    const auto origins =
        formats::hdf5_image([&](formats::Tree& tree) { write_inputs(tree, loaded_, result_); });
    journal_.emplace(formats::SeriesJournal::create(part_path(), options_.identity, origins, layout_));
  }

  /// Restores the last output of a run that was killed after its last time step, when only the result file
  /// was missing.
  void recall_last_output() {
    describe_layout_of_killed(*from_);
    journal_->require_layout(layout_);
    recall(journal_->state(journal_->size() - 1).row);
  }

  /// Sets the numbers of the result to those of one output, a row of the journal.
  void recall(const std::vector<double>& row) {
    auto value = row.begin();
    for (auto& scalar : result_.scalars) scalar.value = *value++;
    for (const auto& name : energies_) result_.motion->energies[name] = *value++;
    result_.figures.clear();
    for (const auto& column : *gear_columns_)
      result_.figures.push_back({column.name.substr(kGear.size()), column.unit, column.doc, *value++});
  }

  /// Finds the layout of outputs by making an output at the point from which the run is resumed.
  void describe_layout_of_killed(const MarchState& from) {
    Assembler& assembler = scene_.assembler();
    MovingState state(assembler, 0);
    state.set(from.t, from.u, from.v, from.a);
    std::vector<double> residual(assembler.numbering().dofs());
    EnergyBudget budget(assembler, loaded_.analysis.dynamics.march.mass_damping);
    const bool keeps = loaded_.analysis.dynamics.march.budget;
    std::vector<WinchMoment> winches;
    for (const Winch& winch : loaded_.scene.winches) winches.push_back({winch.part});
    describe({from.t,
              from.u,
              state.x(),
              state.v(),
              {from.t, state.x(), residual, state.motion()},
              keeps ? &budget : nullptr,
              nullptr,
              winches});
  }

  formats::SeriesState describe(const Snapshot& at) {
    Assembler& assembler = scene_.assembler();
    Solution solution;
    solution.x.assign(at.x.begin(), at.x.end());
    solution.residual.assign(at.forces.residual.begin(), at.forces.residual.end());
    const Response& answer = answer_at(at.forces, solution.x);
    formats::SeriesState state;
    layout_.changing.clear();
    layout_.columns.clear();
    state.time = at.t;
    state.points = assembler.node_positions(solution.x);
    add_point_fields(at, solution, state);
    if (!fields_) fields_.emplace(loaded_, assembler);
    for (auto& cell : fields_->gather(answer.outputs)) {
      layout_.changing.push_back(cell.spec);
      state.fields.push_back(std::move(cell.values));
    }
    add_row(at, solution, answer.outputs, state);
    add_gear(at, answer, state);
    add_moment_of_forces(at, state);
    if (layout_.mesh.n_points == 0) {
      layout_.mesh = make_mesh(loaded_, assembler);
      layout_.fixed = label_points(loaded_);
      layout_.fixed.push_back(label_cells(loaded_, assembler));
      layout_.fixed.push_back(label_corners(loaded_, assembler));
    }
    return state;
  }

  /// Outputs of elements at the time of `forces`, with the positions x of an output. All outputs within one
  /// time step use the same forces, so that the elements are evaluated only once per step.
  const Response& answer_at(const ForceMoment& forces, std::span<const double> x) {
    if (!answered_at_ || *answered_at_ != forces.t) {
      answer_ = ask_elements(loaded_.scene, scene_.assembler(), forces.x, forces.motion, has_figures());
      answered_at_ = forces.t;
    }
    answer_.x.assign(x.begin(), x.end());
    return answer_;
  }

  /// Whether the forces of parts have to be summed: only figures of gears and bodies use them.
  bool has_figures() const { return loaded_.gear || !loaded_.scene.bodies.empty(); }

  void add_point_fields(const Snapshot& at, const Solution& solution, formats::SeriesState& state) {
    const Assembler& assembler = scene_.assembler();
    std::vector<double> displacement = state.points, reaction;
    for (std::size_t d = 0; d < displacement.size(); ++d) displacement[d] -= loaded_.scene.positions[d];
    for (std::uint32_t node = 0; node < loaded_.scene.node_count(); ++node) {
      const auto held = assembler.reaction(node, solution.residual);
      reaction.insert(reaction.end(), held.begin(), held.end());
    }
    layout_.changing = {
        {"displacement", "m", "movement from the sketch", formats::Location::kPoint, 3, false},
        {"velocity", "m/s", "velocity", formats::Location::kPoint, 3, false},
        {"reaction", "N", "force of the hold on the node", formats::Location::kPoint, 3, false}};
    state.fields = {displacement, assembler.node_positions(at.v), reaction};
    if (auto rotations = rotation_field(loaded_, assembler, solution.x)) {
      layout_.changing.push_back(rotations->first);
      state.fields.push_back(std::move(rotations->second));
    }
  }

  void add_row(const Snapshot& at, const Solution& solution, const FamilyOutputs& outputs,
               formats::SeriesState& state) {
    energies_.clear();
    result_.scalars = find_scalars(loaded_, scene_.assembler(), solution, outputs);
    for (auto& scalar : result_.scalars) {
      layout_.columns.push_back({scalar.name, scalar.unit, scalar.doc});
      state.row.push_back(scalar.value);
      scalar.doc += ", at the end";
    }
    if (!at.budget) return;
    const auto names = at.budget->names();
    const auto values = at.budget->values();
    for (std::size_t k = 0; k < names.size(); ++k) {
      layout_.columns.push_back({kEnergy + names[k], "J", "contribution to the energy budget"});
      state.row.push_back(values[k]);
      energies_.push_back(names[k]);
      result_.motion->energies[energies_.back()] = values[k];
    }
  }

  /// Adds the figures of the gear as columns of a series. The first output determines the columns; a figure
  /// that a later output lacks is NaN there.
  void add_gear(const Snapshot& at, const Response& answer, formats::SeriesState& state) {
    result_.figures = find_figures(loaded_, scene_.assembler(), answer);
    add_warp_figures(loaded_, scene_.assembler(), at, result_.figures);
    if (!gear_columns_)
      gear_columns_ = journal_ ? gear_columns_of(journal_->layout()) : columns_of(result_.figures);
    for (const formats::SeriesColumn& column : *gear_columns_) {
      const NamedScalar* figure = find_scalar(result_.figures, column.name.substr(kGear.size()));
      layout_.columns.push_back(column);
      state.row.push_back(figure ? figure->value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  static std::vector<formats::SeriesColumn> columns_of(const std::vector<NamedScalar>& figures) {
    std::vector<formats::SeriesColumn> columns;
    for (const auto& figure : figures) columns.push_back({kGear + figure.name, figure.unit, figure.doc});
    return columns;
  }
  static std::vector<formats::SeriesColumn> gear_columns_of(const formats::SeriesLayout& layout) {
    std::vector<formats::SeriesColumn> columns = layout.columns;
    std::erase_if(columns,
                  [](const formats::SeriesColumn& column) { return !column.name.starts_with(kGear); });
    return columns;
  }

  /// Adds the time to which the forces belong: an output between the ends of two steps has the forces at the
  /// end of a step.
  void add_moment_of_forces(const Snapshot& at, formats::SeriesState& state) {
    if (!loaded_.analysis.dynamics.march.dense) return;
    layout_.columns.push_back({"forces_time", "s", "end of the step to which forces and outputs belong"});
    state.row.push_back(at.forces.t);
  }

  /// Copies the outcome and the statistics of the time integration, and the warnings about boards, to the
  /// result.
  void note_march(const MarchResult& march) {
    Motion& m = *result_.motion;
    const scenes::Dynamics& d = loaded_.analysis.dynamics;
    result_.outcome = name_of(march.status);
    result_.sentence = march.reason;
    result_.statistics = march.statistics;
    for (const auto& fallen : watch_.findings().fallen) result_.warnings.push_back(fallen.sentence);
    m.integrator = d.integrator;
    m.start_from = d.from_equilibrium     ? "the equilibrium"
                   : d.start_file.empty() ? "the sketch"
                                          : d.start_file.filename().string();
    m.time = march.t;
    m.steps = march.steps;
    m.rejected = march.rejected;
    m.shortest = march.shortest;
    m.longest = march.longest;
    m.stable_step = march.stable_step;
    if (!march.start.node.empty()) m.start = march.start;
    if (march.accuracy.asked > 0) m.accuracy = march.accuracy;
    m.loss = watch_.findings().loss;
  }

  void finish(MarchResult& march) {
    result_.states = outputs_;
    result_.materials = find_bill(loaded_);
    add_loads(result_.figures, result_.materials);
    for (auto& warning : load_warnings(result_.materials)) result_.warnings.push_back(std::move(warning));
    journal_->set_status({result_.outcome, result_.sentence});
    if (march.status == MarchStatus::interrupted) {
      result_.path = part_path();
      return;
    }
    try {
      make_file();
    } catch (const formats::Interrupted&) {  // no output is lost: the journal has them all, and a resumed run
                                             // makes the file from it
      march.status = MarchStatus::interrupted;
      march.reason = "interrupted while the result was written";
      result_.outcome = name_of(march.status);
      result_.sentence = march.reason;
      journal_->set_status({result_.outcome, result_.sentence});
      result_.path = part_path();
    }
  }

  void make_file() {
    const auto name = name_beside_better(options_.output, result_.outcome);
    result_.path = name.string();
    result_.origins.finished = utc_now();
    formats::make_result(*journal_, name, [&](formats::Tree& tree) {
      formats::begin_result(tree, result_.outcome, result_.sentence);
      write_inputs(tree, loaded_, result_);
      write_ending(tree, result_);
    });
    write_xdmf(name);
    journal_->remove();
  }

  runs::PreparedScene& scene_;
  const scenes::LoadedScene& loaded_;
  const MotionOptions& options_;
  MotionWatch watch_;
  std::optional<OutputFields> fields_;
  formats::SeriesLayout layout_;
  std::optional<std::vector<formats::SeriesColumn>> gear_columns_;  // empty before the first output
  Response answer_;  // outputs and forces of elements at the time answered_at_ [s]
  std::optional<double> answered_at_;
  std::optional<MarchState> from_;
  std::optional<formats::SeriesJournal> journal_;
  // Number of outputs in the journal, and number of those that an earlier run wrote.
  std::size_t outputs_ = 0, outputs_before_ = 0;
  std::vector<std::string> energies_;  // names of the energies, in the order of their columns
  Result result_;
};

}  // namespace

MotionResult run_motion(runs::PreparedScene& scene, const RunContext& context, const MotionOptions& options) {
  return MotionRun(scene, context, options).run();
}

}  // namespace netloft::results
