// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/command_line.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "bench/accuracy/accuracy.h"
#include "bench/speed/speed.h"
#include "render/canvas/image.h"

namespace frana::app {

/// Draws accuracy.png: l1_depth against processor time, logarithmic, a panel for each case, a line for each scheme.
/// Panels of cases with only rounding errors have a note.
render::Image accuracy_chart(const std::vector<bench::AccuracyRow>& rows);

/// Draws speed.png: particle-steps per second against particles, a panel for each flow, a line for each number of
/// threads.
render::Image speed_chart(const bench::SpeedResult& result);

/// The files of a bench and their folder.
class BenchOutput {
  public:
    BenchOutput(std::string folder, const std::vector<const char*>& names) : folder_(std::move(folder)) {
        for (const char* name : names) files_.push_back(path(name));
    }
    [[nodiscard]] std::string path(const std::string& name) const {
        return (std::filesystem::path(folder_) / name).string();
    }
    [[nodiscard]] const std::vector<std::string>& files() const noexcept { return files_; }
    /// Call before the first file is written.
    void begin() const { begin_own(folder_, files_); }
    /// Call after the last.
    void list() const { record_files(files_); }

  private:
    std::string folder_;
    std::vector<std::string> files_;
};

/// Returns the output of --out, if given; the folder is made before anything is computed, so that an invalid one is
/// reported first.
/// Throws Error(input) if a file would replace one that frana did not write, Error(environment).
std::optional<BenchOutput> bench_output(const Options& values, const std::vector<const char*>& names);

/// Prints the text of a bench; returns the exit code.
int print_bench(const std::string& text, bool good = true);

}  // namespace frana::app
