// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_exposure.h"

#include <algorithm>
#include <cmath>

#include "app/ensemble/mapped_events.h"
#include "app/input/scene_language.h"
#include "gis/crs/crs_transform.h"
#include "study/feature_values.h"

namespace frana::app {
namespace {

using Values = std::span<const float>;

class Builder {
  public:
    Builder(const StudyInput& input, const StudyResult& result)
        : input_(input),
          result_(result),
          layer_(*input.base.extra.exposure),
          cells_(exposed_cells(layer_, result.grid)),
          values_(layer_.features.size()) {
        const Raster& terrain = input.base.scene.terrain;
        const bool is_known = input.slopes.empty() && !terrain.values.is_tiled();
        for (std::size_t f = 0; f < cells_.size() && is_known; ++f)
            values_[f].has_ground =
                cells_[f].empty() || std::any_of(cells_[f].begin(), cells_[f].end(),
                                                 [&](std::size_t cell) { return !std::isnan(terrain.values[cell]); });
    }

    std::vector<ExposureRow> rows(const Bounds& map) {
        greatest(study::Quantity::depth, &ExposureValues::depth);
        greatest(study::Quantity::velocity, &ExposureValues::velocity);
        greatest(study::Quantity::pressure, &ExposureValues::pressure);
        for_each(study::Quantity::arrival, [&](std::size_t feature, Values values) {
            const float first = *std::min_element(values.begin(), values.end());
            if (std::isfinite(first)) values_[feature].arrival = static_cast<double>(first);
        });
        std::vector<ExposureRow> rows = exposure_rows(layer_, values_, map);
        input_.reading.study.per_polygon() ? add_sources(rows) : add_probabilities(rows);
        return rows;
    }

  private:
    template <class Visit>
    void for_each(study::Quantity quantity, const Visit& visit) const {
        study::for_each_feature(result_.finished.records, quantity, result_.grid, cells_, visit);
    }
    void greatest(study::Quantity quantity, double ExposureValues::*member) {
        for_each(quantity, [&](std::size_t feature, Values values) {
            values_[feature].*member = static_cast<double>(*std::max_element(values.begin(), values.end()));
        });
    }
    void add_probabilities(std::vector<ExposureRow>& rows) const {
        const study::ProbabilityEstimate estimate(result_.finished);
        const auto add = [&](study::Quantity quantity, const std::vector<double>& thresholds,
                             const std::vector<std::string>& names) {
            for_each(quantity, [&](std::size_t feature, Values values) {
                for (std::size_t t = 0; t < thresholds.size(); ++t)
                    rows[feature].numbers.emplace_back(
                        names[t], rows[feature].is_on_map() ? estimate.of(values, thresholds[t]).value : k_no_data);
            });
        };
        add(study::Quantity::depth, {0}, {"probability_reached"});
        for (const MappedEvents& events : mapped_events(input_.base.spec))
            add(events.quantity, events.thresholds, events.rasters);
    }
    void add_sources(std::vector<ExposureRow>& rows) const {
        for_each(study::Quantity::depth, [&](std::size_t feature, Values values) {
            ExposureRow& row = rows[feature];
            const auto count = std::count_if(values.begin(), values.end(), [](float depth) { return depth > 0; });
            const auto worst =
                static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
            const std::size_t member = result_.members[result_.finished_at[worst]].member;
            row.numbers.emplace_back("sources", row.is_on_map() ? static_cast<double>(count) : k_no_data);
            row.numbers.emplace_back("worst_source", row.is_reached() ? static_cast<double>(member) : k_no_data);
            if (!input_.slopes.empty())
                row.texts.emplace_back("worst_name", row.is_reached() ? input_.slopes[member].name : "");
        });
    }

    const StudyInput& input_;
    const StudyResult& result_;
    const gis::ExposedLayer& layer_;
    std::vector<std::vector<std::size_t>> cells_;
    std::vector<ExposureValues> values_;
};

}  // namespace

Bounds computed_ground(const StudyInput& input) {
    const GridSpec& grid = input.base.scene.grid;
    if (input.slopes.empty()) return grid.bounds();
    const gis::RasterInfo& file = input.base.ground.file;
    if (const auto& bounds = input.base.spec.terrain.bounds) return *bounds;
    return gis::CrsTransform(grid.crs_wkt.empty() ? "" : file.crs_wkt, grid.crs_wkt, file.bounds).around(file.bounds);
}

ReachedBy exposure_reached_by(const StudyInput& input) {
    return input.reading.study.per_polygon() ? ReachedBy::any_slope : ReachedBy::any_run;
}

std::optional<ExposureTotals> publish_study_exposure(const StudyInput& input, const StudyResult& result,
                                                     const Bounds& map, const ResultDirectory& directory) {
    const auto& layer = input.base.extra.exposure;
    if (!layer) return std::nullopt;
    return write_exposure(*layer, Builder(input, result).rows(map), result.grid.crs_wkt, words_of(input.base.spec),
                          directory);
}

}  // namespace frana::app
