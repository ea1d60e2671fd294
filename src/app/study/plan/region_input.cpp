// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/region_input.h"

#include <algorithm>
#include <map>

#include "analysis/hazard.h"
#include "app/input/doubt_ground.h"
#include "app/input/layer_values.h"
#include "app/publish/publish_hazard.h"
#include "app/store/scene_identity.h"
#include "core/text.h"

namespace frana::app::study {
namespace {

/// Refuses a scheme without intensities, or with several matrices of which hazard.process names none.
void settle_degree(StudyInput& input) {
    RegionSpec& region = *input.reading.study.region;
    if (!region.return_period) return;
    const auto scheme = hazard_scheme_of(input.base.spec);
    if (scheme && has_intensities(*scheme)) {
        if (const ProcessMatrix* const matrix = scheme->matrix_of(input.base.spec.hazard.process)) {
            region.degrees = matrix->degrees;
            return;
        }
        std::vector<std::string> known;
        for (const ProcessMatrix& one : scheme->matrices) known.push_back(one.process);
        throw Error(ErrorKind::input,
                    Problem{"is not given, and " + scheme->name + " has a matrix for each process",
                            input.central.where("hazard.process"), "", joined(known, ", "), "Name one"});
    }
    throw Error(ErrorKind::input,
                Problem{scheme ? "does not tell weak, medium and strong intensity, which the degree of hazard needs"
                               : "is missing, and the degree of hazard needs intensities",
                        input.central.where("hazard.scheme"), scheme ? scheme->name : "",
                        "a scheme with a matrix (`frana schemes` names it)",
                        "Choose one of these, or remove region.return-period"});
}

Prepared prepare_slope(SceneReading& slope, const std::optional<Problem>& place, RunLog& log) {
    slope.scene.observed = {};
    slope.scene.output.profiles.reset();
    return prepare(slope, place, log);
}

/// Prepares the largest slope that can be; one that cannot, off the DTM for example, fails alone when it runs. Throws
/// what is wrong with the largest if none can be.
void prepare_central(StudyInput& input, const std::optional<Problem>& place, RunLog& log) {
    try {
        SceneReading slope = input.central;
        input.base = prepare_slope(slope, place, log);
        input.central = std::move(slope);
        doubt_ground(input.central, input.base, log);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input || place || !input.central.problems.empty()) throw;
        for (const std::size_t member : by_size(input.slopes)) {
            if (!input.slopes[member].problem.empty()) continue;
            const auto take = [&] {
                SceneReading slope = input.member(member);
                input.base = prepare_slope(slope, std::nullopt, log);
                input.central = std::move(slope);
            };
            if (attempt(take)) return doubt_ground(input.central, input.base, log);
        }
        throw;
    }
}

}  // namespace

void find_problems(const std::function<SceneReading(std::size_t)>& scene_of, std::vector<Slope>& slopes,
                   Problems& problems) {
    std::map<std::string, std::pair<Problem, std::size_t>> counts;  // by words
    std::vector<std::vector<std::string>> of_slope(slopes.size());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const SceneReading scene = scene_of(i);
        for (const Problem& problem : scene.problems.list()) {
            const std::string words = problem.where + problem.what;
            ++counts.try_emplace(words, problem, 0).first->second.second;
            of_slope[i].push_back(words);
        }
    }
    for (const auto& [words, found] : counts)
        if (found.second == slopes.size()) problems.add(found.first);
    for (std::size_t i = 0; i < slopes.size(); ++i)
        for (const std::string& words : of_slope[i]) {
            const auto& [problem, count] = counts.at(words);
            if (count < slopes.size() && slopes[i].problem.empty()) slopes[i].problem = describe(problem);
        }
}

std::vector<std::size_t> by_size(const std::vector<Slope>& slopes) {
    std::vector<std::size_t> sound;
    for (std::size_t i = 0; i < slopes.size(); ++i)
        if (slopes[i].problem.empty()) sound.push_back(i);
    if (sound.empty())
        for (std::size_t i = 0; i < slopes.size(); ++i) sound.push_back(i);
    std::stable_sort(sound.begin(), sound.end(),
                     [&](std::size_t a, std::size_t b) { return slopes[a].area > slopes[b].area; });
    return sound;
}

void prepare_region(StudyInput& input, const std::optional<Problem>& place, RunLog& log) {
    const SceneReading of_all = input.scene_with({});
    prepare_central(input, place, log);
    input.base.spec.release.perimeter_layer = of_all.scene.release.perimeter_layer;
    input.base.scene.time.frame_interval = 0;
    settle_degree(input);
    const GridSpec& grid = input.base.scene.grid;
    const std::string key = "release.perimeter";
    gis::LayerChoice all = layer_choice(of_all, of_all.scene.release.perimeter_layer, key);
    all.keep_unusable = true;  // those without an area fail alone
    const gis::PolygonLayer layer =
        of_all.session.read(gis::read_polygons, *of_all.scene.release.perimeter, grid.crs_wkt, of_all.where(key), all);
    for (std::size_t i = 0; i < layer.features.size() && i < input.slopes.size(); ++i)
        input.slopes[i].outline = layer.features[i].parts;
    input.identity = "study = region\n" + values_text(input.table) + scene_identity(input.base);
    const UsedFile polygons = used_polygons("release perimeter of all", *of_all.scene.release.perimeter, layer);
    input.identity += "checksum of the " + polygons.role + " = " + std::to_string(polygons.checksum.value()) + "\n";
}

}  // namespace frana::app::study
