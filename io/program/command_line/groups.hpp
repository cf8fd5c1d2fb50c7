// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

namespace netloft::program {

// solving.cpp
void add_run_command(CLI::App& app, Options& o);
void add_plan_command(CLI::App& app, Options& o);
void add_refine_command(CLI::App& app, Options& o);
void add_scope_command(CLI::App& app, Options& o);

// methods.cpp
void add_compare_command(CLI::App& app, Options& o);

// plugins.cpp
void add_component_commands(CLI::App& app, Options& o);  // list, describe, schema
void add_test_command(CLI::App& app, Options& o);
void add_author_commands(CLI::App& app, Options& o);  // new, reference, --cflags

// gears.cpp
void add_gear_commands(CLI::App& app, Options& o);  // catalogue, check, draw
void add_import_command(CLI::App& app, Options& o);

// results.cpp
void add_result_commands(CLI::App& app, Options& o);  // report, export, view
void add_diff_command(CLI::App& app, Options& o);

// studies.cpp
void add_study_command(CLI::App& app, Options& o);
void add_calibrate_command(CLI::App& app, Options& o);

}  // namespace netloft::program
