// SPDX-License-Identifier: Apache-2.0
#include "app/study/publish/map_writer.h"

#include "analysis/trace.h"
#include "app/pictures/map_layer.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "gis/raster/styles.h"
#include "params/keys/output_parameters.h"
#include "params/keys/result_rasters.h"

namespace frana::app::study {

MapWriter::MapWriter(const Prepared& base, const ResultDirectory& directory)
    : directory_(directory), metadata_(provenance(base)), output_(base.spec.output), words_(words_of(base.spec)) {}

void MapWriter::write(const std::string& name, const Raster& raster) const {
    write(name, {band_of(name, raster)});
}

gis::BandText MapWriter::upper_text(const std::string& name, const std::string& unit) const {
    return {name + "_upper", "upper bound: runs whose full reach is not known could have come", unit, metadata_};
}

QuantityMaps MapWriter::write_probabilities(const FinishedMembers& finished, const OpenRuns& all, const GridSpec& grid,
                                            const MappedEvents& events) const {
    QuantityMaps maps = quantity_maps(finished, events.quantity, grid, events.thresholds);
    std::vector<Raster> upper;
    if (all.any()) upper = probability_bounds(maps.probability, all, events.quantity, events.thresholds, grid);
    for (std::size_t t = 0; t < events.rasters.size(); ++t) {
        const std::string& name = events.rasters[t];
        gis::RasterBand band = band_of(name, maps.probability[t]);
        band.zero_elsewhere = true;
        std::vector<gis::RasterBand> bands{
            band,
            {maps.margin[t],
             {name + "_margin", "Half of the interval of 95 % of the probability", "-", metadata_},
             true}};
        if (!upper.empty()) bands.push_back({upper[t], upper_text(name, "-"), true});
        write(name, bands);
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
