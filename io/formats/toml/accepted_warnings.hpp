// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// A warning that the author of a document accepts:
///
///   [[accept]]
///   warning = "top-wing.aft"      # the words with which the warning begins
///   reason = "the sheet says so"
///
/// An entry accepts one warning: the one that begins with the text `warning`, in whole words or numbers. If
/// several warnings begin with this text, none is accepted.

/// Marks the warnings that the entries `accept` of a document accept.
void mark_accepted(const Value& root, Diagnostics& diagnostics);

/// Does the same as mark_accepted(), and also refuses entries without `warning` or `reason`. Unless there are
/// errors, it also warns of entries that do not match exactly one warning. Call it once, after all warnings
/// are known.
void accept_warnings(const Value& root, Diagnostics& diagnostics);

}  // namespace netloft::formats
