// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/canvas/ticks.h"
#include "render/chart/chart_parts.h"

namespace frana::render {
namespace {

constexpr Rgb k_grid{222, 225, 229}, k_fine_grid{240, 241, 243};
constexpr double k_width = 2.2;  // of a series [px] on a page 1600 x 1200

std::string power_of_ten(int exponent) {
    if (exponent >= -3 && exponent <= 4) return number(std::pow(10.0, exponent));
    return exponent < 0 ? "1e\u2212" + std::to_string(-exponent) : "1e" + std::to_string(exponent);
}

bool drawable(Point p) {
    return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y);
}

void draw_marker(Sheet& sheet, Marker marker, Point at, double size, Rgb colour) {
    std::vector<Point> corners;
    const auto ring = [&](int sides, double radius, double turn) {
        for (int k = 0; k < sides; ++k) {
            const double angle = turn + 2 * 3.141592653589793 * k / sides;
            corners.push_back({at.x + radius * std::sin(angle), at.y - radius * std::cos(angle)});
        }
    };
    switch (marker) {
        case Marker::circle:
            ring(20, size, 0);
            break;
        case Marker::square:
            ring(4, 1.3 * size, 0.7853981633974483);
            break;
        case Marker::triangle:
            ring(3, 1.4 * size, 0);
            break;
        case Marker::diamond:
            ring(4, 1.35 * size, 0);
            break;
    }
    sheet.canvas().fill(corners, colour);
}

// One panel's axes, from powers of ten to pixels.
class Axes {
  public:
    Axes(const ChartPanel& panel, const PageBox& box) : box_(box) {
        std::vector<double> x, y;
        for (const ChartSeries& series : panel.series) {
            for (const Point p : series.points) {
                if (!drawable(p)) continue;
                x.push_back(p.x);
                y.push_back(p.y);
            }
        }
        x_ = decades_of(x);
        y_ = decades_of(y);
    }

    [[nodiscard]] double across(double value) const {
        return box_.left + box_.width() * (std::log10(value) - x_.low) / (x_.high - x_.low);
    }
    [[nodiscard]] double down(double value) const {
        return box_.bottom - box_.height() * (std::log10(value) - y_.low) / (y_.high - y_.low);
    }

    void draw(const PageStyle& style, Sheet& sheet) const {
        const LineStyle fine{style.line(1), k_fine_grid}, whole{style.line(1), k_grid};
        for (int e = x_.low; e < x_.high && x_.high - x_.low < 5; ++e) {
            for (int k = 2; k < 10; ++k) grid_upright(sheet, box_, across(k * std::pow(10.0, e)), fine);
        }
        for (int e = y_.low; e < y_.high && y_.high - y_.low < 5; ++e) {
            for (int k = 2; k < 10; ++k) grid_level(sheet, box_, down(k * std::pow(10.0, e)), fine);
        }
        for (int e = x_.low; e <= x_.high; e += stride(x_, 5)) {
            const double x = across(std::pow(10.0, e));
            grid_upright(sheet, box_, x, whole);
            number_below(sheet, style, box_, x, power_of_ten(e));
        }
        for (int e = y_.low; e <= y_.high; e += stride(y_, 5)) {
            const double y = down(std::pow(10.0, e));
            grid_level(sheet, box_, y, whole);
            number_beside(sheet, style, box_, y, power_of_ten(e));
        }
        sheet.canvas().frame(box_, {style.line(1.5), k_soft_ink});
    }

  private:
    static int stride(Decades decades, int labels) {
        return std::max(1, (decades.high - decades.low + labels - 1) / labels);
    }

