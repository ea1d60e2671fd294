// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/error_estimate.h"
#include "app/number_text.h"
#include "app/progress.h"
#include "app/provenance.h"
#include "app/publish.h"
#include "app/share_directory.h"
#include "app/signals.h"
#include "app/version.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

CommandForm run_form() {
    namespace options = boost::program_options;
    CommandForm form{
        "frana run SCENE.ini [options]",
        "Computes a scene and writes the result directory: GeoTIFFs, outlines, maps, animation, series, "
        "summary,\nand the comparison with a scar where one is given.",
        "SCENE.ini",
        {}};
    form.options.add_options()("out", options::value<std::string>(),
                               "result directory, from the current folder (overrides output.directory)")(
        "set", options::value<std::vector<std::string>>(),
        "section.key=value, overrides the scene; repeatable; paths count from the scene file")(
        "threads", options::value<std::string>(), "number of threads (default: all processors)")(
        "overwrite", "replace an existing result")("resume", "not available in this version")(
        "quiet,q", "no progress, no warnings on the terminal (they are in log.txt)");
    return form;
}

ExitCode exit_code(const RunResult& result, bool all_drawn) {
    switch (result.stop_reason) {
        // The map ends where the terrain does: a script must not take it for a whole one.
        case StopReason::reached_no_data:
        case StopReason::non_finite:
            return ExitCode::numerical;
        default:
            return all_drawn ? ExitCode::done : ExitCode::environment;
    }
}

RunOptions run_options(int threads, FrameWriter* frames, bool with_particles, ProgressReporter& progress) {
    RunOptions run_with;
    run_with.threads = threads;
    run_with.particles_in_frames = with_particles;
    if (frames != nullptr) run_with.on_frame = [frames](Frame frame) { frames->add(std::move(frame)); };
    run_with.on_progress = [&progress](const Progress& now) { progress.show(now); };
    run_with.stop_requested = [] { return stop_signal() != 0; };
    return run_with;
}

}  // namespace

int cmd_run(const Arguments& arguments) {
    const Stopwatch since_start;
    const auto values = parse_arguments(run_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    if (values->count("resume") > 0) {
        throw Error(ErrorKind::input, Problem{"resuming a run is not available in this version", "--resume",
                                              "", "", "Run the scene from its start"});
    }
    const int threads = thread_count(*values);
    const bool quiet = values->count("quiet") > 0;
    const bool overwrite = values->count("overwrite") > 0;
    RunLog log(quiet);

    SceneReading reading = read_scene((*values)["operand"].as<std::string>(), text_options(*values, "set"),
                                      materials_directory());
    const auto out = text_option(*values, "out");
    const std::string target =
        out ? std::filesystem::absolute(*out).string() : output_directory(reading.scene);
    check_result_directory(target, overwrite, input_files(reading.scene),
                           out ? "--out" : reading.where("output.directory"), reading.problems);
    log.note(std::string(k_program) + " " + k_version + ", scene " + reading.scene.file + ", " +
             std::to_string(threads) + " threads");
    const Prepared prepared = prepare(reading, log);
    const double input_seconds = since_start.seconds();

    catch_stop_signals();
    ResultDirectory directory(target, overwrite);
    const ParticleFormats particles = particle_formats(prepared.spec.output.formats);
    FrameWriter frames(directory.path("frames"), provenance(prepared), particles);
    const bool wants_frames = prepared.scene.time.frame_interval > 0;
    if (wants_frames) directory.make_folder("frames");
    ProgressReporter progress(quiet);
    const RunResult result =
        run(prepared.scene, run_options(threads, wants_frames ? &frames : nullptr, particles.any(), progress));
    progress.finish();
    log.tell("computed " + figure(result.simulated_seconds, 4) + " s in " + std::to_string(result.steps) +
             " steps and " + figure(result.engine_seconds, 3) +
             " s of wall time: " + describe(result.stop_reason));
    if (result.exchanges) {
        log.tell("the flow eroded " + figure(result.volume_eroded, 4) + " m3 and deposited " +
                 figure(result.volume_deposited, 4) + " m3 in its bed");
    }
    if (result.unsupported > 0) {
        log.note("over convex ground the motion lifted the flow off its bed at " +
                 std::to_string(result.unsupported) + " nodes times steps; there it had no friction");
    }

    const bool all_drawn =
        publish({prepared, result, threads, input_seconds, since_start}, directory, frames, log);
    directory.publish();
    if (const auto estimate = read_error_estimate(target, prepared.spec))
        log.tell("error estimate of `frana converge`:\n" + *estimate);
    log.tell("result in " + target);
    if (stop_signal() != 0) return static_cast<int>(ExitCode::signal) + stop_signal();
    return static_cast<int>(exit_code(result, all_drawn));
}

}  // namespace frana::app
