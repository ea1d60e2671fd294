// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/commands/accuracy_search.h"
#include "app/commands/command_line.h"
#include "app/commands/forecast.h"
#include "app/commands/scene_variants.h"
#include "app/input/check_inputs.h"
#include "app/input/doubt_ground.h"
#include "app/input/share_directory.h"
#include "app/process/machine_memory.h"
#include "app/process/terminal.h"
#include "app/publish/publish.h"
#include "app/publish/publish_pictures.h"
#include "app/publish/publish_rasters.h"
#include "app/publish/summary.h"
#include "app/store/checkpoints.h"
#include "app/store/interrupted_run.h"
#include "app/store/manifest.h"
#include "app/store/recorded_inputs.h"
#include "app/store/result_directory.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/study/plan/read_study.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "params/keys/output_parameters.h"
#include "simulation/run_check.h"
#include "simulation/run_summary.h"
#include "simulation/scene.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

ExitCode exit_code(const RunResult& result, const PictureOutcome& pictures) {
    switch (result.stop_reason) {
        // The map ends at the edge of the terrain: a script must not treat it as complete.
        case StopReason::reached_no_data:
        case StopReason::non_finite:
        case StopReason::impossible_speed:
        case StopReason::volume_drift:
            return ExitCode::numerical;
        default:
            return pictures.has_failed ? ExitCode::environment : ExitCode::done;
    }
}

RunOptions run_options(int threads, FrameWriter* frames, bool with_particles, ProgressReporter& progress,
                       Checkpoints& checkpoints, Findings found) {
    RunOptions run_with;
    run_with.threads = threads;
    run_with.particles_in_frames = with_particles;
    if (frames != nullptr) run_with.on_frame = [frames](Frame frame) { frames->add(std::move(frame)); };
    run_with.on_progress = [&progress](const Progress& now) { progress.show(now); };
    run_with.on_problem = [&progress, found](const RunProblem& run_problem) {
        progress.finish();
        found.warn(worded("{1}: the run stops here", {describe(run_problem)}));
    };
    run_with.stop_requested = [frames] { return stop_signal() != 0 || (frames != nullptr && frames->failed()); };
    run_with.after_step = [&checkpoints](const Progress& now, const SaveState& state) {
        checkpoints.after_step(now, state);
    };
    return run_with;
}

// An incomplete run is neither discarded nor mixed with another.
void refuse_to_discard(const InterruptedRun& interrupted, const std::string& target, Problems& problems) {
    if (const std::string study = interrupted_study(target); !study.empty())
        problems.add({"an interrupted study of it is kept in " + study, target, "", "",
                      "`frana ensemble --resume` continues it; --overwrite removes it"});
    if (interrupted.beside().empty()) return;
    problems.add({"an interrupted run of it is kept in " + interrupted.beside(), target, "", "",
                  "--resume continues it; --overwrite removes it and starts anew"});
}

void log_resuming(const CheckpointFile& from, Findings found) {
    const CheckpointHead& head = from.head();
    found.log.continue_from(head.log);
    found.log.info("resuming from " + number_text(head.time, 6) + " s, step " + std::to_string(head.step) + ": " +
                   from.path());
    if (head.build != checkpoint_build()) {
        found.warn(worded("checkpoint of another build ({1}; this is {2}): rounding can differ",
                          {head.build, std::string(checkpoint_build())}));
    }
}

// Adds to the problem the parts that can be saved of a run stopped by the disk.
[[noreturn]] void explain_problem(const Error& error, const std::string& folder) {
    std::vector<Problem> problems = error.problems();
    const bool says_how = problems.front().remedy.find("--resume") != std::string::npos;
    if (error.kind() != ErrorKind::environment || says_how) throw error;
    std::error_code unknown;
    const auto space = std::filesystem::space(std::filesystem::path(folder).parent_path(), unknown);
    if (!unknown)
        problems.push_back({"the disk has " + number_text(static_cast<double>(space.available) / 1e6, 2) + " MB free",
                            std::filesystem::path(folder).parent_path().string(), "", "", ""});
    if (!checkpoints_in(folder).empty())
        problems.push_back({"the run up to its last checkpoint is kept", folder, "", "",
                            "Remove the cause, then resume with the same command and --resume"});
    throw Error(error.kind(), problems);
}

