// SPDX-License-Identifier: Apache-2.0
#include "app/publish/complete_result.h"

#include <algorithm>
#include <filesystem>

#include "app/compare/comparison.h"
#include "app/pictures/result_numbers.h"
#include "app/pictures/result_reader.h"
#include "app/publish/publish_pictures.h"
#include "app/store/checkpoints.h"
#include "app/store/manifest.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "core/error.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

void require_same_scene(const Prepared& prepared, const std::string& directory) {
    const auto then = result_identity(directory);
    const std::string here = scene_identity(prepared);
    if (then == here) return;
    const std::string remedy = "Choose another folder with --out, or add --overwrite";
    if (!then)
        throw Error(ErrorKind::input, Problem{"contains a result of an older frana, which did not record its scene",
                                              directory, "", "", remedy});
    throw Error(ErrorKind::input, Problem{"contains the finished result of another scene: " +
                                              joined(identity_differences(here, *then), "; "),
                                          directory, "", "", remedy});
}

// Reads the comparison from the result's files.
std::optional<Comparison> comparison_of(const Prepared& prepared, const std::string& directory, RunLog& log) {
    const ResultReader result(directory);
    if (!result.has(raster_file("comparison"))) return std::nullopt;
    ComparisonInput input = surveyed(prepared);
    input.depth = result.raster(RasterName::max_depth);
    input.bed = result.raster(RasterName::bed);
    input.release = result.raster("release");
    input.inflows = flow_tops(read_main_statistics(directory));
    input.final_depth = result.vertical_raster(RasterName::final_depth);
    if (result.has(raster_file(RasterName::elevation_change)))
        input.elevation_change = result.raster(RasterName::elevation_change);
    return compare_with_survey(input, log);
}

// Returns the files that only a run writes and that no longer exist; pictures are drawn again.
std::vector<std::string> missing_files(const Manifest& manifest, const std::string& directory) {
    std::vector<std::string> missing;
    for (const auto& [name, bytes] : manifest.files) {
        const ResultFile* const file = existing_file(name);
        const bool wanted = bytes && file != nullptr && !file->is_drawn() && file->kind != FileKind::working;
        if (wanted && !fs::exists(fs::path(directory) / name)) missing.push_back(name);
    }
    return missing;
}

// Returns the existing files that differ from those the run wrote; styles may be changed by the user.
std::vector<std::string> changed_files_of(const Manifest& manifest, const std::string& directory) {
    std::vector<std::string> changed;
    for (const auto& [name, bytes] : manifest.files) {
        const ResultFile* const file = existing_file(name);
        if (file == nullptr || file->kind == FileKind::style || file->kind == FileKind::working) continue;
        const fs::path path = fs::path(directory) / name;
        if (!fs::exists(path) || is_as_listed(path.string(), bytes)) continue;
        // A GIS may have written into a GeoPackage.
        if (!name.ends_with(".gpkg") || fs::file_size(path) < *bytes) changed.push_back(name);
    }
    return changed;
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t k_printed = 20;
    std::vector<std::string> some(names.begin(), names.begin() + std::min(k_printed, names.size()));
    if (names.size() > some.size()) some.push_back("and " + std::to_string(names.size() - some.size()) + " more");
    return joined(some, ", ");
}

void require_all(const std::vector<std::string>& missing, const std::vector<std::string>& changed,
                 const std::string& directory) {
    const std::string remedy = "Restore them, or compute the scene again with --overwrite";
    Problems problems;
    if (!missing.empty())
        problems.add({"files of the result are missing that only a run can write: " + listed(missing), directory, "",
                      "", remedy});
    if (!changed.empty())
        problems.add(
            {"files of the result are not as the run wrote them: " + listed(changed), directory, "", "",
             "Restore them, move pictures away to have them drawn again, or compute the scene again elsewhere"});
    problems.throw_if_any();
}

}  // namespace

bool is_finished(const std::string& directory) {
    const auto manifest = read_manifest(directory);
    return manifest ? manifest->finished.value_or(false) : false;
}

bool complete_result(const Prepared& prepared, const std::string& directory, RunLog& log) {
    require_same_scene(prepared, directory);
    const Manifest manifest = read_manifest(directory).value();
    const std::vector<std::string> missing = missing_files(manifest, directory),
                                   changed = changed_files_of(manifest, directory);
    const bool only_report = missing == std::vector<std::string>{k_report_file};
    if (!only_report || !changed.empty()) require_all(missing, changed, directory);
    const auto comparison = comparison_of(prepared, directory, log);
    const PictureOutcome pictures = draw_pictures({prepared.spec, directory, comparison, true, std::nullopt}, log);
    record_files(pictures.files);
    if (pictures.complete()) {
        record_finished(directory);
        remove_working_files(directory, !prepared.spec.output.frames, log);  // a run was killed before it did this
    }
    if (pictures.complete() && pictures.drawn.empty() && missing.empty()) {
        log.info("the result is complete: " + directory);
    } else if (!pictures.drawn.empty()) {
        log.info("drew what was missing in " + directory + ": " + joined(pictures.drawn, ", "));
    }
    require_all(missing, {}, directory);
    return pictures.complete();
}

}  // namespace frana::app
