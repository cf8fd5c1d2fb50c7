// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace netloft::gears {

/// A folder for one test, which is removed after the test.
class TestFolder {
 public:
  TestFolder() : path_(std::filesystem::temp_directory_path() / unique_name()) {
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }

  TestFolder& write(const std::string& name, const std::string& text) {
    std::ofstream(path_ / name) << text;
    return *this;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  static std::string unique_name() {
    static int count = 0;
    return "netloft-catalogue-" + std::to_string(getpid()) + "-" + std::to_string(++count);
  }
  std::filesystem::path path_;
};

inline constexpr const char* kTwine = R"(
[twine.thin]
diameter = "2 mm"
EA = "4 kN"
mass = "1.8 g/m"
material_density = 960
source = "a scale"
uncertainty = "1 %"
)";

}  // namespace netloft::gears