// What a run is computed from.
struct RunInput {
    const Prepared& prepared;
    int threads;
    bool quiet, json_progress, strict;
    double input_seconds, earlier_seconds;
    const Stopwatch& since_start;
    std::optional<AccuracyRecord> accuracy;  ///< as decided before the run
};

// The overrides of the command line, --accuracy among them.
std::vector<std::string> overrides(const Options& values) {
    std::vector<std::string> all = text_options(values, "set");
    if (const auto accuracy = text_option(values, "accuracy")) all.push_back("numerics.accuracy=" + *accuracy);
    return all;
}

// The scheme of coarser levels: finite volumes where the scene allows them, at a fraction of the time.
Scheme coarse_scheme(const SceneReading& reading, const std::vector<std::string>& set) {
    const Scheme own = reading.scene.numerics.scheme;
    if (own != Scheme::standard || reading.scene.material.model == "structured") return own;
    const SceneReading other = read_scene(
        reading.scene.file, overridden(set, {"numerics.scheme=" + word_of(Scheme::finite_volume, k_schemes)}),
        share_directory());
    return other.problems.empty() ? Scheme::finite_volume : own;
}

// Chooses the scene's cells for numerics.accuracy: those that an interrupted run had chosen, or by coarser runs. None:
// a signal stopped it.
std::optional<AccuracyRecord> put_on_cells(const SceneReading& reading, const std::vector<std::string>& set,
                                           const CheckpointFile* from, int threads, bool quiet, Prepared& prepared,
                                           RunLog& log) {
    const SceneVariants runs(reading.scene.file, {}, threads, quiet);
    std::optional<AccuracyRecord> record;
    if (from != nullptr) {
        record = record_from_text(from->head().accuracy);
    } else {
        record = choose_cells(
            reading, prepared, coarse_scheme(reading, set), [&](const Scene& scene) { return runs.run(scene); }, log);
    }
    RunLog silent(true);  // messages were given for the scene's own cells
    if (record && !record->is_finest()) prepared = prepare_level(reading, prepared, record->chosen_cell_size, silent);
    return record;
}

// Completes the record with the finest level, from the run. None if the run did not end.
std::optional<AccuracyRecord> completed_record(const std::optional<AccuracyRecord>& before, const Prepared& prepared,
                                               const RunResult& result) {
    if (!before || result.stop_reason == StopReason::requested || !result.run_problems.empty()) return std::nullopt;
    AccuracyRecord record = *before;
    if (record.is_finest()) record.levels.push_back(level_of(result, prepared, prepared.scene.terrain));
    return record;
}

/// Names the gauges that stayed dry: they may lie beside the channel.
void log_dry_gauges(const RunResult& result, const Scene& scene, RunLog& log) {
    std::vector<std::string> dry;
    for (const Gauge& gauge : scene.recording.gauges) dry.push_back(gauge.name);
    for (const GaugeRow& row : result.gauges)
        if (row.depth > scene.numerics.minimum_depth) dry[row.gauge].clear();
    std::erase(dry, "");
    if (!dry.empty()) log.info("gauges not reached: " + joined(dry, ", "));
}

