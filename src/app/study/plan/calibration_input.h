// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "analysis/scores.h"
#include "app/input/prepare.h"
#include "app/study/member_record.h"
#include "app/study/plan/study_input.h"
#include "core/error.h"

namespace frana::app::study {

/// Returns the row of a measure.
const MeasureRow& row_of(Measure measure);

/// Whether a prepared scene and its event have what a measure needs.
bool has_evidence(const Prepared& base, const EventSpec& event, Evidence evidence);
/// Whether a run-out or values at gauges that the study gives have a stated error.
bool has_stated_error(const EventSpec& event, Evidence evidence);

/// How far a member is from what was surveyed.
struct MemberAgreement {
    double misfit = 0;          ///< weighted mean of the parts: 0 agrees, 1 at most
    std::vector<double> parts;  ///< misfits of the measures of EventSurvey::measures()
    double chi_square = 0;      ///< of the stated errors, see EventSurvey
    double unshifted = 0;       ///< the same if the outline may be shifted by any distance
    double outside = 0;         ///< how far the outline is outside of the trace, in the mean [m]; less than 0: inside
};

/// What was surveyed of one event, on the cells of its members.
///
/// With stated errors the likelihood of a member is exp(-chi^2 / 2), with a sum over what has one and is compared:
///
///     outline            L (m - d^2) / S + d^2 / (S / L + b^2),  S = s^2 l + p^2 c,  N = L (s^2 + p^2) / S
///     deposit's depth    N m / s^2,                              N = its area / error-length^2
///     run-out, gauges    (value - observed)^2 / s^2,             N = 1
///
/// m mean square of the distances between both outlines (mean of both directions), or of the differences of depth over
/// the cells of either deposit; s stated standard deviation, l error-length, at most the outline's length L; c cell,
/// p^2 mean square of the distance between the outline and the edges of the cells in it (up to c^2 / 12), d mean
/// distance, with a sign, b the standard deviation of an offset that the whole outline has. N is what chi^2 is on the
/// average without other errors: a stationary error whose correlation has the integral l has, over a length L, a mean
/// with the variance s^2 l / L (Bayley and Hammersley 1946, Supplement to the Journal of the Royal Statistical Society
/// 8, 184); those of cells are alike over a cell.
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
    /// N of all stated errors together; 0: none is stated.
    [[nodiscard]] double pieces() const;
    /// Standard deviation of chi^2 without other errors than the stated ones.
    [[nodiscard]] double scatter() const;

  private:
    [[nodiscard]] double misfit(Measure measure, const MemberRecord& record) const;
    [[nodiscard]] double outline_misfit(const Raster& depth) const;
    [[nodiscard]] bool has_no_deposit(const Raster& change) const;
    [[nodiscard]] double deposit_depth_misfit(const Raster& change) const;
    [[nodiscard]] std::vector<double> values_of(Evidence evidence, const MemberRecord& record) const;
    void add_chi_square(const MemberRecord& record, MemberAgreement& to) const;
    void add_outline(const Raster& depth, MemberAgreement& to) const;
    [[nodiscard]] double outline_mean_square(const MultiPolygon& trace) const;
    [[nodiscard]] double single_values() const;
    [[nodiscard]] double deposit_mean_square(const Raster& change) const;
    [[nodiscard]] bool measures_by(Evidence evidence) const;

    const EventSpec& event_;
    std::vector<Weight> measures_;
    double threshold_;
    GridSpec grid_;            ///< of all comparisons: what any member reached, and the surveys
    Raster scar_, deposit_;    ///< masks; no columns: not surveyed
    Raster elevation_change_;  ///< [m]
    std::optional<LineSet> outline_;
    double scar_area_ = 0, runout_ = 0;
    double outline_pieces_ = 0, outline_scatter_ = 0;  ///< N, variance of chi^2
    double mean_variance_ = 0, bias_variance_ = 0;     ///< S / L, b^2 [m2]
    double deposit_pieces_ = 0, deposit_variance_ = 0;
    std::vector<Gauge> gauges_;
};

/// Draws the first members of a calibration, and reads their scenes. Throws Error(input) only if no event has a scene
/// that can be read.
void read_events(StudyInput& texts, RunLog& log);

/// Prepares the scenes of all events, and checks that each has what is compared with it. Throws Error(input) with every
/// problem found, and with that of the result's place as prepare().
void prepare_events(StudyInput& input, const std::optional<Problem>& place, RunLog& log);

/// Returns the members of one event at places in its keys; problems of their values are those of the members.
SampleTable members_at(const StudyReading& reading, std::size_t event, const Places& places, Problems& problems);

}  // namespace frana::app::study
