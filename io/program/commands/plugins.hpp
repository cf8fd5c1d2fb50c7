// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

namespace netloft::program {

struct DescribeOptions : PluginOptions {
  std::string type;  // TYPE
};

struct TestOptions : PluginOptions {
  std::string plugin;  // PLUGIN
  bool verbose = false;
  double seconds = 60;  // --seconds. All checks of the largest shipped plugin take 1 s
};

struct NewOptions {
  std::string kind, name;  // KIND NAME
};

int list_command(const PluginOptions& options);        // all components
int describe_command(const DescribeOptions& options);  // one component
int schema_command(const PluginOptions& options);      // JSON schema of scenes
int test_command(const TestOptions& options);          // conformance of a plugin
int new_command(const NewOptions& options);            // a plugin to begin with

}  // namespace netloft::program