void log_run(const RunResult& result, double end, Findings found) {
    RunLog& log = found.log;
    log.info("computed " + number_text(result.simulated_seconds, 4) + " s in " + std::to_string(result.steps) +
             " steps and " + number_text(result.engine_seconds, 3) +
             " s of wall time: " + describe(result.stop_reason));
    if (result.exchanges) {
        log.info("the flow eroded " + number_text(result.volume_eroded, 4) + " m3 and deposited " +
                 number_text(result.volume_deposited, 4) + " m3 on its bed");
    }
    if (result.jumps) {
        const RunResult::Jumps& jumps = *result.jumps;
        const auto metres = [](double value) { return std::to_string(std::llround(value)); };
        log.info("material flew over edges, " + number_text(jumps.volume, 4) + " m3 in all jumps together: up to " +
                 number_text(jumps.highest, 3) + " m above the ground and " + number_text(jumps.longest, 3) +
                 " m long, from (" + metres(jumps.from.x) + ", " + metres(jumps.from.y) + ") to (" +
                 metres(jumps.to.x) + ", " + metres(jumps.to.y) + "); see jump_height.tif");
    }
    if (result.unsupported > 0) {
        log.note("over convex ground the motion lifted the flow off its bed at " + std::to_string(result.unsupported) +
                 " node-steps; there it had no friction");
    }
    if (result.stop_reason == StopReason::requested) {
        found.warn(worded("stopped at {1} s of {2} s: maps incomplete; --resume continues it",
                          {numeral(number_text(result.simulated_seconds, 4)), numeral(number_text(end, 4))}));
    }
}

// Computes and writes; returns the exit code.
int run_into(const RunInput& input, CheckpointFile* from, ResultDirectory& directory, Findings found) {
    RunLog& log = found.log;
    const Prepared& prepared = input.prepared;
    const bool particles = writes_particles(prepared.spec.output);
    FrameWriter frames(directory.path(k_frame_folder), provenance(prepared), particles,
                       from != nullptr ? from->head().frame_times : std::vector<double>{},
                       from != nullptr ? from->head().frame_records : std::vector<FrameRecord>{});
    const bool has_frames = prepared.scene.time.frame_interval > 0;
    if (has_frames) directory.make_folder(k_frame_folder);
    publish_ground(prepared, directory);
    FrameWriter* const written_frames = has_frames ? &frames : nullptr;
    Checkpoints checkpoints(directory.folder(), prepared.spec.output.checkpoint_interval, prepared, written_frames,
                            input.since_start, input.earlier_seconds,
                            input.accuracy ? record_text(*input.accuracy) : "", found);
    ProgressReporter progress(input.quiet, input.json_progress);
    RunOptions options = run_options(input.threads, written_frames, particles, progress, checkpoints, found);
    if (from != nullptr) options.saved = &from->state();
    const RunResult result = run(prepared.scene, options);
    progress.finish();
    frames.require_good();
    log_run(result, prepared.scene.time.end, found);
    log_dry_gauges(result, prepared.scene, log);

    const std::optional<AccuracyRecord> accuracy = completed_record(input.accuracy, prepared, result);
    const PictureOutcome pictures =
        publish({prepared, result, input.threads, input.input_seconds, input.earlier_seconds, input.since_start,
                 accuracy ? &*accuracy : nullptr, std::exchange(found.warnings, {})},
                directory, frames, log);
    // An exit code other than 0 keeps everything that --resume needs to complete the run.
    const bool stopped = result.stop_reason == StopReason::requested || pictures.was_stopped;
    const int code =
        stopped ? static_cast<int>(ExitCode::signal) + stop_signal() : static_cast<int>(exit_code(result, pictures));
    const bool finished = code == static_cast<int>(ExitCode::done);
    directory.publish({provenance(prepared).at("SCENE_HASH"), result.simulated_seconds, finished}, found);
    if (finished) remove_working_files(directory.target(), !prepared.spec.output.frames, found);
    // The estimate of a study applies to the scene's own cells.
    if (const auto estimate = read_error_estimate(directory.target(), prepared.spec); estimate && !input.accuracy)
        log.info("error estimate of `frana converge`:\n" + *estimate);
    log.info("result in " + directory.target());
    if (code != static_cast<int>(ExitCode::done) && !stopped) log.print_deferred_warnings();
    const bool refused = finished && input.strict && is_open(result, input.prepared.scene);
    if (refused) log.print_deferred_warnings();
    return refused ? static_cast<int>(ExitCode::numerical) : code;
}

bool wants_json_progress(const Options& values) {
    const auto progress = text_option(values, "progress");
    if (progress && *progress != "json")
        throw Error(ErrorKind::input, Problem{"is not a form of progress", "--progress", *progress, "json", ""});
    return progress.has_value();
}

