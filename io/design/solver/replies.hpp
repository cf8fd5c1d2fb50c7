// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/live/live_scene.hpp"
#include "io/design/solver/solver_call.hpp"
#include "io/design/texts/scene_texts.hpp"

namespace netloft::design {

/// Messages sorted by place: severity, file, line, column, length, message, hint, and the changes that remove
/// the message.
Json messages_json(const formats::Diagnostics& diagnostics);

/// The characters that an edit replaced, with line and column of the first one.
Json edit_json(const Edit& edit, const formats::StoredTexts& texts);

/// The numbers of a scene: path, value, unit, allowed range in that unit, description, and place in a file.
Json numbers_json(const formats::Document& document,
                  const std::map<std::string, formats::NumberWords>& words);

/// All figures of a result with their errors. Unknown numbers are null.
Json figures_json(const results::Result& result);

// The words of a number as JSON, and back.
Json words_json(const formats::NumberWords& words);
formats::NumberWords words_in(const Json& json);

/// The outcome for a text, without its equilibrium.
Json verdict_json(const Outcome& outcome);
/// The same, with positions and figures of the equilibrium if there is one.
Json outcome_json(const Outcome& outcome, const LiveScene& scene);

/// The points of the plan in the last equilibrium, each with its node and its place [m].
Json points_json(const LiveScene& scene);

/// The tangents of a number: the motion of the nodes and the slopes of the figures per unit of the number.
Json tangents_json(const Tangents& tangents, const Equilibrium& at);

}  // namespace netloft::design
