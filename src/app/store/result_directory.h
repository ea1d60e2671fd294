// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// Content of a result's manifest besides its files.
struct ResultFacts {
    std::string scene_hash;
    double simulated_seconds = 0;
    bool finished = false;  ///< nothing remains to be computed or drawn
};

/// A result is built in a sibling folder and renamed when it is complete: a run that fails leaves an older result
/// unchanged.
class ResultDirectory {
  public:
    /// Creates the sibling, or continues in an unfinished one, and locks it. Throws Error(environment), and
    /// Error(input) if another run is writing the same result.
    ResultDirectory(const std::string& directory, bool overwrite, const std::string& left = "");
    /// Removes the sibling unless it was published or has work to resume from (has_saved_work).
    ~ResultDirectory();
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    /// The sibling.
    [[nodiscard]] const std::string& folder() const noexcept { return aside_; }
    /// The directory that the sibling will replace.
    [[nodiscard]] const std::string& target() const noexcept { return directory_; }
    /// Returns a path inside the sibling.
    [[nodiscard]] std::string path(const std::string& name) const;
    /// Makes a folder inside the sibling. Throws Error(environment).
    void make_folder(const std::string& name) const;
    /// Lists the sibling's files in its manifest and renames it to the directory. An older result is removed, see
    /// replace_result(), and so are remains of killed runs of the same result. Returns the files of the older result
    /// that could not be moved. Throws Error(environment) if the result cannot be renamed; it is kept beside the
    /// directory.
    [[nodiscard]] std::vector<Problem> publish(const ResultFacts& facts, RunLog& log);

  private:
    void make_sibling();
    [[noreturn]] void refuse();
    void replace_in_steps(bool replaces);
    [[noreturn]] void keep_unpublished(const std::string& what, const std::string& reason);
    std::vector<Problem> tidy_up(bool replaces, RunLog& log);
    [[nodiscard]] std::string final_path(const std::string& name) const;

    std::string directory_;
    std::string aside_;
    bool overwrite_;
    bool published_ = false;
    bool made_;      ///< the sibling, created by this run
    int lock_ = -1;  ///< descriptor of the locked sibling
};

/// For a published result: removes the older result in `replaced` (empty: none) and those that killed runs left
/// unprocessed, and removes the remains of killed runs. Returns the files that could not be moved. Throws
/// Error(environment) if the place cannot be read.
std::vector<Problem> clear_place_of(const std::string& result, const std::string& replaced, RunLog& log);

/// Removes from a complete result the files that only an unfinished run needs: checkpoints, frames that were only made
/// for an animation, and unfinished files of killed programs. Files that cannot be removed remain listed, with a
/// warning. Throws Error(environment) if the list cannot be read or written.
void remove_working_files(const std::string& result, bool frames, RunLog& log);

}  // namespace frana::app
