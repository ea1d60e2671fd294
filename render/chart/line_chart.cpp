// SPDX-License-Identifier: Apache-2.0
#include "render/chart/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/canvas/ticks.h"
#include "render/chart/chart_parts.h"

namespace frana::render {
namespace {

constexpr Rgb k_grid{226, 229, 232};

struct Span {
    double least = 0, most = 1;
    bool any = false;

    void include(double value) {
        if (!std::isfinite(value)) return;
        least = any ? std::min(least, value) : value;
        most = any ? std::max(most, value) : value;
        any = true;
    }
};

/// Axes from data to pixels, with round numbers along them.
class LinearAxes {
  public:
    LinearAxes(const CurvePanel& panel, const PageBox& box, const PageStyle& style) : box_(box), log_x_(panel.log_x) {
        for (const Curve& curve : panel.curves) {
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                const Point p = curve.points[i];
                if (std::isnan(p.y) || (log_x_ && p.x <= 0)) continue;
                x_.include(along(p.x));
                y_.include(p.y);
                if (!curve.foot.empty()) y_.include(curve.foot[i]);
            }
        }
        any_ = x_.any;
        if (panel.from_zero) y_.include(0);
        if (x_.most == x_.least) x_.most = x_.least + 1;
        if (y_.most == y_.least) y_.most = y_.least + 1;
        const double room = 5.0 * style.small.size_px;
        x_step_ = nice_step_above((x_.most - x_.least) * room / box.width());
        y_step_ = nice_step_above((y_.most - y_.least) * 2.4 * style.small.size_px / box.height());
        y_.least = std::floor(y_.least / y_step_ + 1e-9) * y_step_;
        const double highest = y_.most;
        y_.most = std::ceil(y_.most / y_step_ - 1e-9) * y_step_;
        // A curve along the frame would be taken for it.
        if (y_.most - highest < 0.02 * (y_.most - y_.least)) y_.most += 0.05 * (y_.most - y_.least);
    }

    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] double along(double x) const { return log_x_ ? std::log10(x) : x; }
    [[nodiscard]] Point page(Point p) const {
        return {box_.left + box_.width() * (along(p.x) - x_.least) / (x_.most - x_.least),
                box_.bottom - box_.height() * (p.y - y_.least) / (y_.most - y_.least)};
    }
    [[nodiscard]] bool has(Point p) const { return std::isfinite(p.y) && (!log_x_ || p.x > 0); }

    void draw(const PageStyle& style, Sheet& sheet) const {
        const LineStyle hair{style.line(1), k_grid};
        for (const auto& [place, words] : x_ticks()) {
            const double x = box_.left + box_.width() * (place - x_.least) / (x_.most - x_.least);
            grid_upright(sheet, box_, x, hair);
            number_below(sheet, style, box_, x, words);
        }
        for (const double value : multiples(y_.least, y_.most, y_step_)) {
            const double y = page({0, value}).y;
            grid_level(sheet, box_, y, hair);
            number_beside(sheet, style, box_, y, number(value));
        }
    }

  private:
    [[nodiscard]] std::vector<std::pair<double, std::string>> x_ticks() const {
        std::vector<std::pair<double, std::string>> ticks;
        if (!log_x_) {
            for (const double value : multiples(x_.least, x_.most, x_step_)) ticks.emplace_back(value, number(value));
            return ticks;
        }
        for (double e = std::floor(x_.least); e <= x_.most; ++e) {
            for (const double factor : {1.0, 2.0, 5.0}) {
                const double value = factor * std::pow(10.0, e), place = std::log10(value);
                if (place >= x_.least && place <= x_.most) ticks.emplace_back(place, number(value));
            }
        }
        return ticks;
    }

    PageBox box_;
    bool log_x_, any_ = false;
    Span x_, y_;
    double x_step_ = 1, y_step_ = 1;
};

LineStyle stroke_of(const Curve& curve, const PageStyle& style) {
    return chart_line(style, curve.colour, curve.width_px, curve.stroke);
}

void fill_under(const Curve& curve, const LinearAxes& axes, Sheet& sheet) {
    constexpr double k_opacity = 0.3;
    for (std::size_t i = 0; i + 1 < curve.foot.size(); ++i) {
        const Point a = curve.points[i], b = curve.points[i + 1];
        if (!axes.has(a) || !axes.has(b)) continue;
        sheet.canvas().fill(std::array<Point, 4>{{axes.page(a), axes.page(b), axes.page({b.x, curve.foot[i + 1]}),
                                                  axes.page({a.x, curve.foot[i]})}},
                            curve.colour, k_opacity);
    }
}

