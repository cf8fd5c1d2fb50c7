// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/units/units.hpp"
#include "io/program/commands/study_run.hpp"
#include "io/program/commands/study_text.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/prefix.hpp"
#include "io/program/session/session.hpp"
#include "io/studies/sweep/check_study.hpp"
#include "io/studies/sweep/engine_script.hpp"
#include "io/studies/sweep/estimate.hpp"
#include "io/studies/sweep/figure_indices.hpp"
#include "io/studies/sweep/study_plots.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

studies::Study read_study(const fs::path& folder) {
  try {
    return studies::read_manifest(studies::manifest_path(folder));
  } catch (const studies::StudyError& e) {
    throw UsageError{e.what()};
  }
}

// ---- plan

/// The folder of a study: that of -o, or one with the name of the study file in this folder.
fs::path folder_for(const Options& o) {
  return fs::path(o.output.empty() ? fs::path(o.target).stem().string() + ".study" : o.output);
}

/// A path as seen from the folder of a study, so that both can be moved together.
std::string seen_from(const fs::path& folder, const fs::path& path) {
  const fs::path from = fs::weakly_canonical(fs::absolute(folder)),
                 to = fs::weakly_canonical(fs::absolute(path));
  return to.lexically_relative(from).generic_string();
}

void check_size(const studies::StudyFile& file, formats::Diagnostics& diagnostics) {
  if (const double points = studies::count_points(file); points > studies::kMostPoints)
    diagnostics.error(
        {0, 0, 0},
        fmt::format("the design has {:.3g} points; {:.3g} are the most", points, studies::kMostPoints),
        "fewer values, fewer samples, or combine = \"list\"");
}

/// Makes the folder, the manifest last: who reads it finds the rest.
void write_study(const fs::path& folder, const studies::Study& study) {
  std::error_code error;
  fs::create_directories(folder / "items", error);
  if (error) throw formats::WriteError((folder / "items").string() + " cannot be made: " + error.message());
  formats::write_whole(studies::manifest_path(folder), studies::manifest_text(study));
}

std::size_t count_computed(const studies::Study& study, const fs::path& folder) {
  std::string unused;
  return static_cast<std::size_t>(
      std::count_if(study.items.begin(), study.items.end(), [&](const studies::StudyItem& item) {
        return studies::find_record(folder, item, unused).has_value();
      }));
}

void say_plan(const Options& o, const studies::Study& study, const fs::path& folder) {
  const std::size_t before = count_computed(study, folder);
  const Json json = {{"folder", folder.string()},
                     {"items", study.items.size()},
                     {"points", study.point_count()},
                     {"computed_before", before}};
  std::string text = fmt::format("{}: {}, {} in all\n", study.name, count_of(study.items.size(), "item"),
                                 count_of(study.point_count(), "point"));
  for (const studies::StudyColumn& c : study.columns)
    text += fmt::format("  {}{}\n", c.variable.name, c.is_in_path ? ", along the path of every item" : "");
  if (before) text += fmt::format("  {} computed before\n", count_of(before, "item"));
  text +=
      fmt::format("  written to {}; `netloft study run {}` computes them", folder.string(), folder.string());
  print_answer(o, json, text);
}

int plan_study(const Options& o) {
  Terminal terminal(o.color, o.json);
  formats::Diagnostics diagnostics;
  const studies::StudyFile file = studies::read_study_file(o.target, diagnostics);
  Registry registry;
  find_plugins(o, registry);
  studies::CheckedScenes scenes;
  const fs::path at = fs::path(o.target).parent_path();
  if (!diagnostics.errors()) check_size(file, diagnostics);
  if (!file.scene.empty()) scenes = studies::check_scenes(file, at, registry, diagnostics);
  if (diagnostics.errors())
    return tell_why_not(
        diagnostics,
        scenes.refused ? runs::PreparedScene::State::refused : runs::PreparedScene::State::wrong_input, o,
        terminal);
  if (diagnostics.warnings()) terminal.say(diagnostics.render(terminal.color()));
  const fs::path folder = folder_for(o);
  for (auto& [path, hash] : scenes.files) path = seen_from(folder, path);
  const studies::Study study =
      studies::make_study(file, seen_from(folder, at / file.scene), std::move(scenes.files));
  write_study(folder, study);
  say_plan(o, study, folder);
  return kDone;
}

// ---- run

