// SPDX-License-Identifier: Apache-2.0
#include "app/complete_result.h"

#include <filesystem>

#include "app/checkpoints.h"
#include "app/comparison_input.h"
#include "app/manifest.h"
#include "app/publish_pictures.h"
#include "app/result_directory.h"
#include "app/result_reader.h"
#include "app/scene_identity.h"
#include "core/error.h"
#include "params/value_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

void require_same_scene(const Prepared& prepared, const std::string& directory) {
    const auto then = result_identity(directory);
    const std::string here = scene_identity(prepared);
    if (then == here) return;
    const std::string remedy = "Choose another folder with --out, or add --overwrite";
    if (!then)
        throw Error(ErrorKind::input, Problem{"holds a result already, of a frana that did not tell of what scene", directory,
                                              "", "", remedy});
    throw Error(ErrorKind::input, Problem{"holds the finished result of another scene: " +
                                              joined(identity_differences(here, *then), "; "),
                                          directory, "", "", remedy});
}

// As it was, from the files.
std::optional<Comparison> comparison_of(const Prepared& prepared, const std::string& directory, RunLog& log) {
    const ResultReader result(directory);
    if (!result.has("comparison.tif")) return std::nullopt;
    ComparisonInput input = surveyed(prepared);
    input.depth = result.raster("max_depth");
    input.bed = result.raster("bed");
    input.release = result.raster("release");
    input.final_depth = result.raster("final_depth");
    return compare_with_survey(input, log);
}

}  // namespace

bool is_finished(const std::string& directory) {
    return (is_listed_result(directory) || is_unlisted_result(directory)) && checkpoints_in(directory).empty();
}

bool complete_result(const Prepared& prepared, const std::string& directory, RunLog& log) {
    require_same_scene(prepared, directory);
    const auto comparison = comparison_of(prepared, directory, log);
    const PictureOutcome pictures = draw_pictures({prepared.spec, directory, comparison, true}, log);
    record_files(pictures.files);
    if (pictures.complete()) forget_the_way(directory, !prepared.spec.output.frames);  // a run was killed while it did
    if (pictures.complete() && pictures.drawn.empty()) {
        log.tell("the result is complete: " + directory);
    } else if (!pictures.drawn.empty()) {
        log.tell("drew what was missing in " + directory + ": " + joined(pictures.drawn, ", "));
    }
    if (prepared.spec.output.report && !fs::exists(fs::path(directory) / "report.html"))
        log.warn("report.html is missing, and only a run can write it: --overwrite computes the scene anew");
    return pictures.complete();
}

}  // namespace frana::app
