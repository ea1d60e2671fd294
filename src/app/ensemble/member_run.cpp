// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/member_run.h"

#include "app/ensemble/mapped_events.h"
#include "app/ensemble/region_input.h"
#include "app/publish/publish.h"
#include "app/store/saved_work.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

/// Files that members share come from memory: reading a terrain takes longer than all other preparation.
/// The slopes of a region have none in common but small ones, and their terrains together are too much to keep.
/// @param log of its own: its warnings are the member's
Prepared prepared_member(const StudyInput& input, const MemberTask& task, RunLog& log) {
    gis::RememberedReads own;
    const gis::UseRemembered remember(input.reading.study.region ? own : *input.files);
    SceneReading reading = input.scene_with(task.overrides);
    reading.scene.observed = {};  // read once, for the maps
    reading.scene.output.profiles.reset();
    reading.scene.output.exposure.reset();
    if (const auto& region = input.reading.study.region) cut_terrain(*region, reading, log);
    Prepared prepared = prepare(reading, log);
    prepared.scene.time.frame_interval = 0;
    return prepared;
}

}  // namespace

std::optional<study::MemberRecord> own_record(const StudyInput& input, const std::string& folder, std::size_t member) {
    auto record = study::read_record(record_file(folder, member), member);
    if (record && record->key_values != study::values_text(input.table.overrides(member))) record.reset();
    return record;
}

std::optional<study::MemberRecord> run_member(const StudyInput& input, const MemberTask& task,
                                              const std::function<bool()>& stops) {
    RunLog log(true);
    try {
        if (!input.slopes.empty() && !input.slopes[task.member].problem.empty())
            throw Error(ErrorKind::input, Problem{input.slopes[task.member].problem, "", "", "", ""});
        const Prepared prepared = prepared_member(input, task, log);
        const Scene& scene = prepared.scene;
        RunOptions options;
        options.stop_requested = stops;
        const RunResult result = run(scene, options);
        if (result.stop_reason == StopReason::requested) return std::nullopt;
        study::RecordExtras extras = record_extras(input.base.spec);
        extras.pressure = extras.pressure || input.reading.study.per_polygon() || input.base.extra.exposure;
        extras.final_depth = input.keeps_final_depth;
        study::MemberRecord record =
            study::record_of(task.member, result, scene, input.base.spec.output.trace_threshold, extras);
        warn_of_result(prepared, result, log);
        record.end.warnings = log.warnings();
        record.key_values = study::values_text(task.overrides);
        return record;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::environment) throw;
        study::MemberRecord record = study::empty_record(task.member, input.base.scene.grid);
        record.failure = describe(error.problems().front());
        record.end.warnings = log.warnings();
        record.key_values = study::values_text(task.overrides);
        return record;
    }
}

}  // namespace frana::app
