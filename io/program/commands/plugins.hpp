// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

namespace netloft::program {

struct DescribeOptions : PluginOptions {
  std::string type;  // argument TYPE
};

struct TestOptions : PluginOptions {
  std::string plugin;  // argument PLUGIN
  bool verbose = false;
  double seconds = 60;  // option --seconds. All checks of the largest built-in plugin take 1 s
};

struct NewOptions {
  std::string kind, name;  // arguments KIND NAME
  std::string output;      // option -o
};

int list_command(const PluginOptions& options);        // lists all components
int describe_command(const DescribeOptions& options);  // describes one component
int schema_command(const PluginOptions& options);      // prints the JSON schema of scenes
int test_command(const TestOptions& options);          // checks the conformance of a plugin
int new_command(const NewOptions& options);            // creates a plugin or a gear from a template

}  // namespace netloft::program