/// A region, a study or a calibration has a command of its own.
void require_scene(const std::string& file) {
    const auto refuse = [&](const std::string& what, const std::string& command) {
        throw Error(ErrorKind::input, Problem{"is " + what + ", not a scene", file, "", "",
                                              "`frana " + command + " " + file + "` runs it"});
    };
    const auto kind = study::study_kind(file);
    if (kind == study::StudyKind::region) refuse("a region of many slopes", "batch");
    if (kind == study::StudyKind::ensemble) refuse("a study of many runs", "ensemble");
    if (kind == study::StudyKind::calibration) refuse("a calibration", "calibrate");
}

/// Whether a folder contains a complete result.
bool is_finished(const std::string& directory) {
    const auto manifest = read_manifest(directory);
    return manifest && manifest->finished;
}

/// Throws Error(input) if the finished result in a folder is of another scene, or lacks files that only a run writes.
void require_complete(const Prepared& prepared, const std::string& directory) {
    const auto then = result_identity(directory);
    const std::string here = scene_identity(prepared);
    if (then != here)
        throw Error(ErrorKind::input,
                    Problem{"contains the finished result of another scene: " +
                                (then ? joined(identity_differences(here, *then), "; ") : "an older frana's"),
                            directory, "", "", "Choose another folder with --out, or add --overwrite"});
    std::vector<std::string> missing;
    const Manifest manifest = read_manifest(directory).value_or(Manifest{});
    for (const auto& [name, bytes] : manifest.files) {
        const ResultFile* const file = existing_file(name);
        const bool wanted = file != nullptr && !file->is_drawn() && file->kind != FileKind::working &&
                            file->kind != FileKind::style && !name.ends_with(".gpkg");  // GIS write into these
        if (wanted && !is_as_listed((std::filesystem::path(directory) / name).string(), bytes)) missing.push_back(name);
    }
    if (!missing.empty())
        throw Error(ErrorKind::input,
                    Problem{"files of the result are missing or not as the run wrote them: " + joined(missing, ", "),
                            directory, "", "", "Restore them, or compute the scene again with --overwrite"});
}

/// @param later what its summary does not say
int run_scene(const Options& values, std::string& target, RunLog& log, Warnings& later) {
    const Stopwatch since_start;
    const int threads = thread_count(values);
    const bool quiet = values.count("quiet") > 0;
    const bool overwrite = values.count("overwrite") > 0;
    const bool json_progress = wants_json_progress(values);
    const Session session = session_of(values, log);

    require_scene(values["operand"].as<std::string>());
    SceneReading reading = read_scene(values["operand"].as<std::string>(), overrides(values), share_directory());
    reading.session = session;
    const Findings found{log, later};
    found.warn_all(changed_inputs(reading));
    const auto out = text_option(values, "out");
    const std::string place = out.value_or(output_directory(reading.scene));
    target = result_path(place);
    const bool resume = values.count("resume") > 0;
    const InterruptedRun interrupted(target);
    const bool is_complete = resume && !overwrite && !interrupted.any() && is_finished(target);
    std::optional<Problem> place_problem;
    if (!is_complete)
        place_problem = check_result_directory(
            place, overwrite || (resume && interrupted.in_place()) ? Older::replaced : Older::refused,
            input_files(reading.scene), out ? "--out" : reading.where("output.directory"), reading.problems);
    if (!resume && !overwrite) refuse_to_discard(interrupted, target, reading.problems);
    log.note(std::string(k_program) + " " + k_version + ", scene " + reading.scene.file + ", " +
             std::to_string(threads) + " threads");
    Prepared prepared = prepare(reading, place_problem, found);
    prepared.scene.warnings += log.tell(doubt_ground(reading, prepared));
    found.warn_all(doubt_exposure(prepared));
    prepared.result_folder = target;
    if (is_complete) {
        require_complete(prepared, target);
        remove_working_files(target, !prepared.spec.output.frames, found);  // a run was killed before it did this
        log.info("the result is complete: " + target);
        return static_cast<int>(ExitCode::done);
    }
    load_drawing(prepared.spec);
    const std::int64_t in_use = resident_memory();
    const RunEstimate expected = estimate(prepared.scene, threads);
    refuse_run_beyond_memory(reading, prepared, in_use, expected, threads);
    const double input_seconds = since_start.seconds();
    const std::unique_ptr<CheckpointFile> from =
        resume && interrupted.any() ? interrupted.choose(scene_identity(prepared), log) : nullptr;
    if (from) {
        log_resuming(*from, found);
    } else if (resume) {
        log.info("there is no checkpoint: starting from the beginning");
    }
    const double earlier = from ? from->head().wall_seconds : 0;

    catch_stop_signals();
    std::optional<AccuracyRecord> accuracy;
    if (prepared.spec.numerics.accuracy) {
        accuracy = put_on_cells(reading, overrides(values), from.get(), threads, quiet, prepared, log);
        if (!accuracy) {
            log.info("stopped while coarser levels were computed: nothing was written, nothing can be resumed");
            return static_cast<int>(ExitCode::signal) + stop_signal();
        }
    }
    prepared.result_folder = target;  // also of the chosen cells
    if (from && from->head().origin) put_origin(prepared.scene, *from->head().origin);
    ResultDirectory directory(target, overwrite || (from && interrupted.in_place()),
                              from && is_in_partial(*from, target));
    if (from) restore_files(*from, directory);
    try {
        return run_into({prepared, threads, quiet, json_progress, values.count("strict") > 0, input_seconds, earlier,
                         since_start, accuracy},
                        from.get(), directory, found);
    } catch (const Error& error) {
        explain_problem(error, directory.folder());
    }
}

