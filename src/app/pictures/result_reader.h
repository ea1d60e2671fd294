// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/store/frame_store.h"
#include "app/store/result_files.h"

namespace frana::app {

/// A result directory, read back from its files alone. What an older or foreign result lacks is left out; a run that
/// has not ended has its ground and its frames so far.
class ResultReader {
  public:
    /// Where the directory is not there, but one that is to take its name, it is that. Throws Error(input) when there
    /// is neither, or nothing of a result in it.
    explicit ResultReader(std::string directory);

    [[nodiscard]] const std::string& directory() const noexcept { return directory_; }
    [[nodiscard]] std::string path(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// NAME.tif. Throws Error(input) when it is missing.
    [[nodiscard]] Raster raster(const std::string& name) const;
    /// The same. Throws Error(input) also where its cells are not the grid's.
    [[nodiscard]] Raster raster_on(const GridSpec& grid, const std::string& name) const;
    /// A value of the result's scene.ini as text, if there is one.
    [[nodiscard]] std::optional<std::string> scene_value(const std::string& key) const;
    /// The same as a number, or a default.
    [[nodiscard]] double scene_number(const std::string& key, double otherwise) const;

    /// NAME.tif as a map shows it; "depth@12.5", "velocity@12.5" and "particles@12.5" name the frame nearest
    /// in time [s]; "uncertainty" is that of `frana converge` beside the result. Throws Error(input) naming
    /// what there is.
    [[nodiscard]] MapLayer map_layer(const std::string& name) const;
    /// The particles of a frame as a map shows them. Throws Error(input) where they were not written.
    [[nodiscard]] MapLayer particle_layer(const StoredFrame& frame) const;
    /// The rasters of the run that can be drawn, by name; terrain and bed are under all maps and not among
    /// them.
    [[nodiscard]] std::vector<std::string> drawable() const;
    /// As listed when first asked for, at least one: of a run under way none that come later. Throws Error(input).
    [[nodiscard]] const std::vector<StoredFrame>& frames() const;
    /// Whether its run has not ended: it has frames, no maxima, and no summary, which comes last.
    [[nodiscard]] bool under_way() const { return !has(k_summary_file) && !has("max_depth.tif") && has(k_frame_list); }
    /// Of "depth" or "velocity": the maximum over time, of a run that has not ended over its frames so far.
    /// Throws Error(input).
    [[nodiscard]] const MapLayer& greatest(const std::string& quantity) const;
    /// Of its rasters, as the first of them has it.
    [[nodiscard]] const GridSpec& grid() const;

    /// Everything maps share; terrain and outlines only where the result has them.
    /// @param values of a run that is being written; none: those of its summary.json, or no such notes
    [[nodiscard]] MapSource map_source(const std::optional<MainStatistics>& statistics = std::nullopt) const;

  private:
    [[nodiscard]] MapStyle style() const;
    [[nodiscard]] std::vector<render::Outline> marks(const std::string& crs_wkt) const;
    [[nodiscard]] MultiPolygon outline(const std::string& layer, const std::string& crs_wkt) const;
    [[nodiscard]] MapFacts facts(const std::optional<MainStatistics>& statistics) const;

    /// Throws Error(input) where a file is missing.
    void require(const std::string& name) const;
    /// The raster that tells the grid.
    [[nodiscard]] std::string grid_raster() const;

    std::string directory_;
    mutable std::optional<GridSpec> grid_;              ///< read once
    mutable std::vector<StoredFrame> frames_;           ///< likewise
    mutable std::map<std::string, MapLayer> greatest_;  ///< likewise
};

}  // namespace frana::app
