// SPDX-License-Identifier: Apache-2.0
#include "app/compare/comparison.h"

#include <cmath>
#include <utility>

#include "analysis/flow_path.h"
#include "analysis/runout.h"
#include "analysis/trace.h"
#include "app/text/number_text.h"
#include "app/text/unit_sign.h"
#include "core/error.h"
#include "core/inside_test.h"
#include "gis/raster/rasterize.h"

namespace frana::app {
namespace {

/// The flows of a result and a survey together, on the same cells, and which of them is compared: that with the longest
/// observed run-out, or the longest simulated one if nothing was observed.
struct ComparedFlow {
    Raster trace;     ///< simulated, of this flow alone
    Raster observed;  ///< of this flow alone
    Runout simulated_end, observed_end;
};

/// Returns the cells of a mask that belong to one flow.
Raster part_of_flow(const Raster& mask, const SeparateFlows& flows, std::size_t flow) {
    Raster part(mask.grid);
    mask.values.for_each_stored([&](std::size_t cell, double inside) {
        if (inside != 0 && flows.flow_of(cell) == flow) part.values[cell] = inside;
    });
    return part;
}

ComparedFlow compared_flow(const ComparisonInput& input, const Raster& observed) {
    const Raster trace = trace_mask(input.depth, input.threshold);
    Raster reached = input.depth;
    observed.values.for_each_stored([&](std::size_t cell, double inside) {
        if (inside != 0 && !(reached.values[cell] > 0)) reached.values[cell] = inside;
    });
    const SeparateFlows flows(*input.release, reached, input.inflows);
    if (flows.count() == 0)
        throw Error(ErrorKind::input, Problem{"nothing is released and nothing flows", "run-out", "", "", ""});
    const std::vector<Runout> simulated = runouts_by_flow(flows, *input.bed, *input.release, trace),
                              surveyed = runouts_by_flow(flows, *input.bed, *input.release, observed);
    std::size_t chosen = 0;
    const auto lengths = [&](std::size_t flow) {
        return std::pair{surveyed[flow].horizontal_m, simulated[flow].horizontal_m};
    };
    for (std::size_t flow = 1; flow < flows.count(); ++flow)
        if (lengths(flow) > lengths(chosen)) chosen = flow;
    return {part_of_flow(trace, flows, chosen), part_of_flow(observed, flows, chosen), simulated[chosen],
            surveyed[chosen]};
}

/// Computes both run-outs on one path: that of the simulated flow, extended to the farthest cell of trace and survey.
PathRunout path_runout(const ComparisonInput& input, const ComparedFlow& flow) {
    const Runout& farthest =
        flow.observed_end.horizontal_m > flow.simulated_end.horizontal_m ? flow.observed_end : flow.simulated_end;
    Raster depth = input.depth;
    flow.observed.values.for_each_stored([&](std::size_t cell, double inside) {
        // A path over surveyed area without flow is preferred to one over area outside both.
        if (inside != 0 && !(input.depth.values[cell] > input.threshold)) depth.values[cell] = input.threshold;
    });
    const Polyline path = flow_path(depth, farthest.top, farthest.tip);
    return {runout_along(path, flow.trace), runout_along(path, flow.observed)};
}

void compare_run_outs(const ComparisonInput& input, const Raster& observed, RunLog& log, Comparison& comparison) {
    if (!input.bed || !input.release) return;
    if (!observed.grid.same_cells(input.bed->grid)) {
        log.warn(
            worded("the surveyed outline reaches beyond the result's rasters, so its run-out is unknown: no run-out "
                   "difference. With "
                   "output.extent = map a run's rasters cover the whole map"));
        return;
    }
    const ComparedFlow flow = compared_flow(input, observed);
    comparison.runout_difference_m = flow.simulated_end.horizontal_m - flow.observed_end.horizontal_m;
    if (maximum(flow.trace) > 0) comparison.path_runout = path_runout(input, flow);
}

FrontComparison compare_front(const gis::NamedLine& front, const LineSet& outline, const InsideTest& inside_trace,
                              double spacing) {
    FrontComparison result;
    result.name = front.name;
    std::vector<double> distances;
    double inside = 0;
    const std::vector<Point> samples = LineSet({front.line}).samples(spacing);
    for (const Point& point : samples) {
        const bool reached = inside_trace(point);
        distances.push_back(outline.distance(point) * (reached ? 1 : -1));
        result.mean_m += distances.back() / static_cast<double>(samples.size());
        inside += reached;
    }
    result.reached_percent = 100 * inside / static_cast<double>(samples.size());
    result.size = distance_statistics(std::move(distances));
    return result;
}

void compare_fronts_and_tips(const ComparisonInput& input, RunLog& log, Comparison& comparison) {
    const Survey& survey = input.survey;
    if (survey.fronts.empty() && survey.tips.empty()) return;
    const MultiPolygon trace = gis::polygonise(trace_mask(input.depth, input.threshold));
    if (trace.empty()) {
        log.warn(worded("nothing is deeper than {1} m, so there is no front to compare",
                        {numeral(number_text(input.threshold))}));
        return;
    }
    const LineSet outline(trace);
    const InsideTest inside_trace(trace);
    for (const gis::NamedLine& front : survey.fronts)
        comparison.fronts.push_back(compare_front(front, outline, inside_trace, input.depth.grid.cell_size));
    for (const gis::NamedPoint& tip : survey.tips)
        comparison.tips.push_back({tip.name, outline.distance(tip.place) * (inside_trace(tip.place) ? 1 : -1)});
}

void compare_area(const ComparisonInput& input, const Raster& depth, RunLog& log, Comparison& comparison) {
    const Raster observed = gis::coverage(input.survey.scar, depth.grid);
    comparison.statistics = compare(depth, observed, input.threshold);
    comparison.curve = score_curve(depth, observed);
    comparison.classes = agreement(depth, observed, input.threshold);
    compare_run_outs(input, observed, log, comparison);
    const MultiPolygon trace = gis::polygonise(trace_mask(input.depth, input.threshold));
    if (!trace.empty()) {
        comparison.outline = distance_between(LineSet(trace), LineSet(input.survey.scar), input.depth.grid.cell_size);
    }
}

void compare_deposits(const ComparisonInput& input, const Bounds& box, RunLog& log, Comparison& comparison) {
    const Survey& survey = input.survey;
    if (survey.deposit.empty() && !survey.elevation_change) return;
    if (!input.final_depth) {
        log.warn(worded("there is no depth at the end to compare with the surveyed deposit"));
        return;
    }
    if (!survey.deposit.empty()) {
        const Raster depth = padded_to(*input.final_depth, box, k_no_data);
        comparison.deposit_overlap = compare(depth, gis::coverage(survey.deposit, depth.grid), input.threshold);
    } else {
        comparison.deposit_overlap =
            compare(*input.final_depth, trace_mask(*survey.elevation_change, input.threshold), input.threshold);
        comparison.deposit_depth = compare_deposit(*input.final_depth, *survey.elevation_change, input.threshold);
    }
}

}  // namespace

Comparison compare_with_survey(const ComparisonInput& input, RunLog& log) {
    Comparison comparison;
    const Bounds box = input.survey.box().value_or(input.depth.grid.bounds());
    if (!input.survey.scar.empty()) {
        const Raster depth = padded_to(input.depth, bounds(input.survey.scar), k_no_data);
        if (!depth.grid.same_cells(input.depth.grid))
            log.warn(
                worded("the surveyed outline reaches beyond the result's rasters; its part outside counts as missed"));
        compare_area(input, depth, log, comparison);
    }
    compare_fronts_and_tips(input, log, comparison);
    compare_deposits(input, box, log, comparison);
    return comparison;
}

std::string comparison_headline(const Comparison& comparison) {
    std::string text;
    if (comparison.statistics) {
        text = "the area differs from the surveyed one by " +
               signed_number_text(comparison.statistics->signed_area_difference_percent()) + " %, Jaccard " +
               number_text(comparison.statistics->jaccard, 3);
    }
    for (const FrontComparison& front : comparison.fronts)
        text += (text.empty() ? "" : "; ") + std::string("front ") + front.name + ": " + number_text(front.mean_m, 3) +
                " m on average";
    for (const TipComparison& tip : comparison.tips)
        text +=
            (text.empty() ? "" : "; ") + std::string("tip ") + tip.name + ": " + number_text(tip.distance_m, 3) + " m";
    if (comparison.deposit_overlap)
        text += (text.empty() ? "" : "; ") + std::string("deposit: Jaccard ") +
                number_text(comparison.deposit_overlap->jaccard, 3);
    return text;
}

}  // namespace frana::app