/// What --json says of a run, from the files of its result.
void print_run_document(const std::string& target, int code, const Warnings& later) {
    Json document = document_of("run");
    document["exit_code"] = code;
    document["result"] = target;
    const auto manifest = read_manifest(target);
    document["finished"] = code == static_cast<int>(ExitCode::done);
    document["summary"] = read_json_file((std::filesystem::path(target) / k_summary_file).string()).value_or(Json());
    document["warnings"] = document["summary"].is_object() ? document["summary"]["warnings"] : Json::array();
    for (const std::string& text : texts_of(later)) document["warnings"].push_back(text);
    document["files"] = Json::array();
    if (manifest)
        for (const auto& [name, bytes] : manifest->files) document["files"].push_back(name);
    print_document(document);
}

int cmd_run(const Options& values) {
    RunLog log(values.count("quiet") > 0);
    Warnings later;
    std::string target;
    const int code = run_scene(values, target, log, later);
    if (values.count("json") > 0) print_run_document(target, code, later);
    return code;
}

}  // namespace

Command command_run() {
    CommandForm form{"frana run SCENE.ini [options]",
                     "Computes a scene and writes the result directory: GeoTIFFs, outlines, maps, animation, series, "
                     "summary,\nand the comparison with an observed outline if one is given.",
                     "SCENE.ini",
                     {}};
    form.options.add_options()("out", one("FOLDER"),
                               "result directory, from the current folder (overrides output.directory)")(
        "set", many("KEY=VALUE"),
        "section.key=value, overrides the scene; repeatable; paths are relative to the scene file")(
        "threads", one("N"), "number of threads (default: all processors)")("overwrite", "replace an existing result")(
        "strict", k_strict_meaning)("resume",
                                    "resume a run that was stopped or killed; without one, start at the beginning")(
        "accuracy", one("PERCENT"),
        "allowed error by estimate (5%): coarser cells as far as it allows (overrides numerics.accuracy)")(
        "memory-limit", one("SIZE"), "refuse a run that would need more (4GB, 500MB)")(
        "quiet,q", "no progress, no warnings on the terminal (they are in log.txt)")(
        "progress", one("json"), "a line of JSON on stderr twice a second: fraction, simulated time, time left")(
        "json", "print one JSON document for scripts instead (share/doc/scripts.md)");
    return {"run", "compute a scene; write rasters, maps, animation, comparison", form, cmd_run};
}

}  // namespace frana::app
