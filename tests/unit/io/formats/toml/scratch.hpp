// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/formats/toml/document.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "tests/folders.hpp"

namespace netloft::formats::test {

/// Gives each test a folder of its own, which is removed after the test.
class Scratch : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(netloft::test::build_folder()) / "scratch" /
              (std::string(info->test_suite_name()) + '.' + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  Document load(const std::string& name, const std::vector<std::string>& overrides = {}) {
    return Document::load(folder_ / name, overrides, diagnostics_);
  }
  /// The messages without the name of the test's folder.
  std::string errors() const {
    std::string text = diagnostics_.render(false);
    const std::string folder = folder_.lexically_normal().string() + '/';
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
  }

  std::filesystem::path folder_;
  Diagnostics diagnostics_;
};

/// A text in memory and a reader for its root.
struct Input {
  explicit Input(const std::string& text, const std::vector<std::string>& overrides = {})
      : document(Document::parse(text, "net.toml", overrides, diagnostics)),
        reader(document.root(), diagnostics) {}

  /// The first error or warning as "line:column: message"; "" if there is none.
  std::string error() const {
    const auto all = diagnostics.sorted();
    if (all.empty()) return {};
    return std::to_string(all[0].place.line) + ':' + std::to_string(all[0].place.column) + ": " +
           all[0].message;
  }
  std::string hint() const {
    const auto all = diagnostics.sorted();
    return all.empty() ? "" : all[0].hint;
  }

  Diagnostics diagnostics;
  Document document;
  TableReader reader;
};

}  // namespace netloft::formats::test
