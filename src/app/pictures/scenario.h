// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/result_numbers.h"
#include "core/words/words.h"

namespace frana::app {

/// What a scenario line is made of.
struct ScenarioFacts {
    std::function<std::optional<std::string>(const std::string& key)> value;  ///< of the result's scene
    std::vector<std::string> release_names;                                   ///< of the polygons that have one
    double volume = 0;                                                        ///< [m3]
    double simulated_seconds = 0;
    std::optional<RunEnd> end;  ///< none: not known
};

/// Returns the name of the model, with the scheme where it is not the default.
std::string voellmy_bingham_words(const std::string& scheme, const Words& words);

/// Returns what fails, how much of it, the model and its values: "Release North, South: 12 300 m3; Voellmy-Bingham,
/// friction angle 12 degrees, turbulence 500 m/s2, density 2000 kg/m3. The run ended after 120 s: ...". Of values that
/// differ from place to place it says so.
std::string scenario_words(const ScenarioFacts& facts, const Words& words);

}  // namespace frana::app
