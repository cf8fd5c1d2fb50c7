// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/program/session/options.hpp"

namespace netloft::program {

/// Folders in the order of search: --plugins, the scene's if asked for, NETLOFT_PLUGINS, the installed one.
void find_plugins(const Options& options, Registry& registry);

int run_command(const Options& options);        // solve a scene
int plan_command(const Options& options);       // say what a scene needs
int list_command(const Options& options);       // components there are
int describe_command(const Options& options);   // one component
int schema_command(const Options& options);     // JSON schema of scenes
int test_command(const Options& options);       // conformance of a plugin
int compare_command(const Options& options);    // speed against error of solvers
int diff_command(const Options& options);       // what changed between two results
int refine_command(const Options& options);     // what a scene reports on finer and finer meshes
int scope_command(const Options& options);      // lengths of warp for depths
int calibrate_command(const Options& options);  // parameters of scenes out of measurements
int study_command(const Options& options);      // many solves of one scene, varied
int new_command(const Options& options);        // write a plugin to begin with
int catalogue_command(const Options& options);  // parts of the catalogue
int check_command(const Options& options);      // whether a net plan can be sewn
int draw_command(const Options& options);       // a net plan or a result as a picture
int draw_result_command(const Options& options);
int report_command(const Options& options);  // the report of a result again
int export_command(const Options& options);  // a result for other programs
int import_command(const Options& options);  // a gear of another program as a scene
int view_command(const Options& options);    // results as a page

}  // namespace netloft::program
