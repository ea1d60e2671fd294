// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "app/store/partial_folder.h"
#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Content of a result's manifest besides its files.
struct ResultFacts {
    std::string scene_hash;
    double simulated_seconds = 0;
    bool finished = false;  ///< nothing remains to be computed or drawn
};

/// A result is built in the partial folder beside its place and renamed when it is complete: a run that fails leaves an
/// older result unchanged.
class ResultDirectory {
  public:
    /// Makes the partial folder, or takes over that of a killed run, and locks it. Throws Error(environment), and
    /// Error(input) if another run is writing the same result or the folder contains files of the user's.
    /// @param resumes whether the work of the killed run stays
    ResultDirectory(const std::string& directory, bool overwrite, bool resumes);
    /// Removes the partial folder unless it was published or has work to resume from (has_saved_work).
    ~ResultDirectory();
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    /// The partial folder.
    [[nodiscard]] const std::string& folder() const noexcept { return partial_; }
    /// The place of the result.
    [[nodiscard]] const std::string& target() const noexcept { return directory_; }
    /// Returns a path inside the partial folder.
    [[nodiscard]] std::string path(const std::string& name) const;
    /// Makes a folder inside it. Throws Error(environment).
    void make_folder(const std::string& name) const;
    /// Lists its files in the manifest, renames it to the result's place and removes an older result. Throws
    /// Error(environment) if the result cannot be renamed or meanwhile files of the user's are in its place: then it is
    /// kept in the partial folder, for --resume.
    void publish(const ResultFacts& facts, RunLog& log);

  private:
    void take_over() const;
    void replace_older();

    std::string directory_, partial_;
    bool overwrite_, published_ = false;
    std::optional<FolderLock> lock_;  ///< of the partial folder
};

/// Removes from a complete result what only an unfinished run needs: checkpoints, frames that were only made for an
/// animation, unfinished files of killed programs, the partial folder. Files that cannot be removed remain listed, with
/// a warning. Throws Error(environment) if the list cannot be read or written.
void remove_working_files(const std::string& result, bool frames, RunLog& log);

}  // namespace frana::app
