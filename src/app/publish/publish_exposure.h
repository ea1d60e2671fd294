// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/exposure.h"
#include "analysis/fragility.h"
#include "app/store/result_directory.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "gis/vector/vector_in.h"

namespace frana::app {

/// A feature that is reached, as reports name it.
struct ReachedFeature {
    std::string name;
    std::vector<std::pair<std::string, double>> numbers;     ///< of its row
    std::vector<std::pair<std::string, std::string>> texts;  ///< of its row
    double depth = 0;
};

/// What all features together lose.
struct DamageSum {
    std::string name;      ///< of the columns: "annual_damage", "T30_expected_damage"
    std::string scenario;  ///< of a region
    Damage damage{};

    [[nodiscard]] std::string title(const Words& words) const;
};
inline constexpr const char *k_expected_damage = "expected_damage", *k_annual_damage = "annual_damage";

/// Sums over all features.
struct ExposureTotals {
    std::size_t features = 0, reached = 0, off_map = 0;
    double count = 0, count_reached = 0;  ///< of the count column, else features
    bool has_count = false;
    bool is_least = false;                  ///< the full reach of the flow, or of some run, is not known
    std::vector<ReachedFeature> deepest{};  ///< the deepest first, k_most_named at most
    std::vector<DamageSum> damages{};
    /// Titles and names of further numbers or texts of a row that reports show; several in one column.
    std::vector<std::pair<std::string, std::vector<std::string>>> more_columns{};
};

/// Features that a report names; exposure.csv has all.
inline constexpr std::size_t k_most_named = 50;

/// What reaches the features.
enum class ReachedBy { the_flow, any_run };

/// The cells of each feature on a grid.
std::vector<std::vector<std::size_t>> exposed_cells(const gis::FeatureLayer& layer, const GridSpec& grid);

/// Returns a row for each feature, in order.
/// @param map what was computed; cells may cover less, where nothing else was reached
std::vector<ExposureRow> exposure_rows(const gis::FeatureLayer& layer, const std::vector<ExposureValues>& values,
                                       const Bounds& map);

/// Adds the damage of each feature to its row: NAME, NAME_low, NAME_high; NULL for one off the map. Returns their sum
/// under this name, each number added up.
DamageSum add_damages(const std::string& name, const std::string& scenario, const std::vector<Damage>& damages,
                      std::vector<ExposureRow>& rows);
/// The same of one event, whose greatest values the rows have under names that begin with `prefix`.
/// @param is_open whether they may be greater: then all may be lost
DamageSum add_event_damage(const Fragility& fragility, const std::string& prefix, const std::string& scenario,
                           bool is_open, std::vector<ExposureRow>& rows);

/// Writes exposure.gpkg and exposure.csv with every feature of the layer. Returns the sums.
/// @param words of the legend in the GeoPackage's styles
ExposureTotals write_exposure(const gis::FeatureLayer& layer, const std::vector<ExposureRow>& rows,
                              const std::string& crs_wkt, const Words& words, const ResultDirectory& directory);

/// "12 of 340 exposed features are reached. By their count: 45 of 1 200. Of 3 features the map says nothing: see
/// exposure.csv."
std::string exposure_sentence(const ExposureTotals& totals, ReachedBy by, const Words& words = {});

}  // namespace frana::app
