// SPDX-License-Identifier: Apache-2.0
#include "render/chart/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "render/canvas/furniture.h"
#include "render/canvas/page.h"

namespace frana::render {
namespace {

/// Names of series with a swatch before each, in as many rows as needed: shortened until they fit.
class ChartKey {
  public:
    ChartKey(const Sheet& sheet, const TextStyle& letters, std::vector<const ChartSeries*> series, double width,
             double most_height);

    [[nodiscard]] double height() const noexcept { return height_; }
    /// `corner`: the key's upper left one.
    void draw(Sheet& sheet, const PageStyle& style, Point corner) const;

  private:
    void lay_out(const Sheet& sheet, double width, std::size_t most_letters);

    TextStyle letters_;
    std::vector<const ChartSeries*> series_;
    std::vector<std::string> labels_;
    std::vector<Point> places_;
    double height_ = 0;
};

constexpr Rgb k_grid{226, 229, 232}, k_fine_grid{240, 241, 243};
// In units of the letters' size.
constexpr double k_swatch = 2.2, k_gap = 0.5, k_apart = 1.2, k_row = 1.5, k_off_frame = 0.55;

LineStyle line_of(const PageStyle& style, const ChartSeries& series) {
    LineStyle line{style.line(series.width_px), series.colour};
    const double wide = line.width_px;
    switch (series.stroke) {
        case Stroke::solid:
            break;
        case Stroke::dashed:
            line.dashes = {4.5 * wide, 2.5 * wide};
            break;
        case Stroke::dotted:
            line.dashes = {wide, 1.8 * wide};
            break;
        case Stroke::dash_dot:
            line.dashes = {6 * wide, 2 * wide, wide, 2 * wide};
            break;
    }
    return line;
}

std::vector<Point> corners_of(Marker marker, Point at, double size) {
    const auto ring = [&](int sides, double radius, double turn) {
        std::vector<Point> corners;
        for (int k = 0; k < sides; ++k) {
            const double angle = turn + 2 * std::numbers::pi * k / sides;
            corners.push_back({at.x + radius * std::sin(angle), at.y - radius * std::cos(angle)});
        }
        return corners;
    };
    switch (marker) {
        case Marker::circle:
            return ring(20, size, 0);
        case Marker::square:
            return ring(4, 1.3 * size, std::numbers::pi / 4);
        case Marker::triangle:
            return ring(3, 1.4 * size, 0);
        case Marker::diamond:
            return ring(4, 1.35 * size, 0);
    }
    return {};
}

/// Draws grid lines at the ticks inside a panel's frame, and the numbers along it: below and to the left.
void draw_ticks(Sheet& sheet, const PageStyle& style, const PageBox& box, const std::vector<Tick>& x,
                const std::vector<Tick>& y) {
    for (const bool fine : {true, false}) {
        const LineStyle hair{style.line(1), fine ? k_fine_grid : k_grid};
        for (const Tick& tick : x)
            if (tick.words.empty() == fine)
                sheet.line(std::array{Point{tick.at, box.top}, Point{tick.at, box.bottom}}, hair);
        for (const Tick& tick : y)
            if (tick.words.empty() == fine)
                sheet.line(std::array{Point{box.left, tick.at}, Point{box.right, tick.at}}, hair);
    }
    const double off = k_off_frame * style.small.size_px;
    for (const Tick& tick : x)
        if (!tick.words.empty())
            sheet.text(tick.words, {tick.at, box.bottom + off}, style.small, Across::centre, Upright::top);
    for (const Tick& tick : y)
        if (!tick.words.empty())
            sheet.text(tick.words, {box.left - off, tick.at}, style.small, Across::right, Upright::middle);
}

/// Draws the name of a vertical axis, reading upwards.
void draw_vertical_name(Sheet& sheet, TextStyle style, Point middle, const std::string& words) {
    style.angle_deg = 90;
    sheet.text(words, middle, style, Across::centre, Upright::middle);
}

/// Draws a line through positions on the page, with the series' markers.
void draw_line(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places) {
    if (places.size() > 1) sheet.line(places, line_of(style, series));
}

void draw_markers(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const std::vector<Point>& places) {
    if (!series.marker) return;
    for (const Point place : places)
        sheet.fill(corners_of(*series.marker, place, 1.2 + style.line(3.2)), series.colour);
}

ChartKey::ChartKey(const Sheet& sheet, const TextStyle& letters, std::vector<const ChartSeries*> series, double width,
                   double most_height)
    : letters_(letters), series_(std::move(series)) {
    std::erase_if(series_, [](const ChartSeries* one) { return one->label.empty(); });
    for (const std::size_t most_letters : {200, 24, 18, 14, 10, 7, 5, 3}) {
        lay_out(sheet, width, most_letters);
        if (height_ <= most_height) break;
    }
}

void ChartKey::lay_out(const Sheet& sheet, double width, std::size_t most_letters) {
    const double letter = letters_.size_px;
    double x = 0, y = 0;
    labels_.clear();
    places_.clear();
    for (const ChartSeries* one : series_) {
        labels_.push_back(elided(one->label, most_letters));
        const double length = (k_swatch + k_gap) * letter + sheet.lettering().width(labels_.back(), letters_);
        if (x > 0 && x + length > width) {
            x = 0;
            y += k_row * letter;
        }
        places_.push_back({x, y});
        x += length + k_apart * letter;
    }
    if (!series_.empty()) height_ = y + k_row * letter;
}

void ChartKey::draw(Sheet& sheet, const PageStyle& style, Point corner) const {
    const double letter = letters_.size_px;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const double x = corner.x + places_[i].x, y = corner.y + places_[i].y + letter / 2;
        draw_line(sheet, style, *series_[i], {{x, y}, {x + k_swatch * letter, y}});
        draw_markers(sheet, style, *series_[i], {{x + k_swatch * letter / 2, y}});
        sheet.text(labels_[i], {x + (k_swatch + k_gap) * letter, y}, letters_, Across::left, Upright::middle);
    }
}

/// In groups of digits from 10 000 on.
std::string axis_number(double value) {
    constexpr double k_grouped = 1e4;
    return std::abs(value) >= k_grouped && value == std::round(value) ? grouped(value) : number(value);
}

/// On a logarithmic axis beyond 100 000 and below 0.001 as "2e6", which is short.
std::string log_number(double value) {
    const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    if (exponent >= -3 && exponent <= 5) return axis_number(value);
    return number(value / std::pow(10.0, exponent)) + "e" + (exponent < 0 ? "\u2212" : "") +
           std::to_string(std::abs(exponent));
}

/// Round values of a decade, in the order in which they get labels as long as these are few.
const std::vector<std::vector<double>> k_round{{1}, {2, 5}, {3, 7}, {1.5, 4}, {6, 8, 9}};

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

ChartAxis::ChartAxis(Scale scale, const std::vector<double>& values, double from, double to, double room, bool rounded)
    : scale_(scale), from_(from), to_(to), room_(room) {
    if (scale_ == Scale::decades) {
        const Decades decades = decades_of(values);
        least_ = decades.low;
        most_ = decades.high;
        return;
    }
    if (!values.empty()) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        least_ = place(*least);
        most_ = place(*most);
    }
    // Values that differ by rounding alone have no ticks between them.
    constexpr double k_alike = 1e-9;
    if (most_ - least_ <= k_alike * std::max(std::abs(least_), std::abs(most_))) most_ = least_ + 1;
    if (scale_ == Scale::logarithmic) return;
    step_ = nice_step_above((most_ - least_) * room / std::abs(to_ - from_));
    if (!rounded) return;
    least_ = std::floor(least_ / step_ + 1e-9) * step_;
    const double highest = most_;
    most_ = std::ceil(most_ / step_ - 1e-9) * step_;
    // A curve along the frame would be mistaken for it.
    if (most_ - highest < 0.02 * (most_ - least_)) most_ += 0.05 * (most_ - least_);
}

