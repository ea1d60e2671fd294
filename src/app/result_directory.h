// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace frana::app {

/// Looks, before anything is computed, whether a result can be written to a directory. Adds to `problems`: an
/// existing result without leave to overwrite it, a folder that is no result (never overwritten), inputs
/// inside the folder to be replaced, a place that cannot be written.
void check_result_directory(const std::string& directory, bool overwrite,
                            const std::vector<std::string>& inputs, const std::string& where,
                            Problems& problems);

/// A result is built in a sibling folder and takes its name when it is whole: a run that fails leaves an
/// older result as it was.
class ResultDirectory {
  public:
    /// Creates the sibling and holds a lock on it. Throws Error(environment), and Error(input) where another run is
    /// writing the same result.
    ResultDirectory(std::string directory, bool overwrite);
    /// Removes the sibling unless it was published.
    ~ResultDirectory();
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    /// A path inside the sibling.
    [[nodiscard]] std::string path(const std::string& name) const;
    /// Makes a folder inside the sibling. Throws Error(environment).
    void make_folder(const std::string& name) const;
    /// Puts the sibling in the directory's place. Files of an older result are replaced as a whole; what the
    /// user laid beside them is kept. Throws Error(environment).
    void publish();

  private:
    void refuse_a_second_run() const;

    std::string directory_;
    std::string aside_;
    bool overwrite_;
    bool published_ = false;
    int lock_ = -1;  ///< descriptor of the locked sibling
};

}  // namespace frana::app
