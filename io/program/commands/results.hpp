// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <cstddef>

namespace netloft::program {

struct ReportOptions : CommonOptions {
  std::string result;  // argument RESULT.hdf
  bool csv = false;    // option --csv
  std::string output;  // option -o
};

struct ExportOptions : CommonOptions {
  std::string result;           // argument RESULT.hdf
  std::string output;           // argument FILE
  std::string table = "nodes";  // option --table
  std::string field;            // option --field
  int state = -1;               // option --state; -1: the newest
};

struct ViewOptions : CommonOptions {
  std::vector<std::string> results;  // argument RESULT.hdf
  std::string output;                // option -o
  std::size_t states = 100;          // option --states
};

struct DiffOptions : CommonOptions {
  std::string before, after;  // arguments RESULT.hdf
  bool all = false;           // option --all
};

int report_command(const ReportOptions& options);  // reports an existing result
int export_command(const ExportOptions& options);  // exports a result for other programs
int view_command(const ViewOptions& options);      // shows results on a page
int diff_command(const DiffOptions& options);      // lists the differences between two results

}  // namespace netloft::program
