// SPDX-License-Identifier: Apache-2.0
#include "app/checkpoints.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/number_text.h"
#include "app/scene_identity.h"
#include "core/error.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_kept = 2;
constexpr const char *k_beginning = "step_", *k_ending = ".frana";

// So many digits that names sort as steps do.
std::string file_name(std::int64_t step) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%015lld", static_cast<long long>(step));
    return std::string(k_beginning) + digits + k_ending;
}

}  // namespace

std::vector<std::string> checkpoints_in(const std::string& directory) {
    std::vector<std::string> files;
    std::error_code failure;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(directory) / k_checkpoint_folder, failure)) {
        const std::string name = entry.path().filename().string();
        if (name.size() == file_name(0).size() && name.starts_with(k_beginning) && name.ends_with(k_ending))
            files.push_back(entry.path().string());
    }
    std::sort(files.rbegin(), files.rend());
    return files;
}

Checkpoints::Checkpoints(std::string directory, double interval, const Prepared& prepared,
                         FrameWriter* frames, const Stopwatch& since_start, double earlier, RunLog& log)
    : directory_(std::move(directory)),
      interval_(interval),
      prepared_(prepared),
      frames_(frames),
      since_start_(since_start),
      earlier_(earlier),
      log_(log) {}

void Checkpoints::save(const Progress& now, const SaveState& state) {
    if (frames_ != nullptr) frames_->settle();
    if (identity_.empty()) identity_ = scene_identity(prepared_);
    try {
        const Stopwatch watch;
        const fs::path folder = fs::path(directory_) / k_checkpoint_folder,
                       path = folder / file_name(now.step);
        std::error_code failure;
        fs::create_directories(folder, failure);
        if (failure)
            throw Error(ErrorKind::environment,
                        Problem{"cannot be made", folder.string(), failure.message(), "", ""});
        log_.note("checkpoint at " + figure(now.time, 6) + " s, step " + std::to_string(now.step));
        write_checkpoint(
            path.string(),
            {checkpoint_build(), identity_, now.step, now.time, now.end, earlier_ + since_start_.seconds(),
             frames_ != nullptr ? frames_->times() : std::vector<double>{}, log_.lines()},
            state);
        log_.note("checkpoint of " + figure(static_cast<double>(fs::file_size(path)) / 1e6, 3) +
                  " MB written in " + figure(watch.seconds(), 2) + " s");
        const std::vector<std::string> all = checkpoints_in(directory_);
        for (std::size_t i = k_kept; i < all.size(); ++i) fs::remove(all[i], failure);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::environment) throw;
        if (!std::exchange(warned_, true)) log_.warn(error.what());
    }
    since_last_ = Stopwatch();
}

}  // namespace frana::app
