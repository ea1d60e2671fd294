// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// What a result's manifest says of it besides its files.
struct ResultFacts {
    std::string scene_hash;
    double simulated_seconds = 0;
    bool finished = false;  ///< nothing is left to be computed or drawn
};

/// A result is built in a sibling folder and takes its name when it is whole: a run that fails leaves an
/// older result as it was.
class ResultDirectory {
  public:
    /// Creates the sibling, or goes on in one that was left, and holds a lock on it. Throws
    /// Error(environment), and Error(input) where another run is writing the same result.
    ResultDirectory(const std::string& directory, bool overwrite, const std::string& left = "");
    /// Removes the sibling unless it was published or has a checkpoint to go on from.
    ~ResultDirectory();
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    /// The sibling.
    [[nodiscard]] const std::string& folder() const noexcept { return aside_; }
    /// The directory whose place the sibling will take.
    [[nodiscard]] const std::string& target() const noexcept { return directory_; }
    /// A path inside the sibling.
    [[nodiscard]] std::string path(const std::string& name) const;
    /// Makes a folder inside the sibling. Throws Error(environment).
    void make_folder(const std::string& name) const;
    /// Lists the sibling's files in its manifest and puts it in the directory's place. An older result is
    /// taken apart, see replace_result(), and what killed runs left of the same result goes. Returns what of
    /// the older result could not be moved. Throws Error(environment) where the result cannot take its name;
    /// it is kept beside it.
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
    bool made_;      ///< the sibling, by this run
    int lock_ = -1;  ///< descriptor of the locked sibling
};

/// Beside a result that is in its place: takes apart the older result in `replaced` (empty: none) and those
/// that killed runs did not come to, and removes what killed runs have left of their own. Returns what could
/// not be moved. Throws Error(environment) where the place cannot be read.
std::vector<Problem> clear_place_of(const std::string& result, const std::string& replaced, RunLog& log);

/// Removes from a finished result what only a run on its way needs: checkpoints, frames from which a
/// animation was made if so wished, and files that killed programs had in the making. What cannot be removed stays
/// listed, with a warning. Throws Error(environment) where the list cannot be read or written.
void remove_working_files(const std::string& result, bool frames, RunLog& log);

}  // namespace frana::app
