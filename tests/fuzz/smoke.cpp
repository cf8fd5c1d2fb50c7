// SPDX-License-Identifier: BSD-3-Clause
// A fuzzer without libFuzzer, which runs for every commit: it tries each named file and each file in a named
// folder, then a fixed number of random changes of these files, which are the same every time. A fault shows
// as a crash, mostly in builds with sanitizers.
//
//   NAME_smoke COUNT[:SEED] FILE-OR-FOLDER…
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

constexpr std::size_t kLongest = 8192;

void read_file(const fs::path& path, std::vector<Input>& to) {
  std::ifstream in(path, std::ios::binary);
  to.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::vector<Input> read_seeds(int argc, char** argv) {
  std::vector<fs::path> files;
  for (int i = 2; i < argc; ++i)
    if (fs::is_directory(argv[i]))
      for (const auto& entry : fs::directory_iterator(argv[i])) files.push_back(entry.path());
    else
      files.emplace_back(argv[i]);
  std::sort(files.begin(), files.end());
  std::vector<Input> seeds;
  for (const auto& file : files)
    if (fs::is_regular_file(file)) read_file(file, seeds);
  return seeds;
}

/// Changes one place of an input: changes a byte, removes a piece, or inserts a piece of another input.
void change(Input& input, const std::vector<Input>& seeds, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t at = below(input.size() + 1), length = 1 + below(24);
  const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
  switch (random() % 3) {
    case 0:
      if (at < input.size()) input[at] = static_cast<std::uint8_t>(random());
      return;
    case 1:
      input.erase(place, place + static_cast<std::ptrdiff_t>(std::min(length, input.size() - at)));
      return;
    default: {
      const Input& from = seeds[below(seeds.size())];
      const std::size_t begin = below(from.size()), end = std::min(from.size(), begin + length);
      input.insert(place, from.begin() + static_cast<std::ptrdiff_t>(begin),
                   from.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const long count = argc > 2 ? std::atol(argv[1]) : 0;
  const auto seeds = argc > 2 ? read_seeds(argc, argv) : std::vector<Input>{};
  if (count <= 0 || seeds.empty())
    return std::fputs("usage: NAME_smoke COUNT[:SEED] FILE-OR-FOLDER…, one of which is a file\n", stderr), 2;
  for (const Input& seed : seeds) LLVMFuzzerTestOneInput(seed.data(), seed.size());
  const char* seed = std::strchr(argv[1], ':');
  std::mt19937 random(seed ? static_cast<unsigned>(std::atol(seed + 1)) : 1);
  for (long i = 0; i < count; ++i) {
    Input input = seeds[random() % seeds.size()];
    for (auto n = 1 + random() % 6; n > 0; --n) change(input, seeds, random);
    input.resize(std::min(input.size(), kLongest));
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%zu seeds and %ld changes of them\n", seeds.size(), count);
  return 0;
}
