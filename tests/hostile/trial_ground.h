// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "folder_state.h"
#include "random_numbers.h"
#include "supervised_program.h"
#include "support/tiny_scene.h"

namespace frana::test {

/// A command, with its initial and its final state if undisturbed.
struct TriedCommand {
    std::string name;
    std::string begins_in;  ///< the name of a saved state
    std::vector<std::string> arguments;
    std::vector<std::string> again;   ///< arguments of the command by which a user repairs the problem
    bool whole = true;                ///< its files appear all together or not at all
    FolderState before{}, after{};    ///< by measure(): the place before and after it
    std::vector<SystemCall> calls{};  ///< its watched calls
};

/// removal: files could not be removed, so that remains are left. memory: GDAL and Mesa crash or wait for ever if the
/// system refuses them memory or a thread, which must do no more damage than a kill.
enum class Disturbance { error, kill, removal, memory };

/// A small environment: in/ with a scene and the files it names, out/ for results, with user's files in and beside
/// them. Every trial begins from one of its saved states, always under the same path.
class TrialGround : public TinyScene {
  protected:
    /// @param maps output.maps of the scene; off where no picture matters, which takes a third of the time
    explicit TrialGround(const std::string& maps = "max_depth", const std::string& report = "on");

    [[nodiscard]] std::string place() const { return (folder_ / "place").string(); }
    [[nodiscard]] std::string at(const std::string& name) const { return place() + "/" + name; }
    /// Saves the present state under a name.
    void keep(const std::string& name) const;
    /// Restores a saved state, or one of those in which commands() begin, each of which is made when first needed.
    void restore(const std::string& name) const;
    [[nodiscard]] FolderState state() const { return state_of(place()); }

    [[nodiscard]] Ending run(const Launch& launch, const Watch& watch = {}, const Judge& judge = {}) const;
    [[nodiscard]] Ending run(const std::vector<std::string>& arguments) const { return run(Launch{arguments}); }

    /// Returns run, run --overwrite, run --resume, render, compare, converge, ensemble, qgis-plugin and check.
    [[nodiscard]] static std::vector<TriedCommand> commands();
    /// Runs a command undisturbed, unless that was done before.
    void measure(TriedCommand& command, const Watch& watch = {}) const;

    /// Checks the conditions after a command however it was disturbed: a known exit code, a message, no file of the
    /// user changed, the older result or the new one, with exit code 0 the result of the command undisturbed.
    void expect_nothing_lost(const TriedCommand& command, const Ending& ending,
                             Disturbance by = Disturbance::error) const;
    /// Checks that the command's repetition ends as the undisturbed command does, and in nothing else.
    void expect_repaired(const TriedCommand& command) const;

  private:
    void keep_older_result() const;
    void keep_killed_run() const;
    void expect_old_or_new(const TriedCommand& command, const Ending& ending, const FolderState& now) const;
};

/// Returns one of them, all files and kinds of calls having equal probability: a GeoPackage alone is written to
/// hundreds of times.
SystemCall random_call(const std::vector<SystemCall>& calls, RandomNumbers& random);

/// Checks exit code, end in time, and message for any call of the program.
void expect_decent_end(const Ending& ending, Disturbance by = Disturbance::error);

/// Returns whether a file below the place belongs to the user.
bool is_users(const std::string& path);

}  // namespace frana::test
