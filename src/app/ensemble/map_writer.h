// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/ensemble/study_input.h"
#include "app/store/result_directory.h"
#include "gis/raster/raster_out.h"
#include "params/keys/classes.h"

namespace frana::app {

/// Writes rasters of the table with their texts and styles.
class MapWriter {
  public:
    MapWriter(const StudyInput& input, const ResultDirectory& directory);

    void write(const std::string& name, const Raster& raster) const { write(name, {band_of(name, raster)}); }
    void write_probability(const std::string& name, const Raster& probability, const Raster& error) const;

  private:
    [[nodiscard]] gis::RasterBand band_of(const std::string& name, const Raster& raster) const;
    void write(const std::string& name, const std::vector<gis::RasterBand>& bands) const;

    const ResultDirectory& directory_;
    std::map<std::string, std::string> metadata_;
    ClassSpec classes_;
};

}  // namespace frana::app
