// SPDX-License-Identifier: Apache-2.0
#include "app/complete_result.h"

#include <algorithm>
#include <filesystem>

#include "app/checkpoints.h"
#include "app/comparison_input.h"
#include "app/manifest.h"
#include "app/publish_pictures.h"
#include "app/result_directory.h"
#include "app/result_files.h"
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

// The files that only a run writes, and that have gone; pictures are drawn anew.
std::vector<std::string> missing_files(const Manifest& manifest, const std::string& directory) {
    std::vector<std::string> missing;
    for (const auto& [name, mark] : manifest.files) {
        const ResultFile* const file = known_file(name);
        const bool wanted = file != nullptr && file->kind != FileKind::picture &&
                            file->kind != FileKind::film && file->kind != FileKind::working;
        if (wanted && !fs::exists(fs::path(directory) / name)) missing.push_back(name);
    }
    return missing;
}

void require_all(const std::vector<std::string>& missing, const std::string& directory) {
    constexpr std::size_t k_told = 20;
    if (missing.empty()) return;
    std::vector<std::string> told(missing.begin(), missing.begin() + std::min(k_told, missing.size()));
    if (missing.size() > told.size())
        told.push_back("and " + std::to_string(missing.size() - told.size()) + " more");
    throw Error(ErrorKind::input,
                Problem{"files of the result are missing, which only a run can write: " + joined(told, ", "),
                        directory, "", "", "Bring them back, or compute the scene anew with --overwrite"});
}

}  // namespace

bool is_finished(const std::string& directory) {
    const auto manifest = read_manifest(directory);
    if (!manifest && !is_unlisted_result(directory)) return false;
    return manifest && manifest->finished ? *manifest->finished : checkpoints_in(directory).empty();
}

bool complete_result(const Prepared& prepared, const std::string& directory, RunLog& log) {
    require_same_scene(prepared, directory);
    const std::vector<Problem> of_the_older = clear_place_of(directory, "", log);
    const auto manifest = read_manifest(directory);
    const std::vector<std::string> missing =
        manifest ? missing_files(*manifest, directory) : std::vector<std::string>{};
    const bool only_report = missing == std::vector<std::string>{"report.html"};
    if (!only_report) require_all(missing, directory);
    const auto comparison = comparison_of(prepared, directory, log);
    const PictureOutcome pictures = draw_pictures({prepared.spec, directory, comparison, true}, log);
    record_files(pictures.files);
    if (pictures.complete()) {
        record_finished(directory);
        forget_the_way(directory, !prepared.spec.output.frames, log);  // a run was killed while it did
    }
    if (pictures.complete() && pictures.drawn.empty() && missing.empty()) {
        log.tell("the result is complete: " + directory);
    } else if (!pictures.drawn.empty()) {
        log.tell("drew what was missing in " + directory + ": " + joined(pictures.drawn, ", "));
    }
    require_all(missing, directory);
    if (!of_the_older.empty()) throw Error(ErrorKind::environment, of_the_older);
    return pictures.complete();
}

}  // namespace frana::app
