// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/geometry.h"
#include "core/words/words.h"
#include "render/canvas/image.h"
#include "render/canvas/map_layout.h"
#include "render/canvas/page.h"

namespace frana::render {

/// Mapping of values to positions along an axis.
enum class Scale {
    linear,
    logarithmic,  ///< from the least to the greatest value; those of 0 and less have no position
    decades       ///< the same, between whole powers of ten
};

/// Decades of an axis: whole powers of ten around all its values, 10^low to 10^high.
struct Decades {
    int low = 0, high = 1;
};
/// Returns those of the positive values; 1 to 10 if there is none.
Decades decades_of(const std::vector<double>& values);

/// A position along an axis; without text it is between labelled ones.
struct Tick {
    double at = 0;  ///< [px]
    std::string words;
};

/// One axis, from its values to pixels of the page.
class ChartAxis {
  public:
    /// Where `values` begin and end on the page [px], and the least space of a label along the axis [px]. A linear axis
    /// that is `rounded` ends at labels.
    ChartAxis(Scale scale, const std::vector<double>& values, double from, double to, double room, bool rounded);

    [[nodiscard]] static bool has(Scale scale, double value);
    [[nodiscard]] double at(double value) const;
    /// Rising along the axis; unlabelled ones first.
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    [[nodiscard]] double place(double value) const;

    Scale scale_;
    double from_, to_, room_, least_ = 0, most_ = 1, step_ = 1;
};

/// Strokes distinguish lines in print without colours.
enum class Stroke { solid, dashed, dotted, dash_dot };

/// Okabe and Ito's colours, safe for the colour-blind, the dark ones first.
inline constexpr Rgb k_chart_colours[] = {{0, 114, 178}, {213, 94, 0},   {0, 158, 115}, {160, 80, 130},
                                          {90, 70, 50},  {86, 180, 233}, {230, 159, 0}};

enum class Marker { circle, square, triangle, diamond };
inline constexpr Stroke k_strokes[] = {Stroke::solid, Stroke::dashed, Stroke::dotted, Stroke::dash_dot};
inline constexpr Marker k_markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};

/// Points of one kind, joined by a line in the order given. A point without a place on an axis breaks the line: NaN, or
/// 0 and less on a logarithmic axis.
struct ChartSeries {
    std::string label;  ///< in the key; empty: not in it
    Rgb colour;
    std::vector<Point> points;
    double width_px = 2.2;  ///< on a page 1600 x 1200
    Stroke stroke = Stroke::solid;
    std::vector<double> foot{};  ///< as many as points: the area between them and the line is filled in a pale colour
    std::optional<Marker> marker{};
    double marker_gap_px = 0;  ///< least distance between markers, as width_px; 0: one at each point
};

/// Gives a curve of many points the colour, stroke and marker of a number, by which the curves of one chart are told
/// apart in print without colours: up to 20 differ in stroke or marker.
void look_apart(ChartSeries& series, std::size_t number);

/// A pair of axes.
struct ChartPanel {
    std::string title, x_label, y_label;
    std::vector<ChartSeries> series;
    std::vector<double> on_y{};  ///< values that the y axis includes besides those of the series
    Scale x = Scale::linear, y = Scale::linear;
    std::optional<double> mark_x{};  ///< a vertical dashed line
    double fraction = 1;             ///< of the page's height, relative to the panels beside it
    std::string note{};              ///< written in the panel if it has no point; default: that there are no values
    std::vector<double> on_x{};      ///< as on_y
    bool has_rows = false;           ///< y counts rows, which the key names: no numbers and lines along y
};

/// A page of panels in rows of `across` panels each.
struct Chart {
    std::string title, subtitle, foot;
    int across = 1;
    std::vector<ChartPanel> panels;
    bool alike = false;  ///< all panels have the first one's quantities, and kinds of series: named once for the page
    Words words{};       ///< of the numbers; the texts above are in its language already
    std::string long_subtitle{};  ///< in place of the subtitle where the page has room for it
};

/// Places of everything drawn, for tests.
struct ChartLayout {
    std::vector<PageBox> panels;             ///< the insides of the frames
    std::vector<TextBox> texts;              ///< of a picture
    std::vector<std::vector<Point>> points;  ///< of each series of each panel, in pixels
};

/// Draws the page; fills `layout`, if given. Throws Error(input) if the page is too small and Error(environment) if
/// fonts or OpenGL fail.
Page chart_page(const Chart& chart, int width, int height, ChartLayout* layout = nullptr);
/// The same as pixels.
Image draw_chart(const Chart& chart, int width, int height, ChartLayout* layout = nullptr);

/// Returns the same page as an SVG element for an HTML page.
std::string chart_svg(Chart chart, int width, int height, ChartLayout* layout = nullptr);

}  // namespace frana::render
