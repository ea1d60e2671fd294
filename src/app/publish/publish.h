// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/input/prepare.h"
#include "app/publish/publish_pictures.h"
#include "app/publish/summary.h"
#include "app/store/frame_store.h"
#include "app/store/result_directory.h"
#include "simulation/result.h"

namespace frana::app {

/// A complete run with its inputs.
struct Finished {
    const Prepared& prepared;
    const RunResult& result;
    int threads = 1;
    double input_seconds = 0;
    double earlier_seconds = 0;  ///< wall time of the sessions before this one
    const Stopwatch& since_start;
    const AccuracyRecord* accuracy = nullptr;  ///< of a run that came to its end under numerics.accuracy
    Warnings found{};                          ///< before and after it was computed, told
};

/// Writes the files of a result: rasters with styles, outlines, maps, animation, comparison, series, summary, scene,
/// log; the summary and the log last, as they describe all the others. A map or animation that cannot be drawn does not
/// fail the run: it is a warning, and the return value reports it. Throws Error(environment) if a file cannot be
/// written.
PictureOutcome publish(const Finished& run, const ResultDirectory& directory, FrameWriter& frames, RunLog& log);

}  // namespace frana::app
