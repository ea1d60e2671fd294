// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/svg_drawing.h"

#include <array>
#include <cmath>

#include "core/text.h"
#include "render/canvas/page.h"

namespace frana::render {
namespace {

constexpr const char* k_look = " font-family=\"DejaVu Sans, Verdana, sans-serif\" stroke-linejoin=\"round\"";

// Formats to a hundredth of a pixel.
std::string px(double value) {
    return shortest_text(std::round(100 * value) / 100 + 0.0);  // no "-0"
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + '"';
}

std::string opacity_attribute(double opacity) {
    return opacity < 1 ? attribute("opacity", px(opacity)) : "";
}

std::string points_attribute(std::span<const Point> points) {
    std::string list;
    for (const Point p : points) list += (list.empty() ? "" : " ") + px(p.x) + ',' + px(p.y);
    return attribute("points", list);
}

}  // namespace

std::string SvgDrawing::svg() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + std::to_string(width_) + ' ' +
           std::to_string(height_) + "\" role=\"img\"" + std::string(k_look) + ">\n" + shapes_ + texts_ + "</svg>\n";
}

std::string SvgDrawing::part(int left, int top) const {
    return "<svg" + attribute("x", std::to_string(left)) + attribute("y", std::to_string(top)) +
           attribute("width", std::to_string(width_)) + attribute("height", std::to_string(height_)) + ">\n" + shapes_ +
           texts_ + "</svg>\n";
}

void SvgDrawing::line(std::span<const Point> points, const LineStyle& style, bool closed) {
    std::string dashes;
    for (const double length : style.dashes) dashes += (dashes.empty() ? "" : " ") + px(length);
    shapes_ += (closed ? "<polygon" : "<polyline") + points_attribute(points) + attribute("fill", "none") +
               attribute("stroke", hex(style.colour)) + attribute("stroke-width", px(style.width_px)) +
               (dashes.empty() ? "" : attribute("stroke-dasharray", dashes)) + opacity_attribute(style.opacity) +
               "/>\n";
}

void SvgDrawing::fill(std::span<const Point> corners, Rgb colour, double opacity) {
    shapes_ +=
        "<polygon" + points_attribute(corners) + attribute("fill", hex(colour)) + opacity_attribute(opacity) + "/>\n";
}

void SvgDrawing::frame(const PageBox& box, const LineStyle& style) {
    line(
        std::array<Point, 4>{
            {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}},
        style, true);
}

void SvgDrawing::text(const std::string& words, Point at, const TextStyle& style, Across across, Upright upright) {
    const double capital = capital_height(style);
    const double below = upright == Upright::top ? capital : upright == Upright::middle ? capital / 2 : 0;
    std::string place = "translate(" + px(at.x) + ' ' + px(at.y) + ')';
    if (style.angle_deg != 0) place += " rotate(" + px(-style.angle_deg) + ')';
    texts_ +=
        "<text" + attribute("transform", place) + attribute("y", px(below)) +
        (across == Across::left     ? ""
         : across == Across::centre ? attribute("text-anchor", "middle")
                                    : attribute("text-anchor", "end")) +
        attribute("font-size", std::to_string(style.size_px)) + (style.bold ? attribute("font-weight", "bold") : "") +
        (style.halo_px > 0 ? attribute("stroke", hex(style.halo)) + attribute("stroke-width", px(2 * style.halo_px)) +
                                 attribute("paint-order", "stroke")
                           : "") +
        attribute("fill", hex(style.colour)) + '>' + escaped_markup(words) + "</text>\n";
}

std::string page_svg(const Page& page, double dots_per_inch, const std::string& title) {
    const double millimetre = 25.4 / dots_per_inch;
    std::string all =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"" +
        attribute("width", px(page.width() * millimetre) + "mm") +
        attribute("height", px(page.height() * millimetre) + "mm") +
        attribute("viewBox", "0 0 " + std::to_string(page.width()) + ' ' + std::to_string(page.height())) + k_look +
        ">\n<title>" + escaped_markup(title) + "</title>\n" +
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    for (const Page::Part& part : page.parts()) {
        if (part.picture) {
            // The cells of a raster have edges.
            all += "<image" + attribute("x", std::to_string(part.left)) + attribute("y", std::to_string(part.top)) +
                   attribute("width", std::to_string(part.picture->width)) +
                   attribute("height", std::to_string(part.picture->height)) +
                   attribute("image-rendering", "optimizeSpeed") +
                   attribute("xlink:href", "data:image/png;base64," + base64(png_bytes(*part.picture))) + "/>\n";
        } else {
            SvgDrawing drawing(part.drawing.width(), part.drawing.height());
            part.drawing.replay(drawing);
            all += drawing.part(part.left, part.top);
        }
    }
    return all + "</svg>\n";
}

}  // namespace frana::render
