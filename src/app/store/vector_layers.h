// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "gis/vector/vector_out.h"
#include "gis/vector/vector_style.h"
#include "params/keys/result_rasters.h"
#include "simulation/result.h"

namespace frana::app {

/// Returns the rasters that every run produces from the flow.
std::vector<ResultRaster> main_rasters();

/// Returns class bounds of a legend, the same in the GIS style and on the maps: those of the row, else those of its
/// quantity as far as values up to `maximum` need them, else or where these are few round ones up to the maximum, which
/// may be NaN (nothing flowed).
std::vector<double> class_bounds(const ResultRaster& row, double maximum);
/// The same up to the greatest depth outside the release, which hardly moved where it is deepest: what is deeper is in
/// an open class.
/// @param release its thickness, on the same cells
std::vector<double> class_bounds(const ResultRaster& row, const Raster& values, const Raster& release);
/// The last of the former: round ones up to the maximum.
std::vector<double> class_bounds(bool progressive, double maximum);

// Release and survey must be distinguishable from each other and from every palette.
inline constexpr Rgb k_release_colour{20, 20, 20};
inline constexpr Rgb k_scar_colour{0, 160, 220};
/// Of outlines of probability.
inline constexpr Rgb k_unlikely_colour{90, 90, 90}, k_even_chance_colour{20, 20, 20}, k_likely_colour{150, 0, 60};

/// How exposed features are drawn, by the attribute that says whether they are reached: in a GIS and on maps.
struct ExposureLook {
    double reached;     ///< 1, 0; NaN: the map says nothing of it
    const char* label;  ///< in English
    Rgb colour;
    double width_px;  ///< of lines on maps, as render::Outline
    bool dashed;
};
inline constexpr const char* k_reached = "reached";
const std::vector<ExposureLook>& exposure_looks();

/// A layer of a GeoPackage of a result.
struct VectorLayer {
    std::string file;   ///< "extent.gpkg"
    std::string name;   ///< "release"
    std::string title;  ///< in a GIS project
    gis::Shape shape = gis::Shape::area;
    gis::VectorLook look{};

    /// Its style, with the texts of a legend in a language.
    [[nodiscard]] gis::StyleText style(const Words& words = {}) const;
};

/// The one list of them, in the order in which a GIS shows them, the uppermost first.
const std::vector<VectorLayer>& vector_layers();

/// Returns the title of a row in a language.
std::string layer_title(const VectorLayer& row, const Words& words);

/// Returns the style of a row, its title and those of the attributes in a language.
gis::StyleText style_in(const VectorLayer& row, const Words& words);
/// Returns the titles that a GIS shows of the attributes of all layers.
gis::AttributeTitles attribute_titles(const Words& words);

/// Writes a GeoPackage of a result; its layers have the style of their row, unless they have one. Throws as
/// gis::write_shapes.
void write_result_shapes(const std::string& gpkg_path, const std::string& crs_wkt, std::vector<gis::ShapeLayer> layers,
                         const Words& words);

}  // namespace frana::app
