// SPDX-License-Identifier: Apache-2.0
#include "app/store/interrupted_run.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/store/checkpoints.h"
#include "app/store/frame_store.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "core/error.h"
#include "core/files.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr const char *k_record_beginning = "records_", *k_record_ending = ".frana";

}  // namespace

std::string record_file(const std::string& folder, int number) {
    char name[40];
    std::snprintf(name, sizeof name, "%s%05d%s", k_record_beginning, number, k_record_ending);
    return (fs::path(folder) / k_record_folder / name).string();
}

std::vector<std::string> records_in(const std::string& folder) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder) / k_record_folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory())
            for (std::string& file : records_in(entry.path().string())) files.push_back(std::move(file));
        const bool partial = name.find(".partial") != std::string::npos;
        if (name.starts_with(k_record_beginning) && name.ends_with(k_record_ending) && !partial)
            files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool has_saved_work(const std::string& folder) {
    return !checkpoints_in(folder).empty() || !records_in(folder).empty();
}

namespace {

/// The partial folder of a run that no longer exists; empty: none.
std::string left_by_killed_run(const std::string& directory) {
    const std::string partial = partial_folder(directory);
    return is_being_built(partial) && !is_locked(partial) ? partial : "";
}

}  // namespace

std::string interrupted_study(const std::string& directory) {
    const std::string partial = left_by_killed_run(directory);
    return partial.empty() || records_in(partial).empty() ? "" : partial;
}

namespace {

fs::path result_of(const std::string& checkpoint) {
    return fs::path(checkpoint).parent_path().parent_path();
}

// Returns why a checkpoint cannot be resumed; empty: it can.
std::string obstacle(const CheckpointFile& checkpoint, const std::string& identity) {
    const CheckpointHead& head = checkpoint.head();
    if (head.scene != identity)
        return "is from another scene: " + joined(identity_differences(identity, head.scene), "; ");
    const std::string problem = frame_problem(frames_of_run(result_of(checkpoint.path()).string()), head.frame_records);
    return problem.empty() ? "" : "needs a frame that " + problem;
}

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
    throw Error(ErrorKind::environment,
                Problem{"the files of an interrupted run cannot be taken over: " + error.message(), path.string(), "",
                        "", "Check the disk's space and the rights"});
}

// Links a file to a second name, if the file system supports that; else copies it.
void link(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (error) fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
    if (error) fail(from, error);
}

// Frames that were cut for a result that did not become complete.
void put_back_whole(const fs::path& whole, const fs::path& frames) {
    if (whole == frames) return;
    std::error_code error;
    fs::remove_all(frames, error);
    if (!error) fs::rename(whole, frames, error);
    if (error) fail(whole, error);
}

}  // namespace

InterruptedRun::InterruptedRun(const std::string& directory) {
    const std::optional<Manifest> manifest = read_manifest(directory);
    const std::string partial = left_by_killed_run(directory);
    if (!manifest || !manifest->finished) checkpoints_ = checkpoints_in(directory);
    in_place_ = !checkpoints_.empty();
    const std::vector<std::string> found = partial.empty() ? std::vector<std::string>{} : checkpoints_in(partial);
    if (!found.empty()) beside_ = partial;
    checkpoints_.insert(checkpoints_.begin(), found.begin(), found.end());
    // Of two at the same step, the one in its own folder is first: it needs no links.
    std::stable_sort(checkpoints_.begin(), checkpoints_.end(), [](const std::string& a, const std::string& b) {
        return fs::path(a).filename() > fs::path(b).filename();
    });
}

std::unique_ptr<CheckpointFile> InterruptedRun::choose(const std::string& identity, RunLog& log) const {
    if (checkpoints_.empty()) return nullptr;
    std::vector<Problem> reasons;
    for (const std::string& path : checkpoints_) {
        try {
            auto checkpoint = std::make_unique<CheckpointFile>(path);
            const std::string why = obstacle(*checkpoint, identity);
            if (why.empty()) {
                for (const Problem& reason : reasons) log.info("checkpoint not used: " + describe(reason));
                return checkpoint;
            }
            reasons.push_back({why, path, "", "", ""});
        } catch (const Error& error) {
            reasons.push_back(error.problems().front());
        }
    }
    reasons.push_back({"the run cannot be resumed from any checkpoint", "--resume", "", "",
                       "Restore the scene as it was, or run it from its start: --overwrite without --resume"});
    throw Error(ErrorKind::input, reasons);
}

bool is_in_partial(const CheckpointFile& checkpoint, const std::string& directory) {
    return result_of(checkpoint.path()) == partial_folder(directory);
}

void restore_files(const CheckpointFile& checkpoint, const ResultDirectory& directory) {
    const fs::path from = result_of(checkpoint.path()), to = directory.path("");
    const std::string name = fs::path(checkpoint.path()).filename().string();
    const std::size_t frames = checkpoint.head().frame_times.size();
    const fs::path run_frames = frames_of_run(from.string());
    if (fs::path(directory.folder()) == from) {
        put_back_whole(run_frames, to / k_frame_folder);
        const std::error_code error = remove_own_files(to.string(), [&](const std::string& path) {
            const fs::path folder = fs::path(path).parent_path(), file = fs::path(path).filename();
            const auto frame = frame_index(file);
            return path == k_building_file || (folder == k_frame_folder && frame && *frame < frames) ||
                   (folder == k_checkpoint_folder && file.string() <= name && !file_in_making(file));
        });
        if (error) fail(to, error);
        return;
    }
    directory.make_folder(k_checkpoint_folder);
    directory.make_folder(k_frame_folder);
    for (const std::string& file : names_of_frames(run_frames.string(), frames))
        link(run_frames / file, to / k_frame_folder / file);
    link(checkpoint.path(), to / k_checkpoint_folder / name);
}

}  // namespace frana::app
