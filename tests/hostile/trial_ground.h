// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "../cli/tiny_scene.h"
#include "folder_state.h"
#include "random_numbers.h"
#include "supervised_program.h"

namespace frana::test {

/// A command, from where it begins to where it ends if nobody disturbs it.
struct TriedCommand {
    std::string name;
    std::string begins_in;  ///< the name of a kept place
    std::vector<std::string> arguments;
    std::vector<std::string> again;   ///< arguments of the command with which a user repairs what went wrong
    bool whole = true;                ///< its files appear together or not at all
    FolderState before{}, after{};    ///< by measure(): the place before and after it
    std::vector<SystemCall> calls{};  ///< and the watched calls it makes
};

/// removal: files could not be removed, so that litter stays. memory: GDAL and Mesa crash or wait for ever
/// where the system refuses them memory or a thread, which must cost no more than a kill does.
enum class Disturbance { error, kill, removal, memory };

/// A small world: in/ with a scene and what it names, out/ where results go, with files of the user's in and
/// beside them. Every trial begins from one of its kept states, always under the same path.
class TrialGround : public TinyScene {
  protected:
    TrialGround();

    [[nodiscard]] std::string place() const { return (folder_ / "place").string(); }
    [[nodiscard]] std::string at(const std::string& name) const { return place() + "/" + name; }
    /// Puts what is there now by for later under a name, and brings it back.
    void keep(const std::string& name) const;
    void restore(const std::string& name) const;
    [[nodiscard]] FolderState state() const { return state_of(place()); }

    [[nodiscard]] Ending run(const Launch& launch, const Watch& watch = {}, const Judge& judge = {}) const;
    [[nodiscard]] Ending run(const std::vector<std::string>& arguments) const { return run(Launch{arguments}); }

    /// run, run --overwrite, run --resume, render, compare, converge and check; the places that they begin in
    /// are kept.
    [[nodiscard]] std::vector<TriedCommand> commands() const;
    /// Runs a command undisturbed, unless that was done before.
    void measure(TriedCommand& command, const Watch& watch = {}) const;

    /// What must hold after a command however it was disturbed: a known exit code, a message, nothing of the
    /// user's touched, the older result or the new one, with exit code 0 the result of the command
    /// undisturbed.
    void expect_nothing_lost(const TriedCommand& command, const Ending& ending,
                             Disturbance by = Disturbance::error) const;
    /// The command's repetition ends in what the command undisturbed ends in, and in nothing else.
    void expect_repaired(const TriedCommand& command) const;

  private:
    void keep_older_result() const;
    void keep_killed_run() const;
    void expect_old_or_new(const TriedCommand& command, const Ending& ending, const FolderState& now) const;
};

/// One of them, all files and kinds of calls being alike: a GeoPackage alone is written to hundreds of times.
SystemCall random_call(const std::vector<SystemCall>& calls, RandomNumbers& random);

/// Whether a difference (see differences()) is a copy that was kept because it may be the user's.
bool is_kept_copy(const std::string& difference);

/// Exit code, end in time, message: what holds for every call of the program.
void expect_decent_end(const Ending& ending, Disturbance by = Disturbance::error);

/// Whether a file below the place is the user's: nothing of frana's made it.
bool is_users(const std::string& path);

}  // namespace frana::test
