// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Between a result's name and the random part of its siblings: RESULT.partial-Ab12Cd.
inline constexpr const char* k_building = ".partial-";

/// Writes a note to a folder beside a result that the result is being built in it. Throws Error(environment).
void note_building(const std::string& folder, const std::string& result);
/// Returns whether a folder has such a note with its own name: a copy does not.
bool is_being_built(const std::string& folder);

/// Writes a note to a result that another will replace it, and that it will then have this name until the user's files
/// in it are in the new one. Throws Error(environment).
void note_replaced(const std::string& result, const std::string& later_name);
/// Returns whether a folder is such an older result under its later name.
bool is_being_replaced(const std::string& folder);

/// Locks a folder until the returned descriptor is closed; the system releases the lock when the program ends, however
/// it ends. Returns -1, with errno, if another process has the lock; `wait`: waits until none has it.
int lock_folder(const std::string& folder, bool wait);

/// Returns the folders beside a result in which one is or was being built, the latest first: they have a note, or
/// checkpoints (of an older frana). This and the following throw Error(environment) if the place cannot be read.
std::vector<std::string> unfinished_results(const std::string& directory);
/// Returns those of runs that no longer exist.
std::vector<std::string> abandoned_results(const std::string& directory);
/// Returns whether another process has locked a folder beside a result other than `own`.
bool another_run_builds(const std::string& directory, const std::string& own);
/// Returns older results beside the one that replaced them, if a run was killed before it had moved the user's files.
std::vector<std::string> replaced_results(const std::string& directory);

/// Removes a folder in which a result was being built, if it has a note and every file in it is one that frana writes;
/// otherwise returns false and leaves it unchanged.
bool remove_unfinished(const std::string& folder);

/// Removes the note from a published result: a run was killed just before it would have done so.
void remove_note_of_building(const std::string& result);

/// Removes empty folders beside a result with a generated name: left by a kill, or a full disk, just after their
/// creation.
void remove_empty_siblings(const std::string& directory);

}  // namespace frana::app
