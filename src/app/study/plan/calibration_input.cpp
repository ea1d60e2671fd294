// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/calibration_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/runout.h"
#include "analysis/scores.h"
#include "analysis/trace.h"
#include "app/compare/comparison.h"
#include "app/store/recorded_inputs.h"
#include "app/study/plan/study_input.h"
#include "core/text.h"
#include "gis/raster/footprint.h"
#include "params/grammar/value_text.h"
#include "simulation/release.h"
#include "simulation/run_summary.h"

namespace frana::app::study {
namespace {

/// First members: enough for the correlation lengths of a Gaussian process. Loeppky, Sacks and Welch (2009,
/// Technometrics 51, 366) advise 10 a key where no others follow; here they do.
constexpr std::int64_t k_least_design = 8, k_design_per_key = 5;

/// Where an event's evidence comes from, for messages; by Evidence.
constexpr const char* k_sources[] = {
    "observed.perimeter in the scene", "observed.perimeter in the scene, or runout in [event NAME]",
    "observed.deposit in the scene",   "observed.deposit in the scene, as a raster",
    "arrival GAUGE in [event NAME]",   "speed GAUGE in [event NAME]",
    "depth GAUGE in [event NAME]"};

/// The cells of a grid that contain a window and a box.
GridSpec grid_round(const GridSpec& grid, const CellWindow& window, const std::optional<Bounds>& box) {
    if (!box) return part_of(grid, window);
    std::int64_t left = static_cast<std::int64_t>(std::floor((box->west - grid.west) / grid.cell_size)),
                 right = static_cast<std::int64_t>(std::ceil((box->east - grid.west) / grid.cell_size)),
                 top = static_cast<std::int64_t>(std::floor((grid.north - box->north) / grid.cell_size)),
                 bottom = static_cast<std::int64_t>(std::ceil((grid.north - box->south) / grid.cell_size));
    if (window.rows > 0) {
        left = std::min(left, window.column);
        right = std::max(right, window.column + window.columns);
        top = std::min(top, window.row);
        bottom = std::max(bottom, window.row + window.rows);
    }
    return part_of(grid, {top, left, bottom - top, right - left});
}

/// A raster's values on another grid with the same lattice of cells; NaN outside.
Raster moved_to(const GridSpec& grid, const Raster& raster) {
    const auto row = std::llround((raster.grid.north - grid.north) / -grid.cell_size),
               column = std::llround((raster.grid.west - grid.west) / grid.cell_size);
    Raster moved(grid, k_no_data);
    for (std::int64_t r = 0; r < raster.grid.rows; ++r)
        for (std::int64_t c = 0; c < raster.grid.columns; ++c)
            if (r + row >= 0 && r + row < grid.rows && c + column >= 0 && c + column < grid.columns)
                moved.at(r + row, c + column) = raster.at(r, c);
    return moved;
}

bool is_empty(const Raster& mask) {
    return mask.grid.columns == 0 || !(maximum(mask) > 0);
}

/// Run-out of the surveyed outline from the highest point of the release, as `frana compare` measures it.
double runout_of(const MultiPolygon& scar, const Scene& scene) {
    const Release release = make_release(scene);
    const Raster observed = gis::coverage(scar, scene.grid);
    Raster released = release.depth;
    if (released.grid.columns == 0) released = Raster(scene.grid, k_no_data);
    const SeparateFlows flows(released, observed);
    return runouts(flows, release.bed, released, observed).front().horizontal_m;
}

/// r(a, b) = |a - b| / max(a, b), from 0 to 1; 0 if both are 0.
double relative_difference(double a, double b) {
    const double greater = std::max(a, b);
    return greater > 0 ? std::abs(a - b) / greater : 0;
}

}  // namespace

const MeasureRow& row_of(Measure measure) {
    return *std::find_if(std::begin(k_measures), std::end(k_measures),
                         [&](const MeasureRow& row) { return row.measure == measure; });
}

bool has_evidence(const Prepared& base, const EventSpec& event, Evidence evidence) {
    const Survey& survey = base.extra.survey;
    const bool has_scar = base.scar && !base.scar->features.empty();
    switch (evidence) {
        case Evidence::scar:
            return has_scar;
        case Evidence::runout:
            return has_scar || !event.observed_by(evidence).empty();
        case Evidence::deposit:
            return !survey.deposit.empty() || survey.elevation_change.has_value();
        case Evidence::elevation_change:
            return survey.elevation_change.has_value();
        case Evidence::arrival:
        case Evidence::speed:
        case Evidence::depth:
            break;
    }
    return !event.observed_by(evidence).empty();
}

bool has_stated_error(const EventSpec& event, Evidence evidence) {
    return std::any_of(event.observed.begin(), event.observed.end(),
                       [&](const Observation& one) { return one.evidence == evidence && one.error > 0; });
}

EventSurvey::EventSurvey(const Prepared& base, const EventSpec& event, const std::vector<Weight>& objective,
                         const CellWindow& window)
    : event_(event), threshold_(observed_threshold(base.spec)), gauges_(base.scene.recording.gauges) {
    for (const Weight& one : objective)
        if (has_evidence(base, event, row_of(one.measure).needs)) measures_.push_back(one);
    const Survey survey = surveyed(base).survey;
    std::optional<Bounds> box = survey.box();
    if (survey.elevation_change) {  // whatever these members reached, all are compared over the same cells
        const Bounds all = survey.elevation_change->grid.bounds(), part = box.value_or(all);
        box = {std::min(all.west, part.west), std::min(all.south, part.south), std::max(all.east, part.east),
               std::max(all.north, part.north)};
    }
    grid_ = grid_round(base.scene.grid, window, box);
    if (!survey.scar.empty()) {
        scar_ = gis::coverage(survey.scar, grid_);
        outline_.emplace(survey.scar);
        scar_area_ = masked_area(scar_);
        runout_ = runout_of(survey.scar, base.scene);
    }
    for (const Observation& one : event.observed_by(Evidence::runout)) runout_ = one.value;
    if (survey.elevation_change) {
        elevation_change_ = moved_to(grid_, *survey.elevation_change);
        deposit_ = trace_mask(elevation_change_, threshold_);
    } else if (!survey.deposit.empty()) {
        deposit_ = gis::coverage(survey.deposit, grid_);
    }
    const ObservedSpec& stated = base.spec.observed;
    const double error_length = stated.error_length.value_or(10 * stated.perimeter_error.value_or(grid_.cell_size));
    if (stated.perimeter_error && measures_by(Evidence::scar)) {
        const double length = outline_->length(), alike = std::min(error_length, length), cell = grid_.cell_size,
                     of_survey = std::pow(*stated.perimeter_error, 2),
                     of_cell = is_empty(scar_) ? 0 : outline_mean_square(gis::polygonise(scar_)),
                     density = of_survey * alike + of_cell * cell;
        outline_pieces_ = length * (of_survey + of_cell) / density;
        // The square of a normal error's correlation has 1 / sqrt(2) of its integral.
        outline_scatter_ = 2 * length / (density * density) *
                           (of_survey * of_survey * alike / std::numbers::sqrt2 + of_cell * of_cell * cell);
        mean_variance_ = density / length;
        bias_variance_ = std::pow(stated.perimeter_bias.value_or(0), 2);
    }
    if (stated.deposit_error && measures_by(Evidence::elevation_change)) {
        deposit_pieces_ = std::max(1.0, masked_area(deposit_) / std::pow(error_length, 2));
        deposit_variance_ = std::pow(*stated.deposit_error, 2);
    }
    for (const Weight& one : measures_) {
        const Evidence needs = row_of(one.measure).needs;
        const bool covers = needs == Evidence::scar      ? !is_empty(scar_)
                            : needs == Evidence::deposit ? !is_empty(deposit_)
                                                         : true;
        if (!covers)
            throw Error(ErrorKind::input,
                        Problem{"the surveyed area contains no centre of a cell", event.scene, "",
                                std::to_string(grid_.cell_size) + " m", "Use smaller cells: terrain.cell-size"});
    }
}

double EventSurvey::outline_misfit(const Raster& depth) const {
    const MultiPolygon trace = gis::polygonise(trace_mask(depth, threshold_));
    if (trace.empty()) return 1;
    const double mean = distance_between(LineSet(trace), *outline_, grid_.cell_size).mean_m;
    return mean / (mean + std::sqrt(scar_area_ / std::numbers::pi));
}

bool EventSurvey::has_no_deposit(const Raster& change) const {
    return is_empty(deposit_) && is_empty(trace_mask(change, threshold_));
}

double EventSurvey::deposit_depth_misfit(const Raster& change) const {
    if (has_no_deposit(change)) return 0;
    const DepositScores scores = compare_deposit(change, elevation_change_, threshold_);
    const double sum = scores.simulated_volume_m3 + scores.observed_volume_m3;
    return sum > 0 ? scores.mean_absolute_error_m * scores.area_m2 / sum : 0;
}

std::vector<double> EventSurvey::values_of(Evidence evidence, const MemberRecord& record) const {
    if (evidence == Evidence::runout) return {value_of(record.figures, k_run_out_key)};
    std::vector<double> values;
    const Raster arrival =
        evidence == Evidence::arrival ? record.raster(Quantity::arrival, grid_) : Raster(GridSpec{}, k_no_data);
    const auto kind = std::find_if(std::begin(k_observed_kinds), std::end(k_observed_kinds),
                                   [&](const ObservedKind& one) { return one.evidence == evidence; });
    for (const Observation& one : event_.observed_by(evidence)) {
        if (const char* const of_gauge = kind->figure) {
            values.push_back(value_of(record.figures, "gauge " + one.gauge + ": " + of_gauge));
            continue;
        }
        const auto gauge =
            std::find_if(gauges_.begin(), gauges_.end(), [&](const Gauge& g) { return g.name == one.gauge; });
        values.push_back(cell_value(arrival, gauge->place));
    }
    return values;
}

double EventSurvey::outline_mean_square(const MultiPolygon& trace) const {
    const LineSet lines(trace);
    const auto mean_square = [&](const LineSet& from, const LineSet& to) {
        double sum = 0;
        const std::vector<Point> points = from.samples(grid_.cell_size);
        for (const Point& point : points) sum += std::pow(to.distance(point), 2);
        return sum / static_cast<double>(points.size());
    };
    return (mean_square(lines, *outline_) + mean_square(*outline_, lines)) / 2;
}

void EventSurvey::add_outline(const Raster& depth, MemberAgreement& to) const {
    const Raster mask = trace_mask(depth, threshold_);
    const MultiPolygon trace = gis::polygonise(mask);
    const double square =
        trace.empty() ? std::pow(std::max(runout_, std::sqrt(scar_area_)), 2) : outline_mean_square(trace);
    to.outside = trace.empty() ? 0 : (scar_area_ - masked_area(mask)) / outline_->length();
    const double offset = std::min(to.outside * to.outside, square);
    to.unshifted += (square - offset) / mean_variance_;
    to.chi_square += (square - offset) / mean_variance_ + offset / (mean_variance_ + bias_variance_);
}

double EventSurvey::deposit_mean_square(const Raster& change) const {
    if (has_no_deposit(change)) return 0;
    return std::pow(compare_deposit(change, elevation_change_, threshold_).rmse_m, 2);
}

void EventSurvey::add_chi_square(const MemberRecord& record, MemberAgreement& to) const {
    double sum = 0;
    if (deposit_pieces_ > 0)
        sum += deposit_pieces_ * deposit_mean_square(record.raster(Quantity::deposit, grid_)) / deposit_variance_;
    for (const ObservedKind& kind : k_observed_kinds) {
        if (!measures_by(kind.evidence)) continue;
        const std::vector<double> values = values_of(kind.evidence, record);
        const std::vector<Observation> observed = event_.observed_by(kind.evidence);
        for (std::size_t i = 0; i < observed.size(); ++i)
            if (observed[i].error > 0)  // what the flow did not reach is as far off as all of it
                sum += std::pow(
                    (std::isfinite(values[i]) ? values[i] - observed[i].value : observed[i].value) / observed[i].error,
                    2);
    }
    to.chi_square = to.unshifted = sum;
    if (outline_pieces_ > 0) add_outline(record.raster(Quantity::depth, grid_), to);
}

bool EventSurvey::measures_by(Evidence evidence) const {
    return std::any_of(measures_.begin(), measures_.end(),
                       [&](const Weight& one) { return row_of(one.measure).needs == evidence; });
}

double EventSurvey::single_values() const {
    double sum = 0;
    for (const Observation& one : event_.observed) sum += measures_by(one.evidence) && one.error > 0 ? 1 : 0;
    return sum;
}

double EventSurvey::pieces() const {
    return outline_pieces_ + deposit_pieces_ + single_values();
}

double EventSurvey::scatter() const {
    return std::sqrt(outline_scatter_ + 2 * (deposit_pieces_ + single_values()));
}

double EventSurvey::misfit(Measure measure, const MemberRecord& record) const {
    switch (measure) {
        case Measure::jaccard:
            return 1 - frana::compare(record.raster(Quantity::depth, grid_), scar_, threshold_).jaccard;
        case Measure::area:
            return relative_difference(masked_area(trace_mask(record.raster(Quantity::depth, grid_), threshold_)),
                                       scar_area_);
        case Measure::runout:
            return relative_difference(values_of(Evidence::runout, record).front(), runout_);
        case Measure::outline:
            return outline_misfit(record.raster(Quantity::depth, grid_));
        case Measure::deposit:
            return 1 - frana::compare(record.raster(Quantity::deposit, grid_), deposit_, threshold_).jaccard;
        case Measure::deposit_depth:
            return deposit_depth_misfit(record.raster(Quantity::deposit, grid_));
        case Measure::arrival:
        case Measure::speed:
        case Measure::depth:
            break;
    }
    const Evidence evidence = row_of(measure).needs;
    const std::vector<double> values = values_of(evidence, record);
    const std::vector<Observation> observed = event_.observed_by(evidence);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        sum += std::isfinite(values[i]) ? relative_difference(values[i], observed[i].value) : 1;
    return sum / static_cast<double>(values.size());
}

MemberAgreement EventSurvey::compare(const MemberRecord& record) const {
    MemberAgreement result;
    double weights = 0;
    for (const Weight& one : measures_) {
        const double part = misfit(one.measure, record);
        result.parts.push_back(part);
        result.misfit += one.weight * part;
        weights += one.weight;
    }
    result.misfit /= weights;
    add_chi_square(record, result);
    return result;
}

namespace {

bool weighs(const StudySpec& calibration, Evidence evidence) {
    return std::any_of(calibration.objective.begin(), calibration.objective.end(),
                       [&](const Weight& one) { return row_of(one.measure).needs == evidence; });
}

/// Adds a problem for each gauge with an observed value that the scene does not have.
void check_gauges(const Prepared& base, const EventSpec& event, const Place& where, Problems& problems) {
    const std::vector<Gauge>& gauges = base.scene.recording.gauges;
    for (const ObservedKind& kind : k_observed_kinds)
        for (const Observation& one : event.observed_by(kind.evidence))
            if (!one.gauge.empty() &&
                std::none_of(gauges.begin(), gauges.end(), [&](const Gauge& gauge) { return gauge.name == one.gauge; }))
                problems.add({"the scene has no gauge of this name", where, one.gauge, "",
                              "Name a point of the scene's output.gauges"});
}

/// Every event needs something that is compared, every measure an event, and gauges must exist.
void check_evidence(const StudyInput& input, Problems& problems) {
    const StudySpec& calibration = input.spec();
    std::vector<std::string> measures, sources;
    std::vector<bool> used(calibration.objective.size());
    for (const Weight& one : calibration.objective) {
        measures.emplace_back(row_of(one.measure).name);
        sources.emplace_back(k_sources[static_cast<std::size_t>(row_of(one.measure).needs)]);
    }
    for (std::size_t e = 0; e < input.events(); ++e) {
        const EventSpec& event = calibration.events[e];
        const Prepared& base = input.own[e].base;
        bool any = false;
        for (std::size_t m = 0; m < measures.size(); ++m) {
            if (!has_evidence(base, event, row_of(calibration.objective[m].measure).needs)) continue;
            used[m] = any = true;
        }
        const Place where = input.reading.where("event " + event.name);
        if (!any)
            problems.add({"has nothing that [objective] compares: " + joined(measures, ", "), where, event.scene, "",
                          "Give it " + joined(sources, "; or ")});
        check_gauges(base, event, where, problems);
    }
    for (std::size_t m = 0; m < measures.size(); ++m)
        if (!used[m])
            problems.add({"no event was surveyed for it", input.reading.where("objective." + measures[m]), "", "",
                          "Give an event " + sources[m] + ", or remove the line"});
}

/// Figures and outlines of a member use the survey's threshold, and records contain what is compared.
void compare_by_survey(const StudySpec& calibration, StudyInput& input) {
    input.base.spec.output.trace_threshold = observed_threshold(input.base.spec);
    const Survey& survey = input.base.extra.survey;
    if (weighs(calibration, Evidence::deposit) || weighs(calibration, Evidence::elevation_change))
        input.kept_deposit = survey.elevation_change   ? Deposit::elevation_change
                             : !survey.deposit.empty() ? Deposit::final_depth
                                                       : Deposit::none;
}

/// A scene's error of the terrain is one of many that are as likely: each member gets another one.
void integrate_terrain_error(StudySpec& calibration, std::size_t e) {
    constexpr const char* k_error = "terrain.error";
    const auto is_error = [&](const Variation& one) { return one.key == k_error; };
    const StudySpec of_event = calibration.of_event(e);
    if (std::any_of(of_event.vary.begin(), of_event.vary.end(), is_error)) return;
    const StudyInput scene = read_study_scenes({of_event, {}, {}, {}}, {});
    if (const auto& error = scene.central.scene.terrain.error; error && error->standard_deviation > 0) {
        const std::string text =
            "gaussian-field(" + shortest_text(error->standard_deviation) + ", " + shortest_text(error->range) + ")";
        calibration.events[e].vary.push_back({k_error, std::get<Distribution>(distribution_from_text(text))});
    }
}

}  // namespace

SampleTable members_at(const StudyReading& reading, std::size_t event, const Places& places, Problems& problems) {
    return samples_at(reading.study.of_event(event), places, reading.label, problems);
}

void read_events(StudyInput& texts, RunLog& log) {
    StudySpec& calibration = texts.reading.study;
    Problems problems = texts.reading.problems;
    for (std::size_t e = 0; e < calibration.events.size(); ++e) {
        Problems of_scene;  // the scene may be no INI
        attempt(of_scene, [&] {
            integrate_terrain_error(calibration, e);
            const StudyReading event{calibration.of_event(e), texts.reading.session, {}, texts.reading.label};
            StudySpec first = event.study;
            SampleTable table;
            Places design;
            if (problems.empty() && !first.vary.empty()) {  // else values tell nothing
                first.samples =
                    std::min(calibration.samples, std::max(k_least_design, k_design_per_key * std::ssize(first.vary)));
                design = draw_places(first);
                table = members_at(texts.reading, e, design, problems);
            }
            StudyInput one = read_study_scenes(event, std::move(table));
            one.design = std::move(design);
            problems.add(one.central.problems);
            one.warnings += log.tell(changed_inputs(calibration.file, one.central));
            texts.own.push_back(std::move(one));
        });
        problems.add(of_scene);
    }
    if (texts.own.empty()) problems.throw_if_any();
    texts.central = texts.own.front().central;
    texts.central.problems = std::move(problems);
}

void prepare_events(StudyInput& input, const std::optional<Problem>& place, RunLog& log) {
    const StudySpec& calibration = input.spec();
    Problems problems = std::move(input.central.problems);
    const bool alone = problems.empty();  // then a place that cannot be written is an error of the environment
    if (place && !alone) problems.add(*place);
    for (std::size_t e = 0; e < input.events(); ++e) {
        Problems of_event;
        attempt(of_event, [&] {
            input.own[e] = prepare_study(std::move(input.own[e]), e == 0 && alone ? place : std::nullopt, log);
            input.own[e].runs_on = false;
        });
        problems.add(of_event);
    }
    problems.throw_if_any();
    check_evidence(input, problems);
    problems.throw_if_any();
    for (std::size_t e = 0; e < input.events(); ++e)  // as the members will be compared with it
        attempt(problems, [&] { EventSurvey(input.own[e].base, calibration.events[e], calibration.objective, {}); });
    problems.throw_if_any();
    input.identity = study_text(with_files(calibration, without_folder));
    for (std::size_t e = 0; e < input.events(); ++e) {
        compare_by_survey(calibration, input.own[e]);
        input.identity += "event " + calibration.events[e].name + ":\n" + input.own[e].identity;
    }
}

}  // namespace frana::app::study
