// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/scores.h"
#include "app/input/prepare.h"
#include "app/study/member_record.h"
#include "app/study/plan/read_calibration.h"
#include "app/study/plan/study_input.h"
#include "core/error.h"

namespace frana::app::study {

/// Returns the row of a measure.
const MeasureRow& row_of(Measure measure);

/// Whether a prepared scene and its event have what a measure needs.
bool has_evidence(const Prepared& base, const EventSpec& event, Evidence evidence);
/// Adds a problem for each gauge with an observed value that the scene does not have.
void check_gauges(const Prepared& base, const EventSpec& event, const std::string& where, Problems& problems);

/// How far a member is from what was surveyed.
struct MemberAgreement {
    double misfit = 0;          ///< weighted mean of the parts: 0 agrees, 1 at most
    std::vector<double> parts;  ///< misfits of the measures of EventSurvey::measures()
};

/// What was surveyed of one event, on the cells of its members.
class EventSurvey {
  public:
    /// @param base of members with the same cells
    /// @param window cells of base's grid that any member reached; may reach beyond it
    EventSurvey(const Prepared& base, const EventSpec& event, const std::vector<Weight>& objective,
                const CellWindow& window);

    /// The measures of the objective for which the event has evidence.
    [[nodiscard]] const std::vector<Weight>& measures() const noexcept { return measures_; }
    /// Compares a finished member.
    [[nodiscard]] MemberAgreement compare(const MemberRecord& record) const;

    [[nodiscard]] double observed_runout() const noexcept { return runout_; }

  private:
    [[nodiscard]] double misfit(Measure measure, const MemberRecord& record) const;
    [[nodiscard]] double outline_misfit(const Raster& depth) const;
    [[nodiscard]] double deposit_depth_misfit(const Raster& final_depth) const;
    [[nodiscard]] double gauge_misfit(const std::vector<GaugeValue>& observed, const char* figure,
                                      const MemberRecord& record) const;
    [[nodiscard]] double arrival_misfit(const MemberRecord& record) const;

    const EventSpec& event_;
    std::vector<Weight> measures_;
    double threshold_;
    GridSpec grid_;            ///< of all comparisons: what any member reached, and the surveys
    Raster scar_, deposit_;    ///< masks; no columns: not surveyed
    Raster elevation_change_;  ///< [m]
    std::optional<LineSet> outline_;
    double scar_area_ = 0, runout_ = 0;
    std::vector<Gauge> gauges_;
};

/// r(a, b) = |a - b| / max(a, b), from 0 to 1; 0 if both are 0.
double relative_difference(double a, double b);

/// A calibration whose files have been read as text.
struct CalibrationTexts {
    CalibrationReading reading;
    Places design;                   ///< of the first members, in all keys
    std::vector<StudyTexts> events;  ///< with the first members; their problems contain those of the scenes
    SceneReading first_scene;        ///< of the first event: the result's place is beside its
    Problems problems;               ///< of everything read so far
};

/// Reads the calibration, draws its first members, and reads their scenes. The study file of a result, which may have
/// been moved, finds its inputs as find_recorded_inputs(). Throws Error(input) only if a file is no INI, no event has a
/// scene, or an input of such a result is missing.
CalibrationTexts read_calibration_texts(const std::string& path, const Session& session, RunLog& log);

/// A calibration with everything checked that can be checked before its members run.
struct CalibrationInput {
    CalibrationReading reading;
    Places design;
    std::vector<StudyInput> coarse;  ///< by event: the first members, on coarse cells
    std::vector<StudyInput> own;     ///< by event: the same members on the scene's own cells
    /// One fact per line, as of a StudyInput.
    std::string identity;

    [[nodiscard]] const CalibrationSpec& spec() const noexcept { return reading.calibration; }
    [[nodiscard]] std::size_t events() const noexcept { return own.size(); }
};

/// Prepares the scenes of all events on both sizes of cells, and checks that each has what is compared with it. Throws
/// Error(input) with every problem found, and with that of the result's place as prepare().
CalibrationInput prepare_calibration(CalibrationTexts texts, const std::optional<Problem>& place, RunLog& log);

/// Returns the members of one event at places in all keys; problems of their values are those of the members.
SampleTable members_at(const CalibrationSpec& calibration, std::size_t event, const Places& places, Problems& problems);

}  // namespace frana::app::study