/// A sentence about a file that is no longer what it was when the study was planned; empty if there is none.
std::string what_changed(const studies::Study& study, const fs::path& folder) {
  for (const auto& [path, hash] : study.files)
    if (const auto text = formats::read_whole(folder / path); text && formats::fnv1a64(*text) != hash)
      return path + " has changed since the study was planned";
  return {};
}

int run_planned(const Options& o) {
  catch_interrupts();
  const studies::Study study = read_study(o.target);
  if (const std::string changed = what_changed(study, o.target); !changed.empty())
    throw studies::StudyError(changed + "; plan it again");
  return run_study(o, study);
}

// ---- engines

/// The numbers of items without a record, one a line.
int list_missing(const Options& o) {
  const studies::Study study = read_study(o.target);
  std::string fault;
  for (const studies::StudyItem& item : study.items)
    if (!studies::find_record(o.target, item, fault)) std::printf("%zu\n", item.id);
  return kDone;
}

std::string why_chunk(const Options& o, std::size_t chunk, double seconds) {
  if (o.study.chunk > 0) return fmt::format("--chunk said so ({} a task)", count_of(chunk, "item"));
  if (seconds == 0)
    return "No item has been computed that would tell how many fill a minute: `netloft study run FOLDER "
           "--items 1` first, or --chunk N.";
  return fmt::format(
      "An item has taken {:.3g} s on average, so that a task takes a minute or more, or is the only one.",
      seconds);
}

int write_script(const Options& o) {
  const fs::path folder = o.target;
  const studies::Study study = read_study(folder);
  const studies::Engine engine =
      o.study.engine == "slurm" ? studies::Engine::slurm : studies::Engine::parallel;
  if (engine == studies::Engine::slurm)
    refuse_idle(o, {"--jobs"}, "Slurm has its own limits of tasks");
  else
    refuse_idle(o, {"--chunk"}, "parallel starts a program for every item");
  double seconds = 0;
  studies::ScriptOptions script{(installed_prefix() / "bin" / "netloft").string(), o.plugins, 1, "",
                                o.study.jobs};
  script.chunk = studies::items_per_minute(study, folder, seconds);
  if (o.study.chunk > 0) script.chunk = std::min(static_cast<std::size_t>(o.study.chunk), study.items.size());
  script.why_chunk = why_chunk(o, script.chunk, seconds);
  const fs::path path = folder / studies::script_name(engine);
  formats::write_whole(path, studies::engine_script(engine, study, script));
  const std::string start = engine == studies::Engine::slurm ? "sbatch --wait slurm.sh" : "bash parallel.sh";
  print_answer(
      o, {{"script", path.string()}, {"items_per_task", engine == studies::Engine::slurm ? script.chunk : 1}},
      fmt::format("written to {}; in that folder `{}` computes the study", path.string(), start));
  return kDone;
}

// ---- collect

int collect_study(const Options& o) {
  Terminal terminal(o.color, o.json);
  const fs::path folder = o.target;
  const studies::Study study = read_study(folder);
  const studies::StudyTable table = studies::collect_table(study, folder);
  formats::write_whole(folder / "table.csv", studies::study_csv(table));
  formats::write_whole(folder / "table.hdf", studies::study_hdf5(study, table));
  formats::write_whole(folder / "costs.csv", studies::costs_csv(study, folder));
  if (const std::string changed = what_changed(study, folder); !changed.empty())
    terminal.say("netloft: " + changed + "; the table is of what was planned");
  for (const std::string& sentence : table.sentences) terminal.say("netloft: " + sentence);
  const auto counts = table.count_by_status();
  std::string text = fmt::format("{}: {}", study.name, count_of(table.rows.size(), "point"));
  for (const auto& [status, count] : counts) text += fmt::format(", {} {}", count, status);
  text += fmt::format("\n  written to {}", (folder / "table.csv").string() + ", table.hdf and costs.csv");
  print_answer(o,
               {{"points", table.rows.size()},
                {"by_status", counts},
                {"missing_items", table.missing_items},
                {"sentences", table.sentences}},
               text);
  if (table.missing_items) return kOther;
  return counts.size() == 1 && counts.contains("converged") ? kDone : kNotConverged;
}

// ---- show

