// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/compare/comparison.h"
#include "app/publish/document.h"
#include "core/words/words.h"

namespace frana::app {

/// The sentence of the first page; also if nothing was compared.
Document comparison_answer(const std::optional<Comparison>& comparison, const Words& words);
/// The section: the map (if that file exists), the scores, their curve; empty without a comparison.
/// @param picture comparison.png, or one drawn for the page
Document comparison_section(const std::optional<Comparison>& comparison, const std::string& picture,
                            const Words& words);

}  // namespace frana::app
