// SPDX-License-Identifier: Apache-2.0
#include "app/store/checkpoints.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "app/store/scene_identity.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/files.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_checkpoints_kept = 2;
constexpr const char *k_step_beginning = "step_", *k_step_ending = ".frana";

// Enough digits that names sort in the order of steps.
std::string file_name(std::int64_t step) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%015lld", static_cast<long long>(step));
    return std::string(k_step_beginning) + digits + k_step_ending;
}

// Does not create folders above it: a result's folder that was moved away is not created again.
void make_folder(const std::string& folder) {
    std::error_code error;
    fs::create_directory(folder, error);
    if (error) throw Error(ErrorKind::environment, Problem{"cannot be made", folder, error.message(), "", ""});
}

}  // namespace

std::vector<std::string> checkpoints_in(const std::string& directory) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : folder_entries(fs::path(directory) / k_checkpoint_folder)) {
        const std::string name = entry.path().filename().string();
        if (name.size() == file_name(0).size() && name.starts_with(k_step_beginning) && name.ends_with(k_step_ending))
            files.push_back(entry.path().string());
    }
    std::sort(files.rbegin(), files.rend());
    return files;
}

Checkpoints::Checkpoints(std::string directory, double interval, const Prepared& prepared, FrameWriter* frames,
                         const Stopwatch& since_start, double earlier, std::string accuracy, Findings found)
    : directory_(std::move(directory)),
      folder_((fs::path(directory_) / k_checkpoint_folder).string()),
      interval_(interval),
      prepared_(prepared),
      frames_(frames),
      since_start_(since_start),
      earlier_(earlier),
      accuracy_(std::move(accuracy)),
      found_(found) {}

void Checkpoints::after_step(const Progress& now, const SaveState& state) {
    if (now.last || (interval_ > 0 && since_last_.seconds() >= interval_)) save(now, state);
}

CheckpointHead Checkpoints::head(const Progress& now) {
    if (identity_.empty()) identity_ = scene_identity(prepared_);
    const GridSpec& grid = prepared_.scene.grid;
    return {checkpoint_build(),
            identity_,
            now.step,
            now.time,
            now.end,
            earlier_ + since_start_.seconds(),
            {},
            found_.log.lines(),
            OriginCell{grid.origin_column, grid.origin_row},
            {},
            accuracy_};
}

void Checkpoints::save(const Progress& now, const SaveState& state) {
    if (frames_ != nullptr && !frames_->settle()) return;  // the run ends with the frames' own problem
    const Stopwatch watch;
    const auto warn_once = [&](const Error& error) {
        if (error.kind() != ErrorKind::environment) throw error;
        if (!std::exchange(warned_, true)) found_.warn(std::string(error.what()));
    };
    attempt(warn_once, [&] {
        make_folder(folder_);
        found_.log.note("checkpoint at " + number_text(now.time, 6) + " s, step " + std::to_string(now.step));
        CheckpointHead described = head(now);
        if (frames_ != nullptr) {
            described.frame_times = frames_->times();
            described.frame_records = frames_->records();
        }
        const std::string path = (fs::path(folder_) / file_name(now.step)).string();
        const std::uint64_t bytes = write_checkpoint(path, std::move(described), state);
        found_.log.note("checkpoint of " + number_text(static_cast<double>(bytes) / 1e6, 3) + " MB written in " +
                        number_text(watch.seconds(), 2) + " s");
        const std::vector<std::string> all = checkpoints_in(directory_);
        std::error_code ignored;
        for (std::size_t i = k_checkpoints_kept; i < all.size(); ++i) fs::remove(all[i], ignored);
    });
    since_last_ = Stopwatch();
}

}  // namespace frana::app
