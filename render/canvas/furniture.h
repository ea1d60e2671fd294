// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/words/words.h"
#include "render/canvas/page.h"

namespace frana::render {

/// A placed scale bar.
struct ScaleBar {
    PageBox box;  ///< of the bar alone
    double metres = 0;
};

/// Height of the scale bar with its labels [px].
double scale_bar_height(const PageStyle& style);
/// Draws a bar of a round length, as long as fits into `width` pixels with its labels; `corner` is its upper left one.
ScaleBar draw_scale_bar(Sheet& sheet, const PageStyle& style, Point corner, double width, double metres_per_pixel,
                        const Words& words);

/// Height of the north arrow [px] at any angle.
double north_arrow_height(const PageStyle& style);
/// Draws an arrow to the north, turned clockwise by `angle_deg`; `centre` is that of its bounding box, which is
/// returned.
PageBox draw_north_arrow(Sheet& sheet, const PageStyle& style, Point centre, double angle_deg);
/// Returns the text for the angle between true north and grid north; empty if it is negligible.
std::string convergence_words(double convergence_deg, const Words& words);

/// Title and subtitle, shrunk or broken into lines to fit `width`; returns the y below them. With `subtitle_later` the
/// subtitle's place is left free and returned in `subtitle_at`.
struct TitleResult {
    double bottom = 0;
    Point subtitle_at;
};
TitleResult draw_titles(Sheet& sheet, const PageStyle& style, const std::string& title, const std::string& subtitle,
                        bool subtitle_later, Point corner, double width);

/// Returns a drawing of a subtitle alone, at the place that draw_titles left free. Line ends separate its parts: those
/// for which there is no room are left out, the last first.
std::shared_ptr<const Overlay> late_subtitle(int width, int height, const PageStyle& style, const std::string& subtitle,
                                             Point at);

/// Returns a style with letters shrunk, to `least_fraction` at most, so that a text fits `width`.
TextStyle shrunk_to_fit(const Lettering& lettering, const std::string& words, TextStyle style, double width,
                        double least_fraction);

/// Returns the parts joined as at the foot of a page, without empty ones.
std::string foot_line(const std::vector<std::string>& parts);
/// Height of draw_foot's small print.
double foot_height(const Sheet& sheet, const PageStyle& style, const std::vector<std::string>& parts, double width);
/// Draws small print at the foot of the page, upwards from the bottom; returns the y of its upper edge.
double draw_foot(Sheet& sheet, const PageStyle& style, const std::vector<std::string>& parts, double left,
                 double bottom, double width);

/// Returns the smallest of 1, 2, 5 times a power of ten that is at least `least` (positive).
double nice_step_above(double least);
/// Returns the greatest of 1, 2, 5 times a power of ten that is at most `most` (positive).
double nice_step_below(double most);

/// Returns all multiples of `step` in [from, to], rising.
std::vector<double> multiples(double from, double to, double step);

/// Returns a number in as few digits as distinguish it from its neighbours: "0.5", "20", "1250".
std::string number(double value);
/// Returns a whole number in groups of three digits: "5 094 000".
std::string grouped(double value);

}  // namespace frana::render
