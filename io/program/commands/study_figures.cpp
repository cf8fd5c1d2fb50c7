// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/studies/sweep/study_plots.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

#include <optional>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;

studies::PlotRequest read_request(const StudyShowOptions& o) {
  studies::PlotRequest request{o.figures, o.over, o.by, {}};
  for (const std::string& word : o.at) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw UsageError{"--at " + word + ": write it as --at NAME=VALUE, such as --at depth=\"80 m\""};
    request.at[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return request;
}

}  // namespace

int study_show_command(const StudyShowOptions& o) {
  const fs::path folder = o.folder;
  const studies::Study study = read_study(folder);
  const fs::path page = o.output.empty() ? folder / (study.name + ".html") : fs::path(o.output);
  const std::string ending = page.extension().string();
  if (ending != ".html" && ending != ".svg")
    throw UsageError{"-o " + page.string() + ": plots can be written as .svg or .html only"};
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
  formats::write_keeping(page, ending == ".svg" ? formats::draw_svg(plots.front())
                                                : formats::draw_html("Study " + study.name, plots));
  print_answer(o, {{"output", page.string()}, {"plots", plots.size()}},
               fmt::format("{} written to {}", count_of(plots.size(), "plot"), page.string()));
  return kDone;
}

}  // namespace netloft::program