void draw_curve(const Curve& curve, const LinearAxes& axes, const PageStyle& style, Sheet& sheet, ChartLayout& layout) {
    std::vector<Point> run, all;
    const auto flush = [&] {
        if (run.size() > 1) sheet.canvas().line(run, stroke_of(curve, style));
        run.clear();
    };
    for (const Point p : curve.points) {
        if (!axes.has(p)) {
            flush();
            continue;
        }
        const Point at = axes.page(p);
        all.push_back(at);
        // A run has one row a step; what falls within a third of a pixel is the same place.
        if (run.empty() || std::hypot(at.x - run.back().x, at.y - run.back().y) > 0.3) run.push_back(at);
    }
    flush();
    layout.points.push_back(std::move(all));
}

void draw_panel(const CurvePanel& panel, const PageBox& cell, const PageStyle& style, Sheet& sheet,
                ChartLayout& layout) {
    const double side = 5.6 * style.small.size_px + 1.6 * style.label.size_px, below = 4.2 * style.small.size_px;
    const double left = cell.left + side, right = cell.right - style.gap;
    sheet.text(panel.title, {left, cell.top + Lettering::capital_height(style.heading)}, style.heading, Across::left,
               Upright::baseline);
    std::vector<std::string> names;
    for (const Curve& curve : panel.curves) names.push_back(curve.label);
    const ChartKey key(sheet, style.small, names, right - left);
    const double key_top = cell.top + 1.6 * style.heading.size_px;
    const PageBox box{left, key_top + key.height(), right, cell.bottom - below};
    if (box.width() < 60 || box.height() < 40) {
        throw Error(ErrorKind::input,
                    Problem{"the page is too small for its charts", "", "", "", "draw a larger picture"});
    }
    const LinearAxes axes(panel, box, style);
    if (axes.any()) axes.draw(style, sheet);
    for (const Curve& curve : panel.curves) fill_under(curve, axes, sheet);
    for (const Curve& curve : panel.curves) draw_curve(curve, axes, style, sheet, layout);
    if (panel.mark_x && axes.any()) {
        const double x = axes.page({*panel.mark_x, 0}).x;
        if (x >= box.left && x <= box.right) {
            LineStyle line{style.line(1.4), k_soft_ink};
            line.dashes = {style.length(8), style.length(6)};
            grid_upright(sheet, box, x, line);
        }
    }
    key.draw(sheet, {left, key_top}, [&](std::size_t i, Point from, Point to) {
        sheet.canvas().line(std::array{from, to}, stroke_of(panel.curves[i], style));
    });
    sheet.canvas().frame(box, {style.line(1.5), k_soft_ink});
    if (!axes.any()) {
        sheet.text("no values", {(box.left + box.right) / 2, (box.top + box.bottom) / 2}, style.small, Across::centre,
                   Upright::middle);
    }
    sheet.text(panel.x_label, {(box.left + box.right) / 2, box.bottom + 2.2 * style.small.size_px}, style.small,
               Across::centre, Upright::top);
    upright_name(sheet, style.small, {cell.left + 0.6 * style.small.size_px, (box.top + box.bottom) / 2},
                 panel.y_label);
    layout.panels.push_back(box);
}

}  // namespace

Image draw_curves(const CurveChart& chart, int width, int height, ChartLayout* layout) {
    const PageStyle style(width, height);
    Sheet sheet(width, height);
    ChartLayout drawn;
    const double inner = width - 2 * style.margin;
    const TitleResult titles =
        draw_titles(sheet, style, chart.title, chart.subtitle, false, {style.margin, style.margin}, inner);
    const double top = std::max(titles.bottom, style.margin) + style.gap;
    const double bottom = draw_foot(sheet, style, {chart.foot}, style.margin, height - style.margin, inner) - style.gap;
    const auto across = static_cast<std::size_t>(std::max(1, chart.across));
    double shares = 0;
    for (std::size_t i = 0; i < chart.panels.size(); i += across) shares += chart.panels[i].share;
    double y = top;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const double cell_width = inner / static_cast<double>(across);
        const double x = style.margin + cell_width * static_cast<double>(i % across);
        const double cell_height = (bottom - top) * chart.panels[i - i % across].share / shares;
        draw_panel(chart.panels[i], {x, y, x + cell_width, y + cell_height}, style, sheet, drawn);
        if (i % across + 1 == across) y += cell_height;
    }
    Image page(width, height);
    sheet.draw().put(page);
    drawn.texts = sheet.texts();
    if (layout != nullptr) *layout = std::move(drawn);
    return page;
}

}  // namespace frana::render