bool ChartAxis::has(Scale scale, double value) {
    return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

double ChartAxis::place(double value) const {
    return scale_ == Scale::linear ? value : std::log10(value);
}

double ChartAxis::at(double value) const {
    return from_ + (to_ - from_) * (place(value) - least_) / (most_ - least_);
}

std::vector<Tick> ChartAxis::ticks() const {
    std::vector<Tick> ticks;
    if (scale_ == Scale::linear) {
        for (const double value : multiples(least_, most_, step_)) ticks.push_back({at(value), axis_number(value)});
        return ticks;
    }
    constexpr double k_rounding = 1e-9, k_fine_decades = 5;
    constexpr std::size_t k_enough = 4;
    std::set<double> labelled;
    const auto add = [&](double value) {
        const bool inside = place(value) >= least_ - k_rounding && place(value) <= most_ + k_rounding;
        const bool has_room = std::none_of(labelled.begin(), labelled.end(),
                                           [&](double other) { return std::abs(at(value) - at(other)) < room_; });
        if (inside && has_room) labelled.insert(value);
    };
    const auto each = [&](const std::vector<double>& factors, const auto& use) {
        for (double e = std::floor(least_); e <= most_ + k_rounding; ++e)
            for (const double factor : factors) use(factor * std::pow(10.0, e));
    };
    for (const std::vector<double>& factors : k_round)
        if (labelled.size() < k_enough) each(factors, add);
    if (labelled.size() < 3) {  // less than from 6 to 8
        const double low = std::pow(10.0, least_), high = std::pow(10.0, most_);
        for (const double value : multiples(low, high, nice_step_above((high - low) * room_ / std::abs(to_ - from_))))
            add(value);
    }
    if (most_ - least_ < k_fine_decades)
        each({1, 2, 3, 4, 5, 6, 7, 8, 9}, [&](double value) {
            if (place(value) > least_ && place(value) < most_ && !labelled.contains(value))
                ticks.push_back({at(value), ""});
        });
    for (const double value : labelled) ticks.push_back({at(value), log_number(value)});
    return ticks;
}

namespace {

/// A panel's axes around its values.
class PanelAxes {
  public:
    PanelAxes(const ChartPanel& panel, const PageBox& box, const PageStyle& style)
        : panel_(panel),
          x_(panel.x, values(true), box.left, box.right, 5.0 * style.small.size_px, false),
          y_(panel.y, values(false), box.bottom, box.top, 2.4 * style.small.size_px, true) {}

    [[nodiscard]] bool has(Point p) const { return ChartAxis::has(panel_.x, p.x) && ChartAxis::has(panel_.y, p.y); }
    [[nodiscard]] Point page(Point p) const { return {x_.at(p.x), y_.at(p.y)}; }
    [[nodiscard]] bool any() const {
        return std::any_of(panel_.series.begin(), panel_.series.end(), [&](const ChartSeries& series) {
            return std::any_of(series.points.begin(), series.points.end(), [&](Point p) { return has(p); });
        });
    }
    [[nodiscard]] const ChartAxis& x() const { return x_; }
    [[nodiscard]] const ChartAxis& y() const { return y_; }

  private:
    [[nodiscard]] std::vector<double> values(bool along_x) const {
        std::vector<double> all = along_x ? panel_.on_x : panel_.on_y;
        for (const ChartSeries& series : panel_.series) {
            for (std::size_t i = 0; i < series.points.size(); ++i) {
                if (!has(series.points[i])) continue;
                all.push_back(along_x ? series.points[i].x : series.points[i].y);
                if (!along_x && !series.foot.empty()) all.push_back(series.foot[i]);
            }
        }
        return all;
    }

    const ChartPanel& panel_;
    ChartAxis x_, y_;
};

/// A run has one row per step: of the points within a third of a pixel, the first, the last, the least and the greatest
/// are drawn.
std::vector<Point> thinned(const std::vector<Point>& places) {
    constexpr double k_same = 0.3;
    const auto higher = [](Point a, Point b) { return a.y < b.y; };
    std::vector<Point> kept;
    for (auto begin = places.begin(), end = begin; begin != places.end(); begin = end) {
        end = std::find_if(begin, places.end(), [&](Point p) { return std::abs(p.x - begin->x) > k_same; });
        const auto [least, greatest] = std::minmax_element(begin, end, higher);
        for (const auto place : std::set{begin, least, greatest, end - 1})
            if (kept.empty() || std::hypot(place->x - kept.back().x, place->y - kept.back().y) > k_same)
                kept.push_back(*place);
    }
    return kept;
}

/// Each part of the line between its breaks is one area: parts of it side by side would show their joints.
void fill_under(Sheet& sheet, const ChartSeries& series, const PanelAxes& axes) {
    constexpr double k_opacity = 0.3;
    std::vector<Point> area, foot;
    for (std::size_t i = 0; i <= series.foot.size(); ++i) {
        if (i < series.foot.size() && axes.has(series.points[i])) {
            area.push_back(axes.page(series.points[i]));
            foot.push_back(axes.page({series.points[i].x, series.foot[i]}));
            continue;
        }
        area.insert(area.end(), foot.rbegin(), foot.rend());
        if (area.size() > 2) sheet.fill(area, series.colour, k_opacity);
        area.clear();
        foot.clear();
    }
}

/// Returns the points that are at least a distance from the one kept before, from half of it behind the first.
std::vector<Point> apart(const std::vector<Point>& places, double gap) {
    if (!(gap > 0) || places.empty()) return places;
    std::vector<Point> kept;
    Point last = places.front();
    double least = gap / 2;
    for (const Point p : places) {
        if (std::hypot(p.x - last.x, p.y - last.y) < least) continue;
        kept.push_back(p);
        last = p;
        least = gap;
    }
    return kept.empty() ? std::vector<Point>{places[places.size() / 2]} : kept;
}

/// Draws a series; returns the places of its points.
std::vector<Point> draw_series(Sheet& sheet, const PageStyle& style, const ChartSeries& series, const PanelAxes& axes) {
    std::vector<Point> run, all;
    const auto flush = [&] {
        draw_line(sheet, style, series, thinned(run));
        run.clear();
    };
    for (const Point p : series.points) {
        if (axes.has(p)) {
            run.push_back(axes.page(p));
            all.push_back(run.back());
        } else {
            flush();
        }
    }
    flush();
    draw_markers(sheet, style, series, apart(all, style.length(series.marker_gap_px)));
    return all;
}

std::vector<Tick> in_language(std::vector<Tick> ticks, const Words& words) {
    for (Tick& tick : ticks) tick.words = words.number(tick.words);
    return ticks;
}

void draw_inside(Sheet& sheet, const PageStyle& style, const ChartPanel& panel, const PageBox& box, const Words& words,
                 ChartLayout& layout) {
    if (box.width() < 60 || box.height() < 40) {
        throw Error(ErrorKind::input,
                    Problem{"the page is too small for its charts", "", "", "", "draw a larger picture"});
    }
    const PanelAxes axes(panel, box, style);
    if (axes.any())
        draw_ticks(sheet, style, box, in_language(axes.x().ticks(), words),
                   panel.has_rows ? std::vector<Tick>{} : in_language(axes.y().ticks(), words));
    for (const ChartSeries& series : panel.series) fill_under(sheet, series, axes);
    for (const ChartSeries& series : panel.series) layout.points.push_back(draw_series(sheet, style, series, axes));
    if (panel.mark_x && axes.any()) {
        const double x = axes.x().at(*panel.mark_x);
        LineStyle line{style.line(1.4), k_soft_ink};
        line.dashes = {style.length(8), style.length(6)};
        if (x >= box.left && x <= box.right) sheet.line(std::array{Point{x, box.top}, Point{x, box.bottom}}, line);
    }
    sheet.frame(box, {style.line(1.5), k_soft_ink});
    if (!axes.any())
        sheet.text(panel.note.empty() ? words("no values") : panel.note,
                   {(box.left + box.right) / 2, (box.top + box.bottom) / 2}, style.small, Across::centre,
                   Upright::middle);
    layout.panels.push_back(box);
}

std::vector<const ChartSeries*> series_of(const ChartPanel& panel) {
    std::vector<const ChartSeries*> all;
    for (const ChartSeries& series : panel.series) all.push_back(&series);
    return all;
}

/// Every label once.
std::vector<const ChartSeries*> kinds_of(const Chart& chart) {
    std::vector<const ChartSeries*> kinds;
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries* series : series_of(panel))
            if (std::none_of(kinds.begin(), kinds.end(), [&](auto* kind) { return kind->label == series->label; }))
                kinds.push_back(series);
    return kinds;
}

/// Names in some languages are long.
TextStyle fitted(const Sheet& sheet, const std::string& words, const TextStyle& style, double width) {
    constexpr double k_least_fraction = 0.6;
    return shrunk_to_fit(sheet.lettering(), words, style, width, k_least_fraction);
}

/// With its own key and axis names, if panels differ.
void draw_panel(Sheet& sheet, const PageStyle& style, const Chart& chart, const ChartPanel& panel, const PageBox& cell,
                ChartLayout& layout) {
    const double letter = style.small.size_px, above = panel.title.empty() ? 0 : 1.6 * style.heading.size_px;
    const double left = cell.left + (chart.alike ? 4.2 * letter : 5.6 * letter + 1.6 * style.label.size_px);
    const double below = (chart.alike ? 2.6 : 4.2) * letter, right = cell.right - style.gap;
    if (!panel.title.empty())
        sheet.text(panel.title, {left, cell.top + capital_height(style.heading)},
                   fitted(sheet, panel.title, style.heading, right - left), Across::left, Upright::baseline);
    const ChartKey key(sheet, style.small, chart.alike ? std::vector<const ChartSeries*>{} : series_of(panel),
                       right - left, (cell.height() - above - below) / 2);
    const PageBox box{left, cell.top + above + key.height(), right, cell.bottom - below};
    draw_inside(sheet, style, panel, box, chart.words, layout);
    key.draw(sheet, style, {left, cell.top + above});
    if (chart.alike) return;
    sheet.text(panel.x_label, {(left + right) / 2, box.bottom + 2.2 * letter},
               fitted(sheet, panel.x_label, style.small, right - left), Across::centre, Upright::top);
    // In the middle of the axis, but a long name not beyond the cell.
    const TextStyle upright = fitted(sheet, panel.y_label, style.small, cell.bottom - cell.top);
    const double half = sheet.lettering().width(panel.y_label, upright) / 2;
    const double middle = std::max(std::min((box.top + box.bottom) / 2, cell.bottom - half), cell.top + half);
    draw_vertical_name(sheet, upright, {cell.left + 0.6 * letter, middle}, panel.y_label);
}

/// Draws the names that equal panels share; returns the remaining area.
PageBox draw_common_names(Sheet& sheet, const PageStyle& style, const Chart& chart, PageBox room) {
    const double letter = style.label.size_px;
    const ChartKey key(sheet, style.label, kinds_of(chart), room.width(), room.height() / 3);
    key.draw(sheet, style, {room.left, room.top});
    const PageBox left{room.left + 1.4 * letter, room.top + key.height() + 0.6 * letter, room.right,
                       room.bottom - 1.4 * letter};
    sheet.text(chart.panels.front().x_label, {(left.left + left.right) / 2, room.bottom}, style.label, Across::centre,
               Upright::baseline);
    draw_vertical_name(sheet, style.label, {room.left + 0.5 * letter, (left.top + left.bottom) / 2},
                       chart.panels.front().y_label);
    return left;
}

ChartLayout draw_on(Sheet& sheet, const Chart& chart, const std::string& subtitle, int width, int height) {
    const PageStyle style(width, height);
    const double inner = width - 2 * style.margin;
    const TitleResult titles =
        draw_titles(sheet, style, chart.title, subtitle, false, {style.margin, style.margin}, inner);
    PageBox room{style.margin, std::max(titles.bottom, style.margin) + style.gap, style.margin + inner,
                 draw_foot(sheet, style, {chart.foot}, style.margin, height - style.margin, inner) - style.gap};
    if (chart.alike && !chart.panels.empty()) room = draw_common_names(sheet, style, chart, room);
    ChartLayout layout;
    const auto across = static_cast<std::size_t>(std::max(1, chart.across));
    double fractions = 0;
    for (std::size_t i = 0; i < chart.panels.size(); i += across) fractions += chart.panels[i].fraction;
    double y = room.top;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const double cell_width = room.width() / static_cast<double>(across);
        const double x = room.left + cell_width * static_cast<double>(i % across);
        const double cell_height = room.height() * chart.panels[i - i % across].fraction / fractions;
        draw_panel(sheet, style, chart, chart.panels[i], {x, y, x + cell_width, y + cell_height}, layout);
        if (i % across + 1 == across) y += cell_height;
    }
    return layout;
}

}  // namespace

