// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/map_writer.h"

#include <cmath>

#include "analysis/trace.h"
#include "app/pictures/map_layer.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {

namespace {

constexpr const char *k_probability = "probability", *k_rate = "annual_rate";

/// Events a year from a probability p with the margin m: r p, and with r's standard deviation s the margin
/// sqrt((r m)^2 + (1.96 s p)^2 + (s m)^2).
struct RateOf {
    FrequencySpec::Rate rate;
    double elsewhere = 0;  ///< the margin of a probability of 0

    [[nodiscard]] double margin(double p, double m) const {
        return std::hypot(rate.value * m, k_normal * rate.deviation * p, rate.deviation * m);
    }
    [[nodiscard]] Chance operator()(const Raster& probability, const Raster& margins) const {
        Chance chance{Raster(probability.grid), Raster(probability.grid, margin(0, elsewhere))};
        probability.values.for_each_stored([&](std::size_t cell, double p) {
            chance.value.values[cell] = rate.value * p;
            chance.margin.values[cell] = margin(p, margins.values[cell]);
        });
        return chance;
    }
    [[nodiscard]] Raster bound(const Raster& upper, double nowhere) const {
        Raster most(upper.grid, rate.value * nowhere);
        upper.values.for_each_stored([&](std::size_t cell, double p) { most.values[cell] = rate.value * p; });
        return most;
    }
};

}  // namespace

MapWriter::MapWriter(const Prepared& base, const ResultDirectory& directory)
    : directory_(directory), metadata_(provenance(base)), output_(base.spec.output), words_(words_of(base.spec)) {}

void MapWriter::write(const std::string& name, const Raster& raster) const {
    write(name, {band_of(name, raster)});
}

gis::BandText MapWriter::upper_text(const std::string& name, const std::string& unit) const {
    return {name + "_upper", "upper bound: runs whose full reach is not known could have come", unit, metadata_};
}

void MapWriter::write_chance(const std::string& name, const Chance& chance, const Raster* upper) const {
    gis::RasterBand band = band_of(name, chance.value);
    band.zero_elsewhere = true;
    const std::string what = name.starts_with(k_rate) ? "rate" : "probability";
    std::vector<gis::RasterBand> bands{
        band,
        {chance.margin,
         {name + "_margin", "Half of the interval of 95 % of the " + what, band.text.unit, metadata_},
         true}};
    if (upper != nullptr) bands.push_back({*upper, upper_text(name, band.text.unit), true});
    write(name, bands);
}

QuantityMaps MapWriter::write_probabilities(const FinishedMembers& finished, const OpenRuns& all, const GridSpec& grid,
                                            const MappedEvents& events, const FrequencySpec& frequency) const {
    std::vector<double> fractions;
    for (const double years : frequency.mapped_periods()) fractions.push_back(frequency.fraction_below(years));
    QuantityMaps maps = quantity_maps(finished, events.quantity, grid, events.thresholds, fractions);
    std::vector<Raster> upper;
    const std::vector<float> nothing(finished.size()), none_of_all(all.is_open.size());
    if (all.any()) upper = probability_bounds(maps.probability, all, events.quantity, events.thresholds, grid);
    for (std::size_t t = 0; t < events.rasters.size(); ++t) {
        const std::string& name = events.rasters[t];
        write_chance(name, {maps.probability[t], maps.margin[t]}, upper.empty() ? nullptr : &upper[t]);
        if (!frequency.rate) continue;
        const double threshold = events.thresholds[t];
        const RateOf rate_of{*frequency.rate, MeanEstimate(finished).probability(nothing, threshold).margin};
        std::optional<Raster> most;
        if (!upper.empty()) most = rate_of.bound(upper[t], upper_bound(all, none_of_all, threshold));
        write_chance(k_rate + name.substr(std::string(k_probability).size()),
                     rate_of(maps.probability[t], maps.margin[t]), most ? &*most : nullptr);
    }
    return maps;
}

void MapWriter::write_quantile(const std::string& name, const Raster& quantile,
                               const std::optional<Raster>& upper) const {
    gis::RasterBand band = band_of(name, quantile);
    band.text.description += ", at least";
    if (!upper) band.text.description += "; without an upper bound";
    std::vector<gis::RasterBand> bands{band};
    if (upper) bands.push_back({*upper, upper_text(name, band.text.unit)});
    write(name, bands);
}

gis::RasterBand MapWriter::band_of(const std::string& name, const Raster& raster) const {
    const ResultRaster& row = *find_result_raster(name);
    return {raster, {name, description_of(row, name, output_), row.unit, metadata_}};
}

void MapWriter::write(const std::string& name, const std::vector<gis::RasterBand>& bands) const {
    const ResultRaster& row = *find_result_raster(name);
    const std::string file = directory_.path(name + ".tif");
    gis::write_geotiff(file, bands);
    if (!row.is_drawn()) return;
    const std::vector<double> bounds = class_bounds(row, output_.classes, maximum(bands.front().raster));
    gis::write_styles(file, gis::class_stops(palette(row.palette), bounds, row.unit, words_, row.zero_is_blank),
                      row.unit, gis::StyleKind::classed, raster_title(row, name, words_));
}

}  // namespace frana::app::study
