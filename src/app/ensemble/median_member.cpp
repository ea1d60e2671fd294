// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/median_member.h"

#include <cmath>
#include <filesystem>

#include "app/ensemble/study_charts.h"
#include "app/pictures/animation.h"
#include "app/pictures/result_reader.h"
#include "app/process/signals.h"
#include "app/store/frame_store.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "params/keys/scene_parameters.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

void write_frames(const StudyInput& input, const StudyResult& result, std::size_t member,
                  const ResultDirectory& directory) {
    RunLog silent(true);
    const Prepared prepared = prepare(input.member(member), silent);
    if (!prepared.scene.grid.same_cells(result.grid))
        throw Error(ErrorKind::input,
                    Problem{"has other cells than the maps", "member " + std::to_string(member), "", "",
                            "`frana run` with its values from " + std::string(k_member_table) + " makes the film"});
    directory.make_folder(k_frame_folder);
    FrameWriter frames(directory.path(k_frame_folder), provenance(prepared));
    RunOptions options;
    options.on_frame = [&](Frame frame) { frames.add(std::move(frame)); };
    options.stop_requested = [&] { return stop_signal() != 0 || frames.failed(); };
    run(prepared.scene, options);
    frames.finish();
}

void remove_frames(const ResultDirectory& directory) {
    std::error_code ignored;  // what is left belongs to the files of a result
    std::filesystem::remove_all(directory.path(k_frame_folder), ignored);
}

/// Members of a multilevel study may be on larger cells.
bool is_on_own_cells(const StudyInput& input, std::size_t member) {
    if (input.table.level_runs.empty()) return true;
    return input.table.level_runs[member].cell_size == input.levels.back().cell_size;
}

std::string sentence(const MedianMember& median) {
    return "member " + std::to_string(median.member) + ", " + median.figure.title + " " + grouped(median.figure.value) +
           " " + median.figure.unit + " (median of all " + grouped(median.median) + ")";
}

}  // namespace

std::optional<MedianMember> median_member(const StudyInput& input, const StudyResult& result) {
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        if (result.figures()[f].key != k_median_figure) continue;
        const std::vector<double> values = result.figure(f);
        const double median = figure_quantile(values, result.finished.weights, 0.5);
        std::optional<std::size_t> nearest;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!is_on_own_cells(input, result.members[result.finished_at[i]].member)) continue;
            if (!nearest || std::abs(values[i] - median) < std::abs(values[*nearest] - median)) nearest = i;
        }
        if (!nearest) return std::nullopt;
        const MemberResult& member = result.members[result.finished_at[*nearest]];
        return MedianMember{member.member, member.figures[f], median};
    }
    return std::nullopt;
}

bool film_member(const StudyInput& input, const StudyResult& result, const MedianMember& median,
                 const ResultDirectory& directory, RunLog& log) {
    const OutputSpec& output = input.base.spec.output;
    if (!output.animation) return true;
    bool complete = false;
    try {
        write_frames(input, result, median.member, directory);
        const ResultReader written(directory.folder());
        MapSource source = written.map_source();
        source.title = output.title.value_or(scene_name(input.base.spec));
        const Words& words = source.style.words;
        source.subtitle = words(
            "member {1}, {2} {3} {4} (median of all {5})",
            {std::to_string(median.member), figure_title(median.figure, words),
             words.number(grouped(median.figure.value)), median.figure.unit, words.number(grouped(median.median))});
        AnimationRequest film{
            animation_source(written, source, "depth"), {}, false, false, animation_size(source.style.size)};
        film.stop_requested = [] { return stop_signal() != 0; };
        complete = stop_signal() == 0 && write_animation(film, directory.path(k_animation_file));
        if (complete)
            log.note(std::string("drew ") + k_animation_file + ": " + sentence(median));
        else
            log.warn(worded("{1} is left out because of the signal", {k_animation_file}));
    } catch (const Error& error) {
        log.warn(worded("{1} could not be drawn: {2}", {k_animation_file, std::string(error.what())}));
    }
    remove_frames(directory);
    return complete;
}

}  // namespace frana::app
