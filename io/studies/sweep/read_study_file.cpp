// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/nearest.hpp"
#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/studies/sweep/study_file.hpp"
#include "io/studies/variables/read_variable.hpp"

#include <algorithm>
#include <map>

namespace netloft::studies {

namespace {

constexpr std::int64_t kMostSamples = 1'000'000;

/// Reads one study file. The member functions are the steps, in the order of execution.
class StudyReader {
 public:
  StudyReader(const formats::Value& root, formats::Diagnostics& diagnostics) : root_(root, diagnostics) {}

  StudyFile read() {
    read_scene();
    read_variables();
    read_design();
    read_path();
    read_figures();
    root_.finish();
    return std::move(study_);
  }

 private:
  void read_scene() {
    study_.scene = root_.text("scene", {.doc = "the scene that is varied, relative to this file"});
    study_.scene_place = root_.place("scene");
    study_.set = root_.texts(
        "set", {.doc = "values of all points, as --set takes them", .fallback = std::vector<std::string>{}});
    study_.set_place = root_.place("set");
  }

  void read_variables() {
    formats::TableReader variables =
        root_.table("variables", formats::Presence::required, "variables of the study, a table each");
    for (const std::string& name : variables.keys()) {
      const int errors = root_.diagnostics().errors();
      formats::TableReader table =
          variables.table(name, formats::Presence::required, "key, and values or range");
      DesignVariable read{read_variable(name, table), {}, false};
      check_name(read.variable);
      if (read.is_sampled())
        read.distribution = read_distribution(read.variable, table, {"uniform", "logarithmic", "normal"});
      read.is_sound = root_.diagnostics().errors() == errors;
      study_.variables.push_back(std::move(read));
    }
    if (root_.has("variables") && study_.variables.empty())
      root_.error("variables", "is empty: a study needs at least one variable", "such as [variables.speed]");
    refuse_shared_keys();
  }

  void check_name(const Variable& variable) {
    if (!is_variable_name(variable.name))
      root_.diagnostics().error(variable.place, "the name of a variable, " +
                                                    formats::in_quotes(variable.name) +
                                                    ", must consist of letters, digits, - and _");
  }

  void refuse_shared_keys() {
    std::map<std::string, std::string> owners;
    for (const auto& [variable, distribution, in_path, sound] : study_.variables)
      for (const FollowingKey& key : variable.keys) {
        const auto [owner, is_new] = owners.emplace(key.path, variable.name);
        if (!is_new)
          root_.diagnostics().error(variable.place, key.path + " is varied by " + owner->second + " already");
      }
  }

  void read_design() {
    formats::TableReader design =
        root_.table("design", formats::Presence::optional, "how values are combined");
    const std::string combine = design.choice(
        "combine", {.allowed = {"grid", "list"},
                    .doc = "how listed values are combined: all with all, or the first with the first",
                    .fallback = "grid"});
    study_.combination = combine == "list" ? Combination::list : Combination::grid;
    const std::string sampling = design.choice("sampling", {.allowed = {"latin-hypercube", "sobol"},
                                                            .doc = "how samples fill the ranges",
                                                            .fallback = "latin-hypercube"});
    study_.sampling = sampling == "sobol" ? Sampling::sobol : Sampling::latin_hypercube;
    const int errors = root_.diagnostics().errors();
    study_.samples = static_cast<std::size_t>(design.integer(
        "samples", {.doc = "number of samples from the ranges", .lo = 0, .hi = kMostSamples, .fallback = 0}));
    const bool samples_are_sound = root_.diagnostics().errors() == errors;
    study_.seed = static_cast<std::uint64_t>(design.integer(
        "seed",
        {.doc = "start of the random numbers: another seed gives other samples", .lo = 0, .fallback = 1}));
    if (samples_are_sound) check_samples(design);
    if (study_.combination == Combination::list) check_list();
  }

  void check_samples(formats::TableReader& design) {
    const bool some_are_sampled = std::any_of(study_.variables.begin(), study_.variables.end(),
                                              [](const auto& v) { return v.is_sampled(); });
    if (some_are_sampled && study_.samples == 0)
      root_.diagnostics().error(design.place(),
                                "design.samples is missing or zero: variables with a range are sampled",
                                "give [design] samples, such as 50");
    const bool all_are_sound = std::all_of(study_.variables.begin(), study_.variables.end(),
                                           [](const auto& v) { return v.is_sound; });
    if (!some_are_sampled && all_are_sound && study_.samples > 0)
      design.error("samples", "there is no variable with a range to sample from");
  }

  void check_list() {
    const DesignVariable* first = nullptr;
    for (const DesignVariable& v : study_.variables) {
      if (v.is_sampled()) continue;
      if (first && v.variable.values.size() != first->variable.values.size())
        root_.diagnostics().error(
            v.variable.place, v.variable.name + " has " + std::to_string(v.variable.values.size()) +
                                  " values, " + first->variable.name + " has " +
                                  std::to_string(first->variable.values.size()) +
                                  "; in a list, the first values go together, the second values, and so on");
      if (!first) first = &v;
    }
  }

  /// Reads the key `path`. Without it, all variables with listed numbers are in the path.
  void read_path() {
    if (!root_.has("path")) {
      for (DesignVariable& v : study_.variables) v.is_in_path = !v.is_sampled() && v.variable.is_number();
      return;
    }
    const auto names = root_.texts(
        "path", {.doc = "variables along which points are continued, the last one varies fastest"});
    std::vector<DesignVariable> ordered;
    for (const std::string& name : names) {
      const auto found = std::find_if(study_.variables.begin(), study_.variables.end(),
                                      [&](const auto& v) { return v.variable.name == name; });
      if (found == study_.variables.end()) {
        refuse_in_path(name);
        continue;
      }
      if (found->is_sampled())
        root_.error("path", name + " is sampled from a range; a path goes through listed values");
      if (found->is_in_path) root_.error("path", name + " is named twice");
      found->is_in_path = true;
      ordered.push_back(*found);
    }
    // Variables in the path are moved to the end, in the order of the path, because the last variables change
    // fastest.
    std::erase_if(study_.variables, [](const auto& v) { return v.is_in_path; });
    study_.variables.insert(study_.variables.end(), ordered.begin(), ordered.end());
  }

  void refuse_in_path(const std::string& name) {
    std::vector<std::string> known;
    for (const auto& v : study_.variables) known.push_back(v.variable.name);
    const auto near = nearest(name, known);
    root_.error("path", "there is no variable \"" + name + "\"",
                near ? "did you mean \"" + *near + "\"?" : "");
  }

  void read_figures() {
    study_.figures =
        root_.texts("figures", {.doc = "figures that are kept, such as gear/mouth/headline_height",
                                .fallback = std::vector<std::string>{}});
    const formats::Value* raw = root_.raw("figures");
    const formats::Array* array = raw ? raw->as<formats::Array>() : nullptr;
    for (std::size_t i = 0; array && i < array->items.size(); ++i)
      study_.figure_places.push_back(array->items[i].place);
  }

  formats::TableReader root_;
  StudyFile study_;
};

}  // namespace

StudyFile read_study_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::load(path, {}, diagnostics);
  if (diagnostics.errors()) return {};
  StudyFile study = StudyReader(document.root(), diagnostics).read();
  study.name = path.stem().string();
  if (const std::string fault = formats::name_fault(study.name); !fault.empty())
    diagnostics.error({0, 0, 0},
                      "the name of the file, " + formats::in_quotes(study.name) +
                          ", becomes the name of the study, and " + fault,
                      "rename the file");
  return study;
}

}  // namespace netloft::studies
