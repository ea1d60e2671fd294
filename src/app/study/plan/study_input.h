// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/study/member_record.h"
#include "app/study/plan/read_study.h"
#include "app/study/plan/sampling.h"
#include "app/text/run_log.h"
#include "core/geometry.h"
#include "params/scene/read_scene.h"

namespace frana::app::study {

/// What the attributes of a polygon of a region say of it.
struct Slope {
    std::size_t polygon = 0;            ///< of the layer
    std::string name, group, scenario;  ///< empty: no such column or no value
    std::optional<double> return_period;
    FrequencySpec frequency;
    double area = 0;       ///< in the layer's CRS
    std::string problem;   ///< why it cannot be computed; empty: nothing is known against it
    MultiPolygon outline;  ///< in the working CRS, once that is known
};

/// A study with everything checked that can be checked before its members run: read_study_texts(), then
/// prepare_study(). Of a calibration each event is a study.
struct StudyInput {
    StudyReading reading;
    SampleTable table;
    Warnings warnings{};                      ///< that its base, once prepared, does not have, told
    SceneReading central;                     ///< the central member: medians, likeliest choices
    Prepared base;                            ///< the same, prepared
    std::vector<ReleaseArea> other_releases;  ///< of members with other files, for maps
    std::vector<Slope> slopes;                ///< of a region
    /// One fact per line: the study, every member's values, the scenes and their data. Two studies with the same
    /// identity give the same bits.
    std::string identity;
    Deposit kept_deposit = Deposit::none;  ///< of the members' records
    bool runs_on = true;                   ///< whether members that time.end cuts run on; not where they are compared
    Places design;                         ///< of an event of a calibration: its first members
    std::vector<StudyInput> own;           ///< of a calibration, by event: the members so far, at first the design

    [[nodiscard]] const StudySpec& spec() const noexcept { return reading.study; }
    [[nodiscard]] std::size_t events() const noexcept { return own.size(); }
    /// Those whose members run: its events, or itself.
    [[nodiscard]] std::vector<const StudyInput*> studies() const;

    /// Number of members that the study will have, at most.
    [[nodiscard]] std::size_t members() const;
    /// The slope of a member of a region, and the first member of a slope.
    [[nodiscard]] const Slope& slope_of(std::size_t member) const { return slopes[member / table.draws]; }
    [[nodiscard]] std::size_t first_member(std::size_t slope) const { return slope * table.draws; }
    /// Returns the scene of a member, as `frana run` with its values reads it.
    [[nodiscard]] SceneReading member(std::size_t index) const;
    /// Returns the scene with the study's settings and these values ("key=value").
    [[nodiscard]] SceneReading scene_with(const std::vector<std::string>& overrides) const;
};

/// Reads study, table and scenes, draws the members, of a calibration the first, and reads the scene of each: where its
/// result goes is then known, and `central` has the problems of the study and of all members. Warns of inputs that
/// changed since the result that has the study file. Throws Error(input) only if a file is no INI or missing, or no
/// scene is named.
/// @param samples in place of study.samples
StudyInput read_study_texts(const std::string& path, StudyKind kind, const Session& session, RunLog& log,
                            const std::optional<std::int64_t>& samples = std::nullopt);

/// The same for members that are known already.
StudyInput read_study_scenes(StudyReading reading, SampleTable table);

/// Prepares the central member, and a member for each value of keys without order, such as files; of a calibration
/// those of each event, which must have what is compared. Throws Error(input) with every problem found, and with that
/// of the result's place as prepare().
StudyInput prepare_study(StudyInput input, const std::optional<Problem>& place, RunLog& log);

// Of a region, in region_input.cpp.

/// Adds the slopes of a region with their members: one each, or with a frequency study.samples draws. Adds a problem if
/// the scene names no polygons, or they cannot be read, or no polygon has a column that the region names, or one
/// scenario has several return periods; what is wrong with a single slope is only kept with it.
void add_slopes(StudyInput& region);

/// Returns the slopes against which nothing is known, the largest first; if there are none, all.
std::vector<std::size_t> by_size(const std::vector<Slope>& slopes);

/// Prepares the slope that stands for all of a region (its material, its time, its output), the largest that can be
/// prepared, and the outlines of all. Throws Error(input) if none can be.
void prepare_region(StudyInput& input, const std::optional<Problem>& place, RunLog& log);

/// Events "a quantity exceeds a threshold" whose probability a study maps.
struct MappedEvents {
    Quantity quantity = Quantity::depth;
    std::vector<double> thresholds;
    std::vector<std::string> rasters;  ///< for each threshold: "probability_depth_0.5"
};

/// Returns the events of a scene: its thresholds of depth, velocity and pressure, and the classes of intensity, each
/// with all higher ones.
std::vector<MappedEvents> mapped_events(const SceneSpec& scene);

/// What importance sampling looks for: that the depth at a gauge exceeds the least depth threshold.
struct RareEvent {
    std::string gauge;
    Point place;           ///< map coordinates
    double threshold = 0;  ///< [m]
};
/// Of a study by importance sampling.
RareEvent rare_event(const StudyInput& input);

}  // namespace frana::app::study