    PageBox box_;
    Decades x_, y_;
};

void draw_series(const ChartSeries& series, const Axes& axes, const PageStyle& style, Sheet& sheet,
                 ChartLayout& layout) {
    std::vector<Point> places;
    for (const Point p : series.points)
        if (drawable(p)) places.push_back({axes.across(p.x), axes.down(p.y)});
    sheet.canvas().line(places, chart_line(style, series.colour, k_width, series.stroke));
    for (const Point place : places) draw_marker(sheet, series.marker, place, 1.2 + style.line(3.2), series.colour);
    layout.points.push_back(std::move(places));
}

void draw_panel(const ChartPanel& panel, const PageBox& box, const PageStyle& style, Sheet& sheet,
                ChartLayout& layout) {
    sheet.text(panel.title, {box.left, box.top - 0.5 * style.label.size_px}, style.heading, Across::left,
               Upright::baseline);
    const Axes axes(panel, box);
    const std::size_t before = layout.points.size();
    axes.draw(style, sheet);
    for (const ChartSeries& series : panel.series) draw_series(series, axes, style, sheet, layout);
    const bool empty = std::all_of(layout.points.begin() + static_cast<std::ptrdiff_t>(before), layout.points.end(),
                                   [](const auto& places) { return places.empty(); });
    if (empty && !panel.note.empty()) {
        sheet.text(panel.note, {(box.left + box.right) / 2, (box.top + box.bottom) / 2}, style.small, Across::centre,
                   Upright::middle);
    }
    layout.panels.push_back(box);
}

// Every label once.
std::vector<const ChartSeries*> kinds_of(const ChartContent& content) {
    std::vector<const ChartSeries*> kinds;
    for (const ChartPanel& panel : content.panels) {
        for (const ChartSeries& series : panel.series) {
            const bool known = std::any_of(kinds.begin(), kinds.end(),
                                           [&](const ChartSeries* kind) { return kind->label == series.label; });
            if (!known) kinds.push_back(&series);
        }
    }
    return kinds;
}

// Swatches in rows, from the left. Returns the y under them.
double draw_key(const ChartContent& content, const PageStyle& style, double width, double y, Sheet& sheet) {
    const std::vector<const ChartSeries*> kinds = kinds_of(content);
    std::vector<std::string> names;
    for (const ChartSeries* kind : kinds) names.push_back(kind->label);
    const ChartKey key(sheet, style.label, names, width - 2 * style.margin);
    key.draw(sheet, {style.margin, y}, [&](std::size_t i, Point from, Point to) {
        const ChartSeries& kind = *kinds[i];
        sheet.canvas().line(std::array{from, to}, chart_line(style, kind.colour, k_width, kind.stroke));
        draw_marker(sheet, kind.marker, {(from.x + to.x) / 2, from.y}, 1.2 + style.line(3.2), kind.colour);
    });
    return y + key.height();
}

}  // namespace

Decades decades_of(const std::vector<double>& values) {
    Decades decades{0, 1};
    bool any = false;
    for (const double value : values) {
        if (!(value > 0) || !std::isfinite(value)) continue;
        const int low = static_cast<int>(std::floor(std::log10(value)));
        const int high = static_cast<int>(std::ceil(std::log10(value)));
        decades = any ? Decades{std::min(decades.low, low), std::max(decades.high, high)} : Decades{low, high};
        any = true;
    }
    if (decades.high == decades.low) ++decades.high;
    return decades;
}

Image draw_chart(const ChartContent& content, int width, int height, ChartLayout* layout) {
    const PageStyle style(width, height);
    Sheet sheet(width, height);
    ChartLayout drawn;
    double y = style.margin;
    y = sheet.lines(sheet.wrapped(content.title, style.title, width - 2 * style.margin), {style.margin, y}, style.title,
                    Across::left);
    y = sheet.lines(sheet.wrapped(content.subtitle, style.subtitle, width - 2 * style.margin), {style.margin, y},
                    style.subtitle, Across::left);
    y = draw_key(content, style, width, y + style.label.size_px, sheet);

    const int across = std::max(1, content.panels_across);
    const int down = std::max(1, (static_cast<int>(content.panels.size()) + across - 1) / across);
    // Beside a panel: its tick labels; above: its title; round all: the names of the axes.
    const double side = 4.2 * style.small.size_px, above = 1.9 * style.heading.size_px,
                 below = 1.9 * style.small.size_px;
    const double left = style.margin + 1.4 * style.label.size_px,
                 bottom = height - style.margin - 1.4 * style.label.size_px;
    const double cell_width = (width - style.margin - left) / across, cell_height = (bottom - y) / down;
    for (std::size_t i = 0; i < content.panels.size(); ++i) {
        const int column = static_cast<int>(i) % across, row = static_cast<int>(i) / across;
        const double x0 = left + cell_width * column, y0 = y + cell_height * row;
        const PageBox box{x0 + side, y0 + above, x0 + cell_width - style.gap, y0 + cell_height - below};
        draw_panel(content.panels[i], box, style, sheet, drawn);
    }
    sheet.text(content.x_label, {(left + width) / 2, height - style.margin}, style.label, Across::centre,
               Upright::baseline);
    upright_name(sheet, style.label, {style.margin + 0.5 * style.label.size_px, (y + bottom) / 2}, content.y_label);
    Image page(width, height);
    sheet.draw().put(page);
    drawn.texts = sheet.texts();
    if (layout != nullptr) *layout = std::move(drawn);
    return page;
}

}  // namespace frana::render
