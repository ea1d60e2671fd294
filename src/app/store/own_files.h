// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <system_error>
#include <vector>

#include "app/text/run_log.h"
#include "core/error.h"

namespace frana::app {

/// A result is built in RESULT.partial, beside its place, and takes its name when it is complete. A result that it
/// replaces has that name until it is removed. A note in the folder says which of the two it is: one without a note, or
/// with that of a folder of another name, is not frana's.
inline constexpr const char* k_partial = ".partial";
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
void remove_partial(const std::string& result, Findings found);

/// Returns the paths that the value of a key may mean: a file, or one in GDAL's syntax ("file|layer=a",
/// "DRIVER:file:part", "/vsizip/file/part").
std::vector<std::string> spellings(const std::string& source);

/// Throws Error(input) for outputs that are inputs, whatever path, symbolic link or second name leads to them. `where`
/// names the option that specifies the place.
void refuse_inputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs, const Place& where,
                   Problems& problems);

/// For commands that write to a folder which need not be a result: they replace only files written by frana. These are
/// listed in the manifest of the result that is or contains the folder, or in one of the folder.

/// Adds a problem for a folder that is, or is in, a result other than those read, since files of different results
/// would mix; and for every output that exists and is not as frana's list of files has it, since it is the user's.
/// @param where the option that specifies the place
/// @param reads results, or files in them, that the command reads and may write into
void check_own(const std::string& folder, const std::vector<std::string>& files, const Place& where,
               const std::vector<std::string>& reads, Problems& problems);

/// Makes a folder of a result for pictures, if it is not there. Throws Error(environment), also where its name is a
/// symbolic link, through which files would be written elsewhere.
void make_drawing_folder(const std::string& folder);

/// Call before the first of the files is written: makes the folder and a list in one without, so that files are
/// identified after a kill; record_files() lists them at the end. Throws Error(environment), also for files that were
/// changed since check_own().
void begin_own(const std::string& folder, const std::vector<std::string>& files);

}  // namespace frana::app
