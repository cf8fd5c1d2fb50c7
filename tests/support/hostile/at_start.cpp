// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin that does harm as soon as it is opened or described. CMakeLists.txt builds one plugin for every
// HARM.
#include <netloft/ext/laws.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#define TEXT(name) #name
#define TEXT_OF(name) TEXT(name)

namespace {

bool has(const char* harm) { return std::strcmp(harm, TEXT_OF(HARM)) == 0; }

void* volatile kept;

__attribute__((constructor)) void start_up() {
  if (has("exits_at_once")) std::exit(0);
  // An earlier version of the program mistook this exit code of the trial process for success.
  if (has("ends_with_any_code")) _exit(77);
  while (has("eats_memory")) {
    constexpr std::size_t kPiece = std::size_t{1} << 24;
    kept = ::operator new(kPiece);
    std::memset(kept, 1, kPiece);
  }
}

int evaluate(const void*, const netloft_law_tile*) { return NETLOFT_OK; }

}  // namespace

extern "C" NETLOFT_EXPORT const netloft_plugin* netloft_plugin_v1(void) {
  static const char* words[] = {"first", "second", nullptr};
  // A wild pointer to a text that only `describe` reads.
  if (has("wild_word")) words[1] = reinterpret_cast<const char*>(std::uintptr_t{0x1230});
  static netloft_parameter choice{};
  choice.size = sizeof choice, choice.kind = NETLOFT_CHOICE, choice.name = "word", choice.unit = "1";
  choice.doc = "one of two", choice.choices = words, choice.hi = 1;
  static netloft_law law{};
  law.size = sizeof law, law.kind = NETLOFT_TWINE_LAW, law.name = "law", law.doc = "nothing";
  law.parameter_bytes = 8, law.parameter_count = 1, law.parameters = &choice, law.evaluate = evaluate;
  static netloft_plugin plugin{};
  plugin.size = sizeof plugin, plugin.abi_major = NETLOFT_ABI_MAJOR, plugin.abi_minor = NETLOFT_ABI_MINOR;
  plugin.name = TEXT_OF(HARM), plugin.version = "1", plugin.doc = "harm", plugin.compiler = "";
  static const netloft_laws list{sizeof list, 1, &law};
  plugin.extension = [](const char* id) -> const void* {
    return std::strcmp(id, NETLOFT_EXT_LAWS) == 0 ? &list : nullptr;
  };
  return &plugin;
}
