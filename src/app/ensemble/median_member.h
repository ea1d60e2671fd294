// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "app/ensemble/study_input.h"
#include "app/ensemble/study_result.h"
#include "app/store/result_directory.h"

namespace frana::app {

/// Figure by which the median member is chosen.
inline constexpr const char* k_median_figure = "covered_area_m2";

/// The member in the middle of a study.
struct MedianMember {
    std::size_t member = 0;
    study::Figure figure;  ///< its own value of k_median_figure
    double median = 0;     ///< weighted, of all members
};

/// Returns the member on the scene's own cells whose figure is nearest to the weighted median of all, of several the
/// first. None if no member finished.
std::optional<MedianMember> median_member(const StudyInput& input, const StudyResult& result);

/// Runs a member again, with frames, and writes animation.mp4 if the scene asks for one; the terrain and the outlines
/// of the study must have been written. The frames are removed. Returns false with a warning if there is no animation
/// although it was asked for.
bool film_member(const StudyInput& input, const StudyResult& result, const MedianMember& median,
                 const ResultDirectory& directory, RunLog& log);

}  // namespace frana::app