studies::PlotRequest read_request(const Options& o) {
  studies::PlotRequest request{o.study.figures, o.study.over, o.study.by, {}};
  for (const std::string& word : o.study.at) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw UsageError{"--at " + word + ": write it as --at NAME=VALUE, such as --at depth=\"80 m\""};
    request.at[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return request;
}

int show_study(const Options& o) {
  const fs::path folder = o.target;
  const studies::Study study = read_study(folder);
  const fs::path page = o.output.empty() ? folder / (study.name + ".html") : fs::path(o.output);
  const std::string ending = page.extension().string();
  if (ending != ".html" && ending != ".svg")
    throw UsageError{"-o " + page.string() + ": plots are drawn as .svg or .html"};
  std::vector<formats::LinePlot> plots;
  try {
    plots = studies::plots_of(studies::collect_table(study, folder), read_request(o));
  } catch (const studies::StudyError& e) {
    throw UsageError{e.what()};
  }
  if (ending == ".svg" && plots.size() > 1)
    throw UsageError{fmt::format(
        "-o {}: a picture has one plot, and {} figures vary; name one with --figure, or write .html",
        page.string(), plots.size())};
  formats::write_whole(page, ending == ".svg" ? formats::draw_svg(plots.front())
                                              : formats::draw_html("Study " + study.name, plots));
  print_answer(o, {{"output", page.string()}, {"plots", plots.size()}},
               fmt::format("{} written to {}", count_of(plots.size(), "plot"), page.string()));
  return kDone;
}

// ---- estimate

int estimate_study(const Options& o) {
  Terminal terminal(o.color, o.json);
  const studies::Study study = read_study(o.target);
  formats::Diagnostics diagnostics;
  std::optional<studies::StudyEstimate> found;
  try {
    found = studies::estimate(studies::collect_table(study, o.target), {o.study.at, o.study.figures},
                              diagnostics);
  } catch (const studies::StudyError& e) {
    throw UsageError{e.what()};
  }
  if (!found) return tell_why_not(diagnostics, runs::PreparedScene::State::wrong_input, o, terminal);
  if (const std::string changed = what_changed(study, o.target); !changed.empty())
    terminal.say("netloft: " + changed + "; estimates are of what was planned");
  std::puts((o.json ? studies::estimate_json(study.name, *found) : studies::estimate_text(study.name, *found))
                .c_str());
  return kDone;
}

// ---- sobol

/// A picture is for a page.
constexpr std::size_t kMostBarGroups = 12;

void write_bars(const Options& o, const studies::StudyIndices& found) {
  const formats::BarChart bars = studies::indices_bars(found);
  if (bars.groups.empty()) throw UsageError{"-o " + o.output + ": there is nothing to draw"};
  if (bars.groups.size() > kMostBarGroups)
    throw UsageError{
        fmt::format("-o {}: {} figures do not fit on one picture, {} do; name them with --figure", o.output,
                    bars.groups.size(), kMostBarGroups)};
  formats::write_whole(o.output, formats::draw_svg(bars));
}

int print_indices(const Options& o) {
  Terminal terminal(o.color, o.json);
  const studies::Study study = read_study(o.target);
  if (!o.output.empty() && fs::path(o.output).extension() != ".svg")
    throw UsageError{"-o " + o.output + ": bars are drawn as .svg"};
  formats::Diagnostics diagnostics;
  std::optional<studies::StudyIndices> found;
  try {
    found = studies::study_indices(studies::collect_table(study, o.target), {o.study.at, o.study.figures},
                                   diagnostics);
  } catch (const studies::StudyError& e) {
    throw UsageError{e.what()};
  }
  if (!found) return tell_why_not(diagnostics, runs::PreparedScene::State::wrong_input, o, terminal);
  if (!o.output.empty()) write_bars(o, *found);
  if (const std::string changed = what_changed(study, o.target); !changed.empty())
    terminal.say("netloft: " + changed + "; indices are of what was planned");
  std::puts((o.json ? studies::indices_json(study.name, *found) : studies::indices_text(study.name, *found))
                .c_str());
  return kDone;
}

}  // namespace

int study_command(const Options& o) {
  if (o.study.action == "plan") return plan_study(o);
  if (o.study.action == "run") return run_planned(o);
  if (o.study.action == "missing") return list_missing(o);
  if (o.study.action == "show") return show_study(o);
  if (o.study.action == "estimate") return estimate_study(o);
  if (o.study.action == "sobol") return print_indices(o);
  if (o.study.action == "submit") return write_script(o);
  return collect_study(o);
}

}  // namespace netloft::program
