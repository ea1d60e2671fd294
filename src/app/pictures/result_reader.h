// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/store/frame_store.h"
#include "app/store/result_files.h"
#include "core/grid_spec.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/ini_file.h"
#include "params/keys/result_rasters.h"
#include "render/map/map2d.h"
#include "simulation/result.h"

namespace frana::app {

/// A quantity for the colours of particles, by its name in --map.
struct ParticleQuantity {
    const char* name;
    const char* attribute;  ///< in their files
    const char* colours;    ///< raster of the frames whose colours they have
    const char* title;
};
/// Null for other names.
const ParticleQuantity* find_particle_quantity(const std::string& name);

/// Returns the particles of a frame, a file particles_NNNN.gpkg of a result, valued by a quantity, the greatest values
/// last. Their width follows from the mean area of a particle. Throws Error(input).
render::Dots read_particle_dots(const std::string& path, const ParticleQuantity& quantity);

/// Throws Error(input) if the cells of `file` are not those of `other`: a raster of a result that was exchanged for
/// another would be drawn in the wrong place.
void require_cells(const GridSpec& grid, const std::string& file, const GridSpec& expected, const std::string& other);

/// A result directory, read from its files alone. Parts missing in an older or foreign result are omitted.
class ResultReader {
  public:
    /// Throws Error(input) if there is none, or nothing of a result in it.
    /// @param language of all texts; none: its own
    explicit ResultReader(std::string directory, std::optional<Language> language = std::nullopt);

    /// What the files of a run have is taken from the memory of that run as long as this is used: nothing is read
    /// again.
    void take_values_of(const RunResult& run) noexcept { run_ = &run; }

    [[nodiscard]] const std::string& directory() const noexcept { return directory_; }
    [[nodiscard]] std::string path(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Whether it has a vector file with a layer of this name that has a feature. Throws Error(input) if it is damaged.
    [[nodiscard]] bool has_layer(const std::string& file, const std::string& layer) const;
    /// Returns NAME.tif. Throws Error(input) if it is missing.
    [[nodiscard]] Raster raster(const std::string& name) const;
    /// The same. Throws Error(input) also if its cells differ from the grid's.
    [[nodiscard]] Raster raster_on(const GridSpec& grid, const std::string& name) const;
    /// Returns the vertical depths of NAME.tif, whatever output.depth chose. Throws Error(input) if it is missing.
    [[nodiscard]] Raster vertical_raster(const std::string& name) const;
    /// Returns a value of the result's scene.ini as text, if there is one.
    [[nodiscard]] std::optional<std::string> scene_value(const std::string& key) const;
    /// The same as a number, or a default.
    [[nodiscard]] double scene_number(const std::string& key, double otherwise) const;

    [[nodiscard]] const Words& words() const noexcept { return words_; }

    /// Returns NAME.tif for a map; "depth@12.5", "cohesion_ratio@12.5" (any raster of the frames), "particles@12.5" and
    /// "particle_cohesion@12.5" name the frame nearest in time [s]; "uncertainty" is that of `frana converge` beside
    /// the result. Throws Error(input) listing the available names.
    [[nodiscard]] MapLayer map_layer(const std::string& name) const;
    /// Replaces the values at the end beside the map, if those of this time [s] are known.
    void show_figures_of(double time, MapLayer& layer) const;
    [[nodiscard]] MapLayer particle_layer(const StoredFrame& frame, const ParticleQuantity& quantity) const;
    /// Returns the names of the run's rasters that can be drawn; terrain and bed are under all maps and not included.
    [[nodiscard]] std::vector<std::string> drawable() const;
    /// As listed at the first call, at least one. Throws Error(input).
    [[nodiscard]] const std::vector<StoredFrame>& frames() const;
    /// Whether it is the combined result of many runs (`frana ensemble`).
    [[nodiscard]] bool is_of_study() const;
    /// Returns what is known of the whole flow at each of these times [s]: lines for a map, from the nearest row of
    /// the time series; none without it.
    [[nodiscard]] std::vector<std::vector<std::string>> figures_at(const std::vector<double>& times) const;

    /// The maximum over time of a raster of the frames: max_NAME.tif, or else the greatest values of the frames.
    /// Throws Error(input).
    [[nodiscard]] const MapLayer& greatest(const std::string& quantity) const;
    /// The grid of its rasters, from the first of them.
    [[nodiscard]] const GridSpec& grid() const;

    /// Returns the common data of all maps; terrain and outlines only if the result has them.
    /// @param statistics of a run that is being written; none: those of its summary.json, or no such notes
    [[nodiscard]] MapSource map_source(const std::optional<MainStatistics>& statistics = std::nullopt) const;

  private:
    /// As map_layer(), without the exposed features.
    [[nodiscard]] MapLayer layer_of(const std::string& name) const;
    /// The classes of all depths of the flow, from the greatest over time.
    [[nodiscard]] const std::vector<double>& depth_classes() const;
    /// Values of NAME.tif from memory, as the file has them.
    [[nodiscard]] std::optional<Raster> in_memory(const std::string& name) const;
    [[nodiscard]] MapStyle style() const;
    /// The day of the run, from its summary; empty if it has none.
    [[nodiscard]] std::string run_date() const;
    [[nodiscard]] std::vector<render::Outline> marks(const std::string& crs_wkt) const;
    [[nodiscard]] MultiPolygon outline(const std::string& layer, const std::string& crs_wkt) const;
    /// Of the polygons of the release that have one.
    [[nodiscard]] std::vector<std::string> release_names(const std::string& crs_wkt) const;
    [[nodiscard]] MapFacts facts(const std::optional<MainStatistics>& statistics) const;

    static constexpr const char* k_hit_count = RasterName::hit_count;  ///< a raster that every study has
    /// That of its scene or, of a study, of its summary; English in older results.
    [[nodiscard]] Language own_language() const;
    void add_study(MapSource& source) const;

    /// Throws Error(input) if a file is missing.
    void require(const std::string& name) const;
    /// The raster that defines the grid.
    [[nodiscard]] std::string grid_raster() const;

    std::string directory_;
    const RunResult* run_ = nullptr;
    Words words_;
    struct Layers {
        std::filesystem::file_time_type time;
        std::set<std::string> filled;
    };
    mutable std::map<std::string, Layers> layers_;         ///< by file, read once: opening a GeoPackage takes long
    mutable std::optional<std::vector<IniEntry>> scene_;   ///< likewise
    mutable std::optional<std::string> crs_;               ///< of its rasters in memory, likewise
    mutable std::optional<GridSpec> grid_;                 ///< likewise
    mutable std::vector<double> depth_classes_;            ///< likewise
    mutable std::vector<StoredFrame> frames_;              ///< likewise
    mutable std::map<std::string, MapLayer> greatest_;     ///< likewise
    mutable std::optional<std::vector<Feature>> exposed_;  ///< likewise
};

}  // namespace frana::app
