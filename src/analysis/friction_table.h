// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"
#include "core/words/words.h"

namespace frana {

/// Voellmy's two parameters.
struct FrictionPair {
    double coefficient = 0;  ///< mu [-]
    double turbulence = 0;   ///< xi [m/s2]
};

/// Published friction by return period, volume, terrain and altitude: a file of share/friction or a user's own
/// (src/params/scene/read_friction_table.h).
struct FrictionTable {
    /// A class of terrain: gentle ground, or by the curvature of the ground across the slope.
    struct Terrain {
        std::string name{};    ///< "Gully"
        double curvature = 0;  ///< at which its values apply [1/m]; linear in between, the nearest class' beyond
        std::optional<double> slope_below{};  ///< instead, of the first class: all ground less steep [degrees]
    };
    /// What forest changes.
    struct Forest {
        double more_friction = 0;  ///< added to mu [-]
        double turbulence = 0;     ///< replaces xi [m/s2]
    };

    std::string name{};               ///< of the file, without .ini
    std::string file{};               ///< where it was read
    std::string called{};             ///< its title
    std::string named_source{};       ///< of the values
    std::string quote{}, read_at{};   ///< words of it and where they were read; empty: not read
    std::string note{};               ///< what a user of it should know
    OwnTexts texts{};                 ///< its names in other languages
    std::vector<double> periods{};    ///< return periods [years], rising
    std::vector<double> volumes{};    ///< least release volume of each class but the first [m3], rising
    std::vector<double> altitudes{};  ///< least elevation of each band but the lowest [m], rising
    std::vector<Terrain> terrain{};   ///< gentle ground, then by rising curvature
    double spacing = 0;               ///< of the elevations from which curvature is computed [m]
    std::optional<double> density{};  ///< of the flow that it is for [kg/m3]
    std::optional<Forest> forest{};   ///< none: the table does not say
    std::vector<FrictionPair> values{};

    [[nodiscard]] bool is_source_read() const { return !quote.empty(); }
    [[nodiscard]] const FrictionPair& at(std::size_t period, std::size_t volume, std::size_t kind,
                                         std::size_t band) const {
        return values[((period * (volumes.size() + 1) + volume) * terrain.size() + kind) * (altitudes.size() + 1) +
                      band];
    }
};

/// The part of a table that a scene uses.
struct FrictionChoice {
    FrictionTable table{};         ///< with the scene's altitude limits
    std::size_t period = 0;        ///< index of the return period
    double volume = 0;             ///< by which the class is chosen [m3]
    double friction_factor = 1;    ///< of every mu
    double turbulence_factor = 1;  ///< of every xi

    [[nodiscard]] std::size_t volume_class() const;
    /// Returns the class of a volume 5 % smaller or larger, if it is another: it is as likely.
    [[nodiscard]] std::optional<std::size_t> close_class() const;
    /// Returns the values of a class of terrain, with forest and factors.
    [[nodiscard]] FrictionPair at(std::size_t kind, std::size_t band, bool forest) const;
};

/// Returns the index of the class of a value between rising limits; a value on a limit belongs to the upper class.
std::size_t class_between(const std::vector<double>& limits, double value);

struct GroundShape {
    double slope = 0;      ///< tangent [-]
    double curvature = 0;  ///< across the slope [1/m]
};

/// Returns the slope of the ground, and its second derivative in the direction of the contour:
///
///     C = (z_xx z_y^2 - 2 z_xy z_x z_y + z_yy z_x^2) / max(0.01, z_x^2 + z_y^2)
///
/// positive in a channel, negative on a ridge; in flat ground (slope below 0.1) it fades out. The derivatives are those
/// of the parabola fitted to 3 x 3 elevations `step` cells apart (Evans 1980, Z. Geomorph. Suppl. 36, 274); 0 where one
/// of them is missing. The formula with its bound is that of NGI's NAKSIN (repository
/// norwegian-geotechnical-institute/Avaframe-Workshop, Friction.py, _terrain_parameters).
GroundShape ground_shape(const Raster& terrain, std::int64_t row, std::int64_t column, std::int64_t step);

/// Friction of every place of a terrain after a table.
class FrictionByPlace {
  public:
    struct Place {
        std::size_t kind = 0;  ///< nearest class of terrain
        std::size_t band = 0;  ///< of altitude
        bool forest = false;
        FrictionPair values{};
    };

    /// @param forest anything but NaN where forest stands; none: nowhere
    FrictionByPlace(FrictionChoice choice, Raster terrain, std::optional<Raster> forest);

    /// None where the ground has no elevation. Between two classes of terrain, mu and 1/xi are linear in curvature (as
    /// in NAKSIN's _friction_params): friction has no jumps where a slope turns into a channel.
    [[nodiscard]] std::optional<Place> at(std::int64_t row, std::int64_t column) const;
    [[nodiscard]] const FrictionChoice& choice() const noexcept { return choice_; }
    [[nodiscard]] const Raster& terrain() const noexcept { return terrain_; }
    /// Returns the spacing of the elevations used for the curvature [m]: the table's, in whole cells, at least one.
    [[nodiscard]] double spacing() const { return static_cast<double>(step_) * terrain_.grid.cell_size; }

  private:
    FrictionChoice choice_;
    Raster terrain_;
    std::optional<Raster> forest_;
    std::int64_t step_;
};

/// Ground with the same class of terrain and altitude.
struct FrictionArea {
    std::size_t kind = 0, band = 0;
    bool forest = false;
    double area_m2 = 0;
};

/// Returns the areas of the cells that a mask on the terrain's grid, or a part of it, marks (neither 0 nor NaN); none
/// is empty.
std::vector<FrictionArea> friction_areas(const FrictionByPlace& friction, const Raster& mask);

}  // namespace frana
