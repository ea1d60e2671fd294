// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"
#include "core/words/words.h"
#include "render/canvas/page.h"
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

/// Input of a colour scale; members as in PictureSpec.
struct ScaleRequest {
    std::string palette;
    std::vector<double> classes;
    std::vector<ClassLabel> categories;
    const Raster* layer = nullptr;
    bool for_unseen_values = false;  ///< others follow, none over `layer`'s greatest value, if it has any
    Words words{};                   ///< of the classes' numbers
};

/// Maps values to colours: one of a few classes, the same on the map and in the legend, the palette's mixed with white.
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

  private:
    void set_categories(const std::vector<ClassLabel>& categories);
    void set_bounds(const std::vector<double>& bounds, bool open_below, bool open_above, const Palette& palette);

    std::vector<ColourClass> classes_;
    bool categorical_ = false;
    Words words_;
};

/// Whether a picture has anything to colour.
bool has_values(const PictureSpec& spec);
/// Returns the scale of a picture: of one without values none, unless rasters of other `frames` will follow.
ColourScale scale_of(const PictureSpec& spec, bool for_frames);

/// Metres of ground under a pixel of a page at 1 : n.
double metres_per_pixel(double n, double dots_per_inch);
/// The inverse: n.
double scale_of(double metres_per_pixel, double dots_per_inch);
/// Returns the least round scale that is at least `n`: 1000, 1250, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7500, 8000
/// and ten times these, and so on: a map shrinks by a quarter at most.
double round_scale_above(double n);

/// Returns the ground shown in a frame of width x height pixels. `required`: must be visible; `free`: the same with a
/// margin, and the frame's proportions. With print.scale: that scale, centred; without, the least round scale at
/// which the content fits; of what is not printed `free`. Throws Error(input) if the content does not fit at
/// print.scale.
Bounds window_at_scale(const Print& print, const Bounds& required, const Bounds& free, int width, int height);

/// The least n at which `required` fits.
double least_scale(const Print& print, const Bounds& required, int width, int height);

/// Returns "1 : 5 000".
std::string scale_words(double n, const Words& words = {});
/// Returns what the scale refers to: "on A4", "printed 27.1 x 20.3 cm".
std::string print_words(const Print& print, double page_width, double page_height, const Words& words = {});

/// Contents of a legend.
struct LegendContent {
    std::string title, unit;
    const ColourScale* scale = nullptr;
    const std::vector<Outline>* outlines = nullptr;
    const std::vector<std::string>* notes = nullptr;
};

/// Returns the preferred width of a legend, at most `most` [px].
double legend_width(const LegendContent& content, const PageStyle& style, const Sheet& sheet, double most);

/// Draws a legend from its upper left corner downwards: title with unit, a box per class (greatest on top), a line per
/// outline, the notes. Returns the y below it.
double draw_legend(const LegendContent& content, const PageStyle& style, Point corner, double width, Sheet& sheet,
                   std::vector<LegendEntry>& entries);

/// Returns the dashes of an outline of this width; empty if it is solid.
std::vector<double> outline_dashes(const Outline& outline, double width_px);

}  // namespace frana::render
