// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/store/own_files.h"
#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Returns the real place of a result directory: absolute, without trailing slashes.
std::string result_path(const std::string& directory);

/// What a command may do with an older result: `unknown` to `frana check`, whose run is another command.
enum class Older { refused, replaced, unknown };

/// Checks, before anything is computed, whether a result can be written to a directory. Adds to `problems`: an existing
/// result without permission to overwrite it, a folder that is not a result, users' files in either or in the partial
/// folder (none is ever overwritten), inputs inside the folder, another run that is writing the result, a place that is
/// a symbolic link or has too long a name. Returns the problem of the environment: a place that cannot be read or
/// written.
[[nodiscard]] std::optional<Problem> check_result_directory(const std::string& directory, Older older,
                                                            const std::vector<std::string>& inputs, const Place& where,
                                                            Problems& problems);

/// Another run is writing a result.
Problem other_run(const std::string& result);
/// Returns why a partial folder that no run has locked cannot be emptied; none: it can. Throws Error(environment).
std::optional<Problem> partial_problem(const std::string& partial);

/// Returns whether a folder has any entry; one that cannot be read counts as not empty.
bool has_files(const std::string& folder);

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
    void publish(const ResultFacts& facts, Findings found);

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
void remove_working_files(const std::string& result, bool frames, Findings found);

}  // namespace frana::app
