// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "core/json.h"
#include "core/words/sentence.h"

namespace frana::app {

/// How many runs of a study were cut, left the ground, failed or warned, and by how much at most. Maps read it from
/// summary.json.
struct Troubles {
    std::size_t runs = 0, cut = 0, left = 0, failed = 0, warned = 0;
    std::size_t open = 0;                   ///< that were cut or left the ground, each once
    double most_moving = 0, most_left = 0;  ///< fractions of the volume, of the runs that were cut, that left
    bool each_counts = false;               ///< of a region: every slope is somebody's
    bool on_levels = false;                 ///< where one run of a finer level weighs as much as many others

    /// Whether a run was cut, left the ground or failed: what --strict makes an error.
    [[nodiscard]] bool any() const noexcept { return cut + left + failed > 0; }
    /// Whether so many runs were cut or left the ground that the study's first line says so: over 5 %, of a region
    /// any, on levels any, and any that failed.
    [[nodiscard]] bool are_first() const noexcept;
    /// Runs whose reach is not known: cut, gone or failed.
    [[nodiscard]] std::size_t unfinished() const noexcept { return open + failed; }
};

/// "Extent, run-out and probabilities are lower bounds: 12 of 12 runs were cut while their front still moved (up to 70
/// % of the volume); ...".
Sentence headline(const Troubles& troubles);

/// As `run_troubles` of summary.json, and back; none: an older summary.
Json json_of(const Troubles& troubles);
std::optional<Troubles> troubles_in(const Json& summary);

}  // namespace frana::app
