// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/map_writer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "analysis/trace.h"
#include "app/pictures/map_layer.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {

namespace {

constexpr const char *k_probability = "probability", *k_rate = "annual_rate", *k_period = "return_period";
/// What is exceeded once in so many years, which follow the name.
constexpr std::pair<Quantity, const char*> k_once_rasters[] = {{Quantity::depth, "max_depth_T"},
                                                               {Quantity::velocity, "max_velocity_T"}};
constexpr const char *k_upper_ending = "_upper",
                     *k_upper_text = "upper bound: runs whose full reach is not known could have come";

}  // namespace

MapWriter::MapWriter(const Prepared& base, const ResultDirectory& directory)
    : directory_(directory), metadata_(provenance(base)), output_(base.spec.output), words_(words_of(base.spec)) {}

void MapWriter::write_chance(const std::string& name, const Raster& chance, const Raster& margin,
                             const Raster* upper) const {
    const std::string what = name.starts_with(k_rate) ? "rate" : "probability";
    write(name, chance,
          {{"_margin", "Half of the interval of 95 % of the " + what, &margin}, {k_upper_ending, k_upper_text, upper}},
          "", true);
}

QuantityMaps MapWriter::write_probabilities(const StudyRuns& runs, const GridSpec& grid,
                                            const MappedEvents& events) const {
    QuantityMaps maps = quantity_maps(runs, events.quantity, grid, events.thresholds);
    for (std::size_t t = 0; t < events.rasters.size(); ++t)
        write_chance(events.rasters[t], maps.probability[t], maps.margin[t],
                     maps.upper.empty() ? nullptr : &maps.upper[t]);
    return maps;
}

std::string rate_name(const std::string& probability) {
    return k_rate + probability.substr(std::string(k_probability).size());
}

void MapWriter::write_interval(const std::string& name, const Raster& value, const Raster& low, const Raster& high,
                               const std::string& of_high) const {
    write(name, value,
          {{"_low", "lower end of the interval of 95 %", &low},
           {"_high", "upper end of the interval of 95 %; " + of_high, &high}});
}

void MapWriter::write_return_period(const std::string& name, const Raster& rate, const Raster& margin,
                                    const Raster* upper) const {
    Raster period(rate.grid, k_no_data), low = period, high = period;
    rate.values.for_each_stored([&](std::size_t cell, double events) {
        if (!(events > 0)) return;
        const double more = events + margin.values[cell];
        period.values[cell] = 1 / events;
        low.values[cell] = 1 / (upper != nullptr ? std::max(more, std::as_const(*upper).values[cell]) : more);
        if (events > margin.values[cell]) high.values[cell] = 1 / (events - margin.values[cell]);
    });
    write_interval(name, period, low, high, "nodata: none");
}

RateMaps MapWriter::write_rates(const StudyResult& result, const MappedEvents& events,
                                const std::vector<double>& periods) const {
    const auto once = std::find_if(std::begin(k_once_rasters), std::end(k_once_rasters),
                                   [&](const auto& one) { return one.first == events.quantity; });
    const bool has_once = once != std::end(k_once_rasters);
    RateMaps maps = rate_maps(*result.rates, result, events.quantity, result.grid, events.thresholds,
                              has_once ? periods : std::vector<double>{});
    for (std::size_t t = 0; t < events.rasters.size(); ++t) {
        const Raster* const upper = maps.upper.empty() ? nullptr : &maps.upper[t];
        write_chance(rate_name(events.rasters[t]), maps.rate[t], maps.margin[t], upper);
        write_return_period(k_period + events.rasters[t].substr(std::string(k_probability).size()), maps.rate[t],
                            maps.margin[t], upper);
    }
    for (std::size_t i = 0; i < maps.once.size(); ++i)
        write_interval(once->second + shortest_text(periods[i]), maps.once[i].value, maps.once[i].low,
                       maps.once[i].high, "nodata: not known");
    return maps;
}

void MapWriter::write_quantile(const std::string& name, const Raster& quantile,
                               const std::optional<Raster>& upper) const {
    write(name, quantile, {{k_upper_ending, k_upper_text, upper ? &*upper : nullptr}},
          upper ? ", at least" : ", at least; without an upper bound");
}

void MapWriter::write(const std::string& name, const Raster& values, const std::vector<Beside>& more,
                      const std::string& note, bool zero_elsewhere) const {
    const ResultRaster& row = *find_result_raster(name);
    const std::string file = directory_.path(name + ".tif");
    std::vector<gis::RasterBand> bands{
        {values, {name, description_of(row, name, output_) + note, row.unit, metadata_}, zero_elsewhere}};
    for (const auto& [ending, text, raster] : more)
        if (raster != nullptr) bands.push_back({*raster, {name + ending, text, row.unit, metadata_}, zero_elsewhere});
    gis::write_geotiff(file, bands);
    if (!row.is_drawn()) return;
    const std::vector<double> bounds = class_bounds(row, maximum(values));
    gis::write_styles(file, gis::class_stops(palette(row.palette), bounds, row.unit, words_, row.zero_is_blank),
                      row.unit, gis::StyleKind::classed, raster_title(row, name, words_));
}

}  // namespace frana::app::study
