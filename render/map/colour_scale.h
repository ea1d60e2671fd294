// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "render/map/map2d.h"

namespace frana::render {

/// A class of values and its colour; open ends are infinite.
struct ColourClass {
    double lower = 0, upper = 0;
    std::string label;
    Rgb colour;
};

/// The least and greatest value of a raster.
struct ValueRange {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const noexcept { return !(least <= greatest); }  ///< no values at all
};
ValueRange value_range(const Raster& raster);

/// Input of a colour scale; members as in MapSpec.
struct ScaleRequest {
    std::string palette;
    std::optional<double> maximum;
    std::vector<double> classes;
    bool continuous = false;
    std::vector<ClassLabel> categories;
    const Raster* layer = nullptr;
    bool for_unseen_values = false;  ///< others follow, none over `layer`'s greatest value, if it has any
    Words words{};                   ///< of the classes' numbers
};

/// Maps values to colours: one of a few classes, the same on the map and in the legend.
class ColourScale {
  public:
    /// No classes at all: nothing is coloured.
    ColourScale() = default;
    /// Throws Error(input) with every contradiction.
    explicit ColourScale(const ScaleRequest& request);

    /// Returns the class of a value; null for NaN and for values without a class.
    [[nodiscard]] const ColourClass* find(double value) const noexcept;
    [[nodiscard]] const std::vector<ColourClass>& classes() const noexcept { return classes_; }
    [[nodiscard]] bool categorical() const noexcept { return categorical_; }
    /// A bound as the legend writes it.
    [[nodiscard]] std::string number_of(double bound) const;
    /// The bounds numbered in a legend; none for categories.
    [[nodiscard]] const std::vector<double>& bounds() const noexcept { return bounds_; }
    /// For a continuous scale: number of classes, too fine to be distinguished, between two bounds; else 1.
    [[nodiscard]] int slices() const noexcept { return slices_; }

  private:
    void set_categories(const std::vector<ClassLabel>& categories);
    void set_bounds(bool open_below, bool open_above, const Palette& palette);

    std::vector<ColourClass> classes_;
    bool categorical_ = false;
    std::vector<double> bounds_;
    int slices_ = 1;
    Words words_;
};

}  // namespace frana::render
