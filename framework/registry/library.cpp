// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/library.hpp"

#include "framework/registry/elf_length.hpp"
#include "framework/registry/floating_point_mode.hpp"
#include "framework/registry/trial_opening.hpp"

#include <dlfcn.h>

#include <array>
#include <fstream>
#include <mutex>

namespace netloft {

namespace {

/// Restores the floating-point mode when it is destroyed, and reports whether the mode has changed.
class FloatingPointGuard {
 public:
  FloatingPointGuard() = default;
  ~FloatingPointGuard() {
    if (changed()) before_.set();
  }
  FloatingPointGuard(const FloatingPointGuard&) = delete;
  FloatingPointGuard& operator=(const FloatingPointGuard&) = delete;
  bool changed() const { return FloatingPointMode::now() != before_; }

 private:
  const FloatingPointMode before_ = FloatingPointMode::now();
};

/// Returns the FNV-1a hash of 64 bits over words of eight bytes, padded with zeros. A hash over single bytes
/// took a twentieth of the time of a short run.
std::string fingerprint(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 14695981039346656037ull;
  std::array<std::uint64_t, 1 << 13> words;
  do {
    words.fill(0);
    in.read(reinterpret_cast<char*>(words.data()), sizeof words);
    const auto read = static_cast<std::size_t>(in.gcount());
    for (std::size_t i = 0; sizeof(std::uint64_t) * i < read; ++i)
      hash = (hash ^ words[i]) * 1099511628211ull;
  } while (in);
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

namespace {

/// Files that changed the floating-point mode when they were opened. Their start-up code runs only once, so
/// that a second attempt would not notice the change. The list is global because a program has only one
/// loader.
class Changers {
 public:
  void add(const std::string& file) {
    const std::lock_guard lock(mutex_);
    files_.insert(file);
  }
  bool holds(const std::string& file) {
    const std::lock_guard lock(mutex_);
    return files_.count(file) > 0;
  }

 private:
  std::mutex mutex_;
  std::set<std::string> files_;
};

void* open_guarded(const std::filesystem::path& file) {
  static Changers changers;
  FloatingPointGuard guard;
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle) throw PluginRefused(file.string() + ": cannot open the plugin: " + dlerror());
  if (guard.changed()) changers.add(file.string());
  if (changers.holds(file.string()))
    throw PluginRefused(file.string() +
                        ": opening it changed the floating-point mode of the program "
                        "(linked with -ffast-math); build it without");
  return handle;
}

/// A plugin that throws instead of describing itself is treated like one that returns nullptr.
const netloft_plugin* described_by(void* symbol) {
  try {
    return reinterpret_cast<netloft_plugin_function>(symbol)();
  } catch (...) {
    return nullptr;
  }
}

/// Returns the folders that may contain a build for this processor: first the subfolders for x86-64 levels,
/// the newest level first, then the folder itself.
std::vector<std::filesystem::path> folders_of_builds(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> folders;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
    folders.push_back(folder / "x86-64-v3");
#endif
  folders.push_back(folder);
  return folders;
}

}  // namespace

PluginContent open_library(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    throw PluginRefused(file.string() + ": is no file that can be opened");
  if (!is_whole(file))
    throw PluginRefused(
        file.string() +
        ": is not complete: it ends before the place that its own header states. Copy or build it again");
  if (const std::string fault = fault_on_trial(file); !fault.empty())
    throw PluginRefused(file.string() + ": " + fault);
  void* handle = open_guarded(file);
  void* symbol = dlsym(handle, "netloft_plugin_v1");
  if (!symbol)
    throw PluginRefused(file.string() +
                        ": is no Netloft plugin, or one for another major version of the interface "
                        "(it does not export netloft_plugin_v1)");
  FloatingPointGuard guard;
  PluginContent content = read_plugin(described_by(symbol), file.string(), file.stem().string());
  if (guard.changed())
    throw PluginRefused(file.string() +
                        ": the floating-point mode of the program changed while it described itself");
  content.origin.fingerprint = fingerprint(file);
  return content;
}

std::filesystem::path best_build(const std::filesystem::path& folder, const std::string& name) {
  for (const auto& below : folders_of_builds(folder))
    if (std::filesystem::is_regular_file(below / (name + ".so"))) return below / (name + ".so");
  return {};
}

std::set<std::string> names_of_builds(const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::error_code none;
  for (const auto& below : folders_of_builds(folder))
    for (const auto& entry : std::filesystem::directory_iterator(below, none))
      if (entry.path().extension() == ".so") names.insert(entry.path().stem().string());
  return names;
}

}  // namespace netloft
