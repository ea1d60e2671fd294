// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/fragility.h"
#include "app/input/used_file.h"
#include "app/text/run_log.h"
#include "core/error.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_in.h"
#include "params/scene/read_scene.h"
#include "simulation/scene.h"

namespace frana::app {

/// Survey of an event, in the CRS of the result: any part may be missing.
struct Survey {
    MultiPolygon scar;
    std::string scar_label;
    std::vector<gis::NamedLine> fronts;
    std::vector<gis::NamedPoint> tips;
    std::string front_label;
    MultiPolygon deposit;
    std::optional<Raster> elevation_change;  ///< after minus before [m], on the result's grid
    std::string deposit_label;

    [[nodiscard]] bool empty() const noexcept {
        return scar.empty() && fronts.empty() && tips.empty() && deposit.empty() && !elevation_change;
    }
    /// The areas that must be on the grid of a comparison.
    [[nodiscard]] std::optional<Bounds> box() const;
};

/// Adds a file to a survey by its content: polygons (or closed lines) are a scar, open lines a front, points tips.
/// Throws Error(input).
void add_surveyed(const std::string& file, const std::string& crs_wkt, const Place& where, Findings found,
                  Survey& survey);

/// Adds a deposit: polygons, or a raster of elevation change. Throws Error(input).
UsedFile add_deposit(const std::string& file, const GridSpec& grid, const Place& where, Findings found, Survey& survey);

/// Returns the polygons of all features of a layer.
MultiPolygon parts_of(const std::vector<Feature>& features);

/// Recordings, comparisons and exposed features of a run besides its release, from the keys output.gauges,
/// cross-sections, profiles, exposure and scar.front, deposit.
struct ExtraInput {
    std::vector<Gauge> gauges;
    std::vector<CrossSection> sections;
    std::vector<gis::NamedLine> profiles;
    Survey survey;  ///< without the scar, which is read with the release
    std::optional<gis::FeatureLayer> exposure;
    std::optional<Fragility> fragility;  ///< of the exposed features
};

/// Reads them for a working grid. Adds every problem to `problems`, including places outside the grid, and the files
/// read to `files`.
ExtraInput prepare_extra(const SceneReading& reading, const GridSpec& grid, std::vector<UsedFile>& files,
                         Findings found, Problems& problems);

}  // namespace frana::app
