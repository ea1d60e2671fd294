// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/scores.h"
#include "app/input/prepare.h"
#include "app/study/calibration_spec.h"
#include "app/study/member_record.h"
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

}  // namespace frana::app::study