void look_apart(ChartSeries& series, std::size_t number) {
    constexpr double k_marker_gap_px = 180;
    constexpr std::size_t k_plain = std::size(k_strokes);
    series.colour = k_chart_colours[number % std::size(k_chart_colours)];
    series.stroke = k_strokes[number % k_plain];
    series.marker.reset();
    if (number >= k_plain) {
        series.marker = k_markers[(number / k_plain - 1) % std::size(k_markers)];
        series.marker_gap_px = k_marker_gap_px;
    }
}

Page chart_page(const Chart& chart, int width, int height, ChartLayout* layout) {
    const auto drawn_with = [&](const std::string& subtitle) {
        Sheet sheet(width, height);
        ChartLayout drawn = draw_on(sheet, chart, subtitle, width, height);
        drawn.texts = sheet.texts();
        if (layout != nullptr) *layout = std::move(drawn);
        Page page(width, height);
        page.put(sheet.take());
        return page;
    };
    if (chart.long_subtitle.empty()) return drawn_with(chart.subtitle);
    try {
        return drawn_with(chart.long_subtitle);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;  // a page too small for both may be large enough for the charts
        return drawn_with(chart.subtitle);
    }
}

Image draw_chart(const Chart& chart, int width, int height, ChartLayout* layout) {
    return chart_page(chart, width, height, layout).paint();
}

std::string chart_svg(Chart chart, int width, int height, ChartLayout* layout) {
    chart.long_subtitle.clear();
    return page_svg(chart_page(chart, width, height, layout), 0, "");
}

}  // namespace frana::render
