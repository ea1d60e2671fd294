// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/input/prepare.h"
#include "app/store/result_directory.h"
#include "app/study/plan/study_input.h"
#include "app/study/pool/study_result.h"
#include "app/study/statistics/study_maps.h"
#include "core/words/words.h"
#include "gis/raster/raster_out.h"
#include "params/keys/scene_spec.h"

namespace frana::app::study {

/// The name of a rate, from that of its probability.
std::string rate_name(const std::string& probability);

/// Writes rasters of the table of result rasters with their texts and styles.
class MapWriter {
  public:
    /// @param base of which the rasters are made
    MapWriter(const Prepared& base, const ResultDirectory& directory);

    void write(const std::string& name, const Raster& raster) const { write(name, raster, {}); }
    /// Makes the maps of events, and writes their probabilities: with the margin as second band; 0, not nodata, where
    /// nothing came. Of open runs the upper bound is the third.
    QuantityMaps write_probabilities(const StudyRuns& runs, const GridSpec& grid, const MappedEvents& events) const;
    /// The same of the rates of a study with a frequency, and of their return periods; of depth and velocity also what
    /// is exceeded once in so many years, with its interval as next bands.
    RateMaps write_rates(const StudyResult& result, const MappedEvents& events,
                         const std::vector<double>& periods) const;

    /// Itself a lower bound, with the upper one as next band.
    /// @param upper none: the quantile has none
    void write_quantile(const std::string& name, const Raster& quantile, const std::optional<Raster>& upper) const;

  private:
    /// A band beside the values: how its name ends, what it is; null: there is none.
    struct Beside {
        const char* ending;
        std::string text;
        const Raster* raster;
    };
    /// @param note on the values  @param zero_elsewhere as RasterBand's, of all bands
    void write(const std::string& name, const Raster& values, const std::vector<Beside>& more,
               const std::string& note = "", bool zero_elsewhere = false) const;
    /// A probability or rate, its margin and, if any, its upper bound.
    void write_chance(const std::string& name, const Raster& chance, const Raster& margin, const Raster* upper) const;
    /// Years between events of a rate.
    void write_return_period(const std::string& name, const Raster& rate, const Raster& margin,
                             const Raster* upper) const;
    void write_interval(const std::string& name, const Raster& value, const Raster& low, const Raster& high,
                        const std::string& of_high) const;

    const ResultDirectory& directory_;
    std::map<std::string, std::string> metadata_;
    OutputSpec output_;
    Words words_;
};

}  // namespace frana::app::study
