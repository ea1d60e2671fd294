// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <system_error>
#include <vector>

#include "app/text/run_log.h"

namespace frana::app {

/// A result is built in RESULT.partial, beside its place, and takes its name when it is complete. A result that it
/// replaces has that name until it is removed. A note in the folder says which of the two it is: one without a note, or
/// with that of a folder of another name, is not frana's.
inline constexpr const char* k_partial = ".partial";
/// Of an older result for a moment, where the two cannot be exchanged: RESULT.partial.old.
inline constexpr const char* k_waiting = ".old";
std::string partial_folder(const std::string& directory);

/// Writes a note to a partial folder that a result is being built in it. Throws Error(environment).
void note_building(const std::string& partial);
bool is_being_built(const std::string& folder);

/// Writes a note to a result that another one replaces it. Throws Error(environment).
void note_replaced(const std::string& result);
bool is_being_replaced(const std::string& folder);

/// The lock of a folder: the run that writes to it has it until it ends, however it ends.
class FolderLock {
  public:
    /// @param wait until no other process has it; otherwise it may not be held
    FolderLock(const std::string& folder, bool wait);
    ~FolderLock() { release(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    [[nodiscard]] bool is_held() const noexcept { return descriptor_ >= 0; }
    /// Why it is not held (errno): EWOULDBLOCK if another process has it.
    [[nodiscard]] int reason() const noexcept { return reason_; }
    /// Whether the locked folder still has this name.
    [[nodiscard]] bool is_of(const std::string& folder) const;
    void release();

  private:
    int descriptor_, reason_ = 0;
};
/// Whether another process has the lock of a folder.
bool is_locked(const std::string& folder);

/// Returns the user's files in a result or a partial folder, which nothing removes: all but
/// - those that frana wrote and nobody changed: as the folder's manifest lists them; in a folder in which a result is
///   being built, those with a name of frana's;
/// - those that killed programs of frana left half written;
/// - those that a GIS makes beside frana's when it shows them: NAME.aux.xml, NAME-shm, an empty NAME-wal, and NAME~,
/// the
///   copy of a project before it was saved.
/// Throws Error(environment) if something cannot be read.
std::vector<std::string> users_files(const std::string& folder);
/// "3 files that frana did not write, or that were changed since: a, b (changed), c"
std::string told(const std::vector<std::string>& users_files);

/// Removes all others and the folders that become empty; list and notes last, so that the next run can complete it.
/// @param is_kept further files that stay, by their path in the folder
/// Returns the reason why something could not be removed. Throws Error(environment) if something cannot be read.
std::error_code remove_own_files(const std::string& folder,
                                 const std::function<bool(const std::string& name)>& is_kept = {});

/// Removes what is beside a complete result: the one that it replaced, or what a killed run left; and the note in it.
/// What remains is told. Throws Error(environment) if the place cannot be read.
void remove_partial(const std::string& result, RunLog& log);

}  // namespace frana::app
