// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// A result directory's path, absolute and without trailing slashes.
std::string result_path(const std::string& directory);

/// Looks, before anything is computed, whether a result can be written to a directory. Adds to `problems`: an
/// existing result without leave to overwrite it, a folder that is no result (never overwritten), inputs
/// inside the folder to be replaced, a place that cannot be written. Throws Error(environment) for the last where
/// nothing else is wrong.
void check_result_directory(const std::string& directory, bool overwrite,
                            const std::vector<std::string>& inputs, const std::string& where,
                            Problems& problems);

/// Folders beside a result in which one was being built by runs that are no more.
std::vector<std::string> left_results(const std::string& directory);

/// Folders beside a result in which one is or was being built, the latest first.
std::vector<std::string> unfinished_results(const std::string& directory);

/// A result is built in a sibling folder and takes its name when it is whole: a run that fails leaves an
/// older result as it was.
class ResultDirectory {
  public:
    /// Creates the sibling, or goes on in one that was left, and holds a lock on it. Throws Error(environment), and
    /// Error(input) where another run is writing the same result.
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
    /// Puts the sibling in the directory's place. Files of an older result are replaced as a whole; what the
    /// user laid beside them is kept, and what killed runs left of the same result goes. Throws Error(environment).
    void publish();

    /// Removes from the published result what only a run on its way needs: checkpoints, and frames from which a film
    /// was made, if so wished.
    void forget_the_way(bool frames) const;

  private:
    void make_sibling();
    void refuse_a_second_run();
    [[noreturn]] void refuse();
    void keep_users_files(const std::string& old) const;
    void remove_leftovers() const;

    std::string directory_;
    std::string aside_;
    bool overwrite_;
    bool published_ = false;
    bool made_;       ///< the sibling, by this run
    int lock_ = -1;  ///< descriptor of the locked sibling
};

}  // namespace frana::app
