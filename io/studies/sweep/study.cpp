// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace netloft::studies {

namespace {

using Chosen = std::vector<const DesignVariable*>;

/// The index of the chosen value of each variable.
using Choice = std::vector<std::size_t>;

Chosen listed(const StudyFile& file, bool in_path) {
  Chosen chosen;
  for (const DesignVariable& v : file.variables)
    if (!v.is_sampled() && v.is_in_path == in_path) chosen.push_back(&v);
  return chosen;
}

std::size_t count_of(const DesignVariable& v) { return v.variable.values.size(); }

std::size_t product_of(const Chosen& chosen) {
  return std::accumulate(chosen.begin(), chosen.end(), std::size_t{1},
                         [](std::size_t n, const DesignVariable* v) { return n * count_of(*v); });
}

/// All combinations of the values of `chosen`; the last variable changes fastest. If `to_and_fro`, a variable
/// runs backwards on every other pass, so that neighbouring combinations differ in one value only.
std::vector<Choice> all_with_all(const Chosen& chosen, bool to_and_fro) {
  std::vector<Choice> all(product_of(chosen), Choice(chosen.size()));
  std::size_t below = 1;  // number of combinations of the later variables
  for (std::size_t v = chosen.size(); v-- > 0;) {
    const std::size_t n = count_of(*chosen[v]);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t step = k / below % n, turn = k / (below * n);
      all[k][v] = to_and_fro && turn % 2 == 1 ? n - 1 - step : step;
    }
    below *= n;
  }
  return all;
}

/// The listed values of an item outside the path, and those of its points in the path, as choices.
struct Combined {
  Choice item;
  std::vector<Choice> points;
};

std::vector<Combined> combine_grid(const Chosen& of_items, const Chosen& of_path) {
  const auto points = all_with_all(of_path, true);
  std::vector<Combined> all;
  for (Choice& item : all_with_all(of_items, false)) all.push_back({std::move(item), points});
  return all;
}

/// Combines the listed values of variables row by row: the first value of each variable, then the second of
/// each, and so on. Rows with equal values outside the path are points of one item.
std::vector<Combined> combine_list(const Chosen& of_items, const Chosen& of_path) {
  const Chosen& any = of_items.empty() ? of_path : of_items;
  std::vector<Combined> all;
  for (std::size_t row = 0; row < (any.empty() ? 1 : count_of(*any[0])); ++row) {
    const Choice item(of_items.size(), row), point(of_path.size(), row);
    const auto is_same = [&](const Combined& c) {
      for (std::size_t v = 0; v < item.size(); ++v)
        if (of_items[v]->variable.values[c.item[v]].text != of_items[v]->variable.values[row].text)
          return false;
      return true;
    };
    auto found = of_path.empty() ? all.end() : std::find_if(all.begin(), all.end(), is_same);
    if (found == all.end()) found = all.insert(all.end(), Combined{item, {}});
    found->points.push_back(point);
  }
  return all;
}

template <class Target>
void put(const Variable& variable, const VariableValue& value, Target& target) {
  for (auto& word : variable.overrides(value)) target.set.push_back(std::move(word));
  target.values.push_back(value);
}

/// Makes the items. The member functions are the steps, in the order of execution.
class Maker {
 public:
  Maker(const StudyFile& file, Study& study)
      : file_(file), study_(study), of_items_(listed(file, false)), of_path_(listed(file, true)) {
    for (const DesignVariable& v : file.variables)
      if (v.is_sampled()) sampled_.push_back(&v);
  }

  void make() {
    add_columns(of_items_, false);
    add_columns(sampled_, false);
    add_columns(of_path_, true);
    const auto samples = unit_points(file_.sampling, file_.samples, sampled_.size(), file_.seed);
    const auto combined = file_.combination == Combination::grid ? combine_grid(of_items_, of_path_)
                                                                 : combine_list(of_items_, of_path_);
    for (const Combined& one : combined) {
      if (sampled_.empty()) add_item(one, 0, {});
      for (std::size_t d = 0; d < samples.size() && !sampled_.empty(); ++d) add_item(one, d + 1, samples[d]);
    }
  }

 private:
  void add_columns(const Chosen& chosen, bool in_path) {
    for (const auto* v : chosen) {
      Variable variable = v->variable;
      variable.values.clear();
      variable.interval.reset();
      study_.columns.push_back({std::move(variable), v->variable.is_number(), in_path, v->is_sampled()});
    }
  }

  void add_item(const Combined& combined, std::size_t sample, const std::vector<double>& p) {
    StudyItem item;
    item.id = study_.items.size() + 1;
    item.sample = sample;
    for (std::size_t v = 0; v < of_items_.size(); ++v) {
      const Variable& variable = of_items_[v]->variable;
      put(variable, variable.values[combined.item[v]], item);
    }
    for (std::size_t v = 0; v < p.size(); ++v) {
      const auto& [variable, distribution, in_path, sound] = *sampled_[v];
      put(variable, variable.value_of(quantile(distribution, *variable.interval, p[v])), item);
    }
    for (const Choice& choice : combined.points) {
      StudyPoint& point = item.points.emplace_back();
      for (std::size_t v = 0; v < of_path_.size(); ++v)
        put(of_path_[v]->variable, of_path_[v]->variable.values[choice[v]], point);
    }
    item.hash = hash_of(study_, item);
    study_.items.push_back(std::move(item));
  }

  const StudyFile& file_;
  Study& study_;
  Chosen of_items_, of_path_, sampled_;
};

}  // namespace

std::size_t Study::point_count() const {
  return std::accumulate(items.begin(), items.end(), std::size_t{0},
                         [](std::size_t n, const StudyItem& item) { return n + item.points.size(); });
}

std::vector<VariableValue> Study::values_of(const StudyItem& item, const StudyPoint& point) const {
  std::vector<VariableValue> values = item.values;
  values.insert(values.end(), point.values.begin(), point.values.end());
  assert(values.size() == columns.size());
  return values;
}

double count_points(const StudyFile& file) {
  double points = file.samples > 0 ? static_cast<double>(file.samples) : 1;
  for (const DesignVariable& v : file.variables) {
    if (v.is_sampled()) continue;
    points *= static_cast<double>(count_of(v));
    if (file.combination == Combination::list) break;  // all listed variables have the same number of values
  }
  return points;
}

Study make_study(const StudyFile& file, const std::string& scene,
                 std::vector<std::pair<std::string, std::string>> files) {
  assert(count_points(file) <= kMostPoints);
  Study study;
  study.name = file.name;
  study.scene = scene;
  study.set = file.set;
  study.figures = file.figures;
  study.files = std::move(files);
  if (file.samples > 0) {
    study.sampling = file.sampling == Sampling::sobol ? "sobol" : "latin-hypercube";
    study.seed = file.seed;
  }
  Maker(file, study).make();
  return study;
}

std::string hash_of(const Study& study, const StudyItem& item) {
  std::string all = "netloft study 1";
  const auto add = [&](const std::vector<std::string>& words, const char* what) {
    all += std::string("\n") + what;
    for (const std::string& word : words) all += "\n  " + word;
  };
  for (const auto& [path, hash] : study.files) all += "\nfile " + hash;
  add(study.figures, "figures");
  add(study.set, "set");
  add(item.set, "item");
  for (const StudyPoint& point : item.points) add(point.set, "point");
  return formats::fnv1a64(all);
}

}  // namespace netloft::studies
