// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::app {

/// Between a result's name and what tells its siblings apart: RESULT.partial-Ab12Cd.
inline constexpr const char* k_building = ".partial-";

/// Notes down in a folder beside a result that the result is being built in it. Throws Error(environment).
void note_building(const std::string& folder, const std::string& result);
/// Whether a folder says so of itself, under the name that it has: a copy does not.
bool is_being_built(const std::string& folder);

/// Notes down in a result that another will take its place, and that it will then have this name until the
/// user's files in it are in the new one. Throws Error(environment).
void note_replaced(const std::string& result, const std::string& later_name);
/// Whether a folder is such an older result under its later name.
bool is_being_replaced(const std::string& folder);

/// Locks a folder for as long as the descriptor that is returned stays open; the system lets go of it when
/// the program ends, however it ends. -1, with errno, where somebody else holds it; `wait`: until nobody
/// does.
int lock_folder(const std::string& folder, bool wait);

/// Folders beside a result in which one is or was being built, the latest first: they say so, or they hold
/// checkpoints (an older frana's). This and what follows throws Error(environment) where the place cannot be
/// read.
std::vector<std::string> unfinished_results(const std::string& directory);
/// Those of runs that are no more.
std::vector<std::string> left_results(const std::string& directory);
/// Whether somebody holds a lock on a folder beside a result that is not one's own.
bool another_run_builds(const std::string& directory, const std::string& own);
/// Older results beside the one that took their place, where a run was killed before it had moved the user's
/// files.
std::vector<std::string> replaced_results(const std::string& directory);

/// Removes a folder in which a result was being built, if it says so and every file in it is one that frana
/// writes; false where it is left as it is.
bool remove_unfinished(const std::string& folder);

/// Removes the note from a result that has its name: a run was killed in the moment before it would have done
/// so.
void remove_note_of_building(const std::string& result);

/// Removes empty folders beside a result under a name that is drawn for building it: a kill, or a disk that
/// was full, just after the first moment.
void remove_empty_siblings(const std::string& directory);

}  // namespace frana::app
