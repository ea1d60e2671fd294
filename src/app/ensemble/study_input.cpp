// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_input.h"

#include <cmath>
#include <set>
#include <utility>

#include "app/input/share_directory.h"
#include "app/store/scene_identity.h"
#include "gis/access/table_in.h"

namespace frana::app {
namespace {

SceneReading read_member(const study::StudyReading& reading, const std::vector<std::string>& overrides) {
    std::vector<std::string> all = reading.study.set;
    all.insert(all.end(), overrides.begin(), overrides.end());
    return read_scene(reading.study.scene, all, materials_directory(), reading.label + ": ");
}

/// Problems that only some members have: each once, with the first member that has it.
void add_members_problems(const study::StudyReading& reading, const study::SampleTable& table, SceneReading& central) {
    std::set<std::string> known;
    for (const Problem& problem : central.problems.list()) known.insert(problem.where + problem.what);
    for (std::size_t member = 0; member < table.size(); ++member) {
        const SceneReading scene = read_member(reading, table.overrides(member));
        for (Problem problem : scene.problems.list()) {
            if (!known.insert(problem.where + problem.what).second) continue;
            problem.what = "in member " + std::to_string(member) + ": " + problem.what;
            central.problems.add(problem);
        }
    }
}

void refuse_accuracy(SceneReading& central) {
    if (central.scene.numerics.accuracy)
        central.problems.add({"has no effect in a study: members are computed on the scene's own cells",
                              central.where("numerics.accuracy"), "", "",
                              "Remove the key, and choose terrain.cell-size"});
}

study::SampleTable read_samples(study::StudyReading& reading) {
    if (reading.study.sampling == study::Sampling::table) {
        const std::string where = reading.where("study.sampling");
        try {
            const gis::Table file = gis::read_table(reading.study.table, where);
            return study::samples_of_table(file.columns, file.rows, where + ": " + reading.study.table,
                                           reading.problems);
        } catch (const Error& error) {
            reading.problems.add(error);
            return {};
        }
    }
    if (!reading.problems.empty()) return {};  // values of a broken study would be reported for nothing
    return study::draw_samples(reading.study, reading.label, reading.problems);
}

/// Members that together have every value of the keys without order; fields of error need no trial.
std::vector<std::size_t> members_with_every_value(const study::SampleTable& table) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < table.keys.size(); ++k) {
        if (!table.nominal[k] || table.keys[k] == "terrain.error") continue;
        std::set<std::string> seen;
        for (std::size_t member = 0; member < table.size(); ++member)
            if (seen.insert(table.values[member][k]).second) members.push_back(member);
    }
    return members;
}

void require_same_lattice(const GridSpec& grid, const GridSpec& other, const std::string& where, Problems& problems) {
    const auto is_whole = [](double cells) { return std::abs(cells - std::round(cells)) < 1e-3; };
    const bool same = std::abs(grid.cell_size / other.cell_size - 1) < 1e-9 && grid.crs_wkt == other.crs_wkt &&
                      is_whole((grid.west - other.west) / grid.cell_size) &&
                      is_whole((grid.north - other.north) / grid.cell_size);
    if (!same)
        problems.add({"gives other cells than the central member, so that their maps cannot be combined", where, "", "",
                      "Set terrain.crs and terrain.cell-size in the scene, or bring the files to the same cells"});
}

std::string values_text(const study::SampleTable& table) {
    std::string text;
    for (std::size_t member = 0; member < table.size(); ++member)
        for (std::size_t k = 0; k < table.keys.size(); ++k)
            text += "member " + std::to_string(member) + " " + table.keys[k] + " = " + table.values[member][k] + "\n";
    return text;
}

}  // namespace

SceneReading StudyInput::member(std::size_t index) const {
    return read_member(reading, table.overrides(index));
}

StudyTexts read_study_texts(const std::string& path) {
    StudyTexts texts;
    texts.reading = study::read_study(path);
    if (texts.reading.study.scene.empty()) texts.reading.problems.throw_if_any();
    texts.table = read_samples(texts.reading);
    const bool by_table = texts.reading.study.sampling == study::Sampling::table;
    const bool has_table = by_table && texts.table.size() > 0;
    try {
        texts.central = read_member(texts.reading, has_table ? texts.table.overrides(texts.table.size() / 2)
                                                             : study::central_values(texts.reading.study));
    } catch (const Error& error) {  // the scene is no INI
        texts.reading.problems.add(error);
        texts.reading.problems.throw_if_any();
    }
    refuse_accuracy(texts.central);
    add_members_problems(texts.reading, texts.table, texts.central);
    for (const Problem& problem : texts.reading.problems.list()) texts.central.problems.add(problem);
    return texts;
}

StudyInput prepare_study(StudyTexts texts, const std::optional<Problem>& place, RunLog& log) {
    StudyInput input{std::move(texts.reading), std::move(texts.table), {}, std::move(texts.central), {}, {}};
    input.base = prepare(input.central, place, log);
    input.base.scene.time.frame_interval = 0;
    input.identity = "study = " + study::name_of(input.reading.study.sampling) + "\n" + values_text(input.table) +
                     scene_identity(input.base);
    Problems problems;
    RunLog silent(true);
    for (const std::size_t member : members_with_every_value(input.table)) {
        try {
            const Prepared prepared = prepare(input.member(member), silent);
            require_same_lattice(input.base.scene.grid, prepared.scene.grid, "member " + std::to_string(member),
                                 problems);
            input.identity += "member " + std::to_string(member) + ":\n" + scene_identity(prepared);
            for (const ReleaseArea& area : prepared.scene.release) input.other_releases.push_back(area);
        } catch (const Error& error) {
            problems.add(error);
        }
    }
    problems.throw_if_any();
    return input;
}

}  // namespace frana::app
