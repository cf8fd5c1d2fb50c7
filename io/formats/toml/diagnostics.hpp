// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace netloft::formats {

/// The place of a text in an input. Lines and columns count from 1, columns in characters.
struct Place {
  int file = -1;  // index from Diagnostics::add_source; -1: no file
  int line = 0;   // 0: the file as a whole
  int column = 0;
  int length = 1;  // characters to underline, never beyond the line
  bool operator==(const Place&) const = default;
};

enum class Severity { error, warning };

/// A proposal that may remove a message: new values of keys, each as the argument of `--set`.
struct Cure {
  std::vector<std::string> changes;  // such as "panels.bag.aft=20"
  std::string note = {};             // a condition, printed after the values; may be empty
};

struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string message;
  std::string hint;  // the cure; may be empty
  /// Proposals, the likeliest first. They become part of the hint only after they have been tried.
  std::vector<Cure> cures = {};
  std::vector<std::string> changes = {};  // the first proposed values of the hint, which remove the message
  std::string accepted = {};              // why the user accepts the warning; empty: it is not accepted
};

/// Collects all errors of an input, so that they are reported together.
class Diagnostics {
 public:
  enum class Source { file, command_line };
  static constexpr std::size_t kMostShown = 100;
  static constexpr std::size_t kMostCured = 20;

  /// Adds a source and returns its index. Messages are sorted in the order of sources, the root file first.
  /// For a source that is a command line, messages show its name, but no line and column.
  int add_source(std::string name, std::string text, Source kind = Source::file);

  void error(const Place& place, std::string message, std::string hint = {}, std::vector<Cure> cures = {});
  void warning(const Place& place, std::string message, std::string hint = {}, std::vector<Cure> cures = {});

  /// Adds the sources and messages of `other`. Returns the amount by which the indices of the sources of
  /// `other` increase.
  int append(const Diagnostics& other);
  /// A copy with the same sources and without messages.
  Diagnostics without_messages() const;
  /// Adds messages whose places refer to the sources of this object.
  void take_messages(const std::vector<Diagnostic>& messages);
  /// All messages, in the order in which they were added.
  const std::vector<Diagnostic>& messages() const { return entries_; }

  int errors() const { return errors_; }
  /// Whether the next error will be shown. If not, no hint is needed; finding one may take long.
  bool wants_hints() const { return errors_ < static_cast<int>(kMostShown); }
  /// Whether proposals for the next message will be tried. If not, callers need not make proposals.
  bool wants_cures() const { return tries_cures_ && entries_.size() < kMostCured; }
  /// `tries`: whether the proposals for later messages will be tried.
  void expect_trials(bool tries) { tries_cures_ = tries; }
  /// Number of warnings that the user does not accept.
  int warnings() const { return static_cast<int>(entries_.size()) - errors_ - accepted_; }

  /// Accepts the warning with this index in messages(), for a reason. The warning is no longer counted or
  /// shown.
  void accept(std::size_t warning, std::string reason);

  /// All messages except accepted warnings, sorted by source, line and column.
  std::vector<Diagnostic> sorted() const;
  /// The accepted warnings, sorted in the same way.
  std::vector<Diagnostic> accepted() const;

  /// A place as text: "codend.toml:41:13", "--set parts.net.cells", or "" if there is no file.
  std::string where(const Place& place) const;

  /// All messages as text. Each consists of `codend.toml:41:13: error: message`, the source line with the
  /// place underlined, and `  hint: …`. At most `limit` messages are shown, followed by the number of the
  /// others. Control characters are replaced, so that none reaches a terminal.
  std::string render(bool color, std::size_t limit = kMostShown) const;

 private:
  struct Text {
    std::string name;
    std::string text;
    Source kind;
  };
  void add(Diagnostic entry);
  std::vector<Diagnostic> sorted(bool are_accepted) const;
  std::string source_line(const Place& place) const;
  std::string excerpt(const Place& place) const;

  std::vector<std::shared_ptr<const Text>> sources_;  // shared with copies
  std::vector<Diagnostic> entries_;
  std::set<std::tuple<int, int, int, std::string>> seen_;
  int errors_ = 0, accepted_ = 0;
  bool tries_cures_ = true;
};

}  // namespace netloft::formats
