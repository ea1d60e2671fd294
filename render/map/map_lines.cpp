// SPDX-License-Identifier: Apache-2.0
#include "render/map/map_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "render/canvas/furniture.h"
#include "render/canvas/image.h"
#include "render/map/legend.h"
#include "render/map/relief.h"

namespace frana::render {
namespace {

constexpr Rgb k_contour{72, 62, 50};
constexpr int k_index_every = 5;

double distance(Point a, Point b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

bool layer_lies_under(const PageBox& box, const MapFrame& frame, const Raster& layer) {
    constexpr int k_probes = 8;
    for (int i = 0; i <= k_probes; ++i) {
        for (int j = 0; j <= k_probes; ++j) {
            const double x = box.left + box.width() * i / k_probes, y = box.top + box.height() * j / k_probes;
            const Point map = frame.ground(static_cast<int>(x) - frame.left, static_cast<int>(y) - frame.top);
            if (!std::isnan(cell_value(layer, map))) return true;
        }
    }
    return false;
}

/// Possible places of a contour's label of a given length: the straightest part free of everything else.
class LabelPlaces {
  public:
    LabelPlaces(const PageStyle& style, const MapFrame& frame, const Raster* layer,
                const std::vector<Outline>& outlines, const Sheet& sheet)
        : style_(style), frame_(frame), layer_(layer) {
        for (const TextBox& text : sheet.texts()) occupied_.push_back(text.box);
        for (const Outline& outline : outlines) {
            for (const Polygon& polygon : outline.polygons) {
                keep_off(polygon.outer, true);
                for (const Ring& hole : polygon.holes) keep_off(hole, true);
            }
            for (const Polyline& line : outline.lines) keep_off(line, false);
            for (const NamedPlace& one : outline.places) keep_off({one.place, one.place}, false);
        }
    }

    void put(const Polyline& line, const std::string& words, const TextStyle& label, Sheet& sheet) {
        const double length = sheet.lettering().width(words, label), wanted = length + 1.2 * label.size_px;
        double best_straight = 0.97;  // chord over arc; with less the label does not seem to follow the line
        std::optional<PageBox> best;
        TextStyle best_style = label;
        Point best_at;
        std::size_t end = 0;
        double along = 0;  // from begin to end
        for (std::size_t begin = 0; begin + 1 < line.size(); ++begin) {
            while (end + 1 < line.size() && along < wanted) {
                along += distance(line[end], line[end + 1]);
                ++end;
            }
            if (along < wanted) break;
            const Point a = line[begin], b = line[end];
            const double straight = distance(a, b) / along;
            if (straight > best_straight) {
                TextStyle turned = label;
                turned.angle_deg = -std::atan2(b.y - a.y, b.x - a.x) * 180 / std::numbers::pi;
                if (turned.angle_deg > 90) turned.angle_deg -= 180;
                if (turned.angle_deg <= -90) turned.angle_deg += 180;
                const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
                const PageBox box = box_of(middle, length, label.size_px, turned.angle_deg);
                if (is_free(box)) {
                    best_straight = straight;
                    best = box;
                    best_style = turned;
                    best_at = middle;
                }
            }
            along -= distance(line[begin], line[begin + 1]);
        }
        if (!best) return;
        sheet.text(words, best_at, best_style, Across::centre, Upright::middle);
        occupied_.push_back(sheet.texts().back().box);
    }

  private:
    /// Rounded bounds of this length, rotated; one pixel of margin, since the texts are not set yet.
    static PageBox box_of(Point middle, double length, double size, double angle_deg) {
        const double angle = angle_deg * std::numbers::pi / 180, capital = 0.75 * size;
        const double across = (length * std::fabs(std::cos(angle)) + capital * std::fabs(std::sin(angle))) / 2 + 1;
        const double upright = (length * std::fabs(std::sin(angle)) + capital * std::fabs(std::cos(angle))) / 2 + 1;
        return {middle.x - across, middle.y - upright, middle.x + across, middle.y + upright};
    }

    /// Places small boxes along an outline, as if labels were there.
    void keep_off(const Polyline& ring, bool closed) {
        const double step = style_.gap;
        for (std::size_t i = 0; i + (closed ? 0 : 1) < ring.size(); ++i) {
            const Point a = frame_.page(ring[i]), b = frame_.page(ring[(i + 1) % ring.size()]);
            const int parts = std::clamp(static_cast<int>(distance(a, b) / step), 1, 1000);
            for (int k = 0; k < parts; ++k) {
                const Point p{a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts};
                const PageBox dot{p.x - step / 2, p.y - step / 2, p.x + step / 2, p.y + step / 2};
                if (dot.overlaps(frame_.box())) outlines_.push_back(dot);
            }
        }
    }

    [[nodiscard]] bool is_free(const PageBox& box) const {
        const double rim = style_.gap;
        const PageBox wide{box.left - rim, box.top - rim, box.right + rim, box.bottom + rim};
        if (!wide.inside(frame_.box())) return false;
        // Labels of neighbouring lines one above the other are worse than few labels.
        const double apart = 5 * style_.gap;
        const PageBox lonely{box.left - apart, box.top - apart, box.right + apart, box.bottom + apart};
        if (std::any_of(occupied_.begin(), occupied_.end(), [&](const PageBox& t) { return lonely.overlaps(t); }))
            return false;
        if (std::any_of(outlines_.begin(), outlines_.end(), [&](const PageBox& dot) { return dot.overlaps(box); })) {
            return false;
        }
        return layer_ == nullptr || !layer_lies_under(box, frame_, *layer_);
    }

    const PageStyle& style_;
    const MapFrame& frame_;
    const Raster* layer_;
    std::vector<PageBox> occupied_;  ///< by labels
    std::vector<PageBox> outlines_;  ///< dots along them
};

}  // namespace

Contours find_contours(const MapFrame& frame, const Raster& terrain) {
    // Two pixels per cell: finer crossings cannot be distinguished on the page.
    const Raster part = raster_window(terrain, frame.ground_bounds(), std::max(frame.width, frame.height) / 2);
    if (part.grid.columns < 2 || part.grid.rows < 2) return {};
    const ValueRange heights = value_range(part);
    if (heights.empty() || heights.greatest - heights.least < 1e-6) return {};
    constexpr double k_wanted_lines = 32;
    const double interval = nice_step_above((heights.greatest - heights.least) / k_wanted_lines);
    return {interval, contour_lines(part, interval)};
}

void draw_contours(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const Contours& contours,
                   const Raster* layer, const std::vector<Outline>& outlines, const Words& words) {
    const LineStyle thin{style.line(0.9), k_contour, 0.34, {}};
    const LineStyle strong{style.line(1.7), k_contour, 0.5, {}};
    const auto is_index = [&](const Contour& c) {
        return std::lround(c.level / contours.interval) % k_index_every == 0;
    };
    std::vector<Contour> labelled;
    for (Contour contour : contours.lines) {
        for (Point& p : contour.points) p = frame.page(p);
        sheet.line(contour.points, is_index(contour) ? strong : thin);
        if (is_index(contour)) labelled.push_back(std::move(contour));
    }
    TextStyle label = style.small;
    label.colour = {60, 50, 38};
    label.halo_px = std::max(1.5, style.length(2.5));
    label.halo = {232, 231, 228};
    LabelPlaces places(style, frame, layer, outlines, sheet);
    for (const Contour& contour : labelled)
        places.put(contour.points, words.number(number(contour.level)), label, sheet);
}

void draw_outlines(Sheet& sheet, const PageStyle& style, const MapFrame& frame, const std::vector<Outline>& outlines) {
    const PageBox box = frame.box();
    const auto far_outside = [&](Point p) {  // limits coordinates; the caller covers anything outside the frame
        return p.x < box.left - 1e5 || p.x > box.right + 1e5 || p.y < box.top - 1e5 || p.y > box.bottom + 1e5;
    };
    const auto stroke = [&](const Polyline& map_line, const LineStyle& line, bool closed) {
        Polyline points;
        for (const Point map : map_line) points.push_back(frame.page(map));
        if (std::none_of(points.begin(), points.end(), far_outside)) sheet.line(points, line, closed);
    };
    for (const bool rim : {true, false}) {
        for (const Outline& outline : outlines) {
            const double width = style.line(outline.width_px);
            const LineStyle line = rim ? LineStyle{width + 2 * style.line(1.3), {255, 255, 255}}
                                       : LineStyle{width, outline.colour, 1, outline_dashes(outline, width)};
            for (const Polygon& polygon : outline.polygons) {
                stroke(polygon.outer, line, true);
                for (const Ring& hole : polygon.holes) stroke(hole, line, true);
            }
            for (const Polyline& open : outline.lines) stroke(open, line, false);
            for (const NamedPlace& one : outline.places) {
                const Point at = frame.page(one.place);
                if (!rim && !far_outside(at)) draw_place(sheet, style, at, outline.colour);
            }
        }
    }
}

void draw_place(Sheet& sheet, const PageStyle& style, Point at, Rgb colour) {
    const auto triangle = [&](double reach, Rgb ink) {
        sheet.fill(std::array<Point, 3>{{{at.x, at.y - reach},
                                         {at.x + 0.87 * reach, at.y + reach / 2},
                                         {at.x - 0.87 * reach, at.y + reach / 2}}},
                   ink);
    };
    const double reach = 0.55 * style.label.size_px;
    triangle(reach + 2 * style.line(1.3), {255, 255, 255});
    triangle(reach, colour);
}

void draw_coordinates(Sheet& sheet, const PageStyle& style, const MapFrame& frame, bool projected, const Words& words) {
    const Lettering& lettering = sheet.lettering();
    const PageBox box = frame.box();
    const Bounds ground = frame.ground_bounds(), &window = frame.window;
    const MapTurn& turn = frame.turn;
    const bool east_is_level = turn.east_is_level();
    const double widest = std::max(lettering.width(words.number(grouped(ground.east)) + " E", style.small),
                                   lettering.width(words.number(grouped(ground.north)) + " N", style.small));
    const double metre = frame.metres_per_pixel();
    // Coordinates are labelled in full metres, so the step is at least one.
    const double step = std::max(1.0, nice_step_above(1.7 * widest * metre));
    const std::vector<double> eastings = multiples(ground.west, ground.east, step);
    const std::vector<double> northings = multiples(ground.south, ground.north, step);
    const auto words_of = [&](double value, bool east) {
        return words.number(grouped(value)) + (projected ? east ? " E" : " N" : "");
    };
    const double tick = style.length(8), text_gap = tick + 0.45 * style.small.size_px;
    const LineStyle line{style.line(1.2), k_ink, 1, {}};

    for (const double value : east_is_level ? eastings : northings) {
        // Where the line of this coordinate crosses the lower side.
        const double at =
            east_is_level ? (value + window.south * turn.s) / turn.c : (value - window.south * turn.c) / turn.s;
        const double x = box.left + (at - window.west) / metre;
        if (x < box.left || x > box.right) continue;
        const std::array<Point, 2> mark{{{x, box.bottom}, {x, box.bottom + tick}}};
        sheet.line(mark, line);
        const std::string label = words_of(value, east_is_level);
        const double half = lettering.width(label, style.small) / 2;
        if (x - half < box.left || x + half > box.right) continue;
        sheet.text(label, {x, box.bottom + text_gap}, style.small, Across::centre, Upright::top);
    }
    TextStyle upright = style.small;
    upright.angle_deg = 90;
    for (const double value : east_is_level ? northings : eastings) {
        const double at =
            east_is_level ? (value - window.west * turn.s) / turn.c : (window.west * turn.c - value) / turn.s;
        const double y = box.top + (window.north - at) / metre;
        if (y < box.top || y > box.bottom) continue;
        const std::array<Point, 2> mark{{{box.left - tick, y}, {box.left, y}}};
        sheet.line(mark, line);
        const std::string label = words_of(value, !east_is_level);
        const double half = lettering.width(label, style.small) / 2;
        if (y - half < box.top || y + half > box.bottom) continue;
        sheet.text(label, {box.left - text_gap, y}, upright, Across::centre, Upright::baseline);
    }
    const double arm = style.length(7);
    const LineStyle cross{style.line(1.1), {20, 20, 20}, 0.55, {}};
    for (const double easting : eastings) {
        for (const double northing : northings) {
            const Point p = frame.page({easting, northing});
            if (p.x < box.left + arm || p.x > box.right - arm || p.y < box.top + arm || p.y > box.bottom - arm)
                continue;
            const double c = arm * turn.c, s = arm * turn.s;
            const std::array<Point, 2> level{{{p.x - c, p.y - s}, {p.x + c, p.y + s}}};
            const std::array<Point, 2> vertical{{{p.x + s, p.y - c}, {p.x - s, p.y + c}}};
            sheet.line(level, cross);
            sheet.line(vertical, cross);
        }
    }
}

namespace {

/// Returns the least round step, in degrees, that is at least `least`: whole parts of a degree, a minute, a second.
double degree_step_above(double least) {
    constexpr std::array<double, 9> k_parts{1, 2, 5, 10, 15, 20, 30, 45, 60};
    for (double unit = 1.0 / 3600 / 1e4; unit < 1.0 / 3600; unit *= 10) {
        for (const double part : {1.0, 2.0, 5.0}) {
            if (part * unit >= least) return part * unit;
        }
    }
    for (const double unit : {1.0 / 3600, 1.0 / 60, 1.0}) {
        for (const double part : k_parts) {
            if (part * unit >= least * (1 - 1e-9)) return part * unit;
        }
    }
    return 90;
}

}  // namespace

double tick_band(const PageStyle& style) {
    return style.length(8) + 1.75 * style.small.size_px;
}

std::string degree_words(double degrees, double step, const std::string& letters) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step * 3600) - 1e-9)), 0, 6);
    const double grain = 3600 * std::pow(10.0, decimals);
    const auto whole = static_cast<long long>(std::llround(std::fabs(degrees) * grain));
    const auto per_second = static_cast<long long>(std::llround(std::pow(10.0, decimals)));
    const long long seconds = whole / per_second;
    std::string text = std::to_string(seconds / 3600) + "\u00B0";
    const bool in_seconds = step < 1.0 / 60 * (1 - 1e-9), in_minutes = step < 1 - 1e-9;
    std::array<char, 48> part{};
    if (in_minutes) {
        std::snprintf(part.data(), part.size(), "%02lld\u2032", seconds / 60 % 60);
        text += part.data();
    }
    if (in_seconds) {
        std::snprintf(part.data(), part.size(), "%02lld", seconds % 60);
        text += part.data();
        if (decimals > 0) {
            std::snprintf(part.data(), part.size(), ".%0*lld", decimals, whole % per_second);
            text += part.data();
        }
        text += "\u2033";
    }
    if (whole == 0) return text;
    return text + " " + letters[degrees > 0 ? 0 : 1];
}

std::vector<RoundPlace> round_places(const std::function<double(double)>& at, double step) {
    const double first = at(0), last = at(1);
    std::vector<RoundPlace> places;
    if (!std::isfinite(first) || !std::isfinite(last) || first == last) return places;
    const double least = std::min(first, last), most = std::max(first, last);
    for (double k = std::ceil(least / step); k * step <= most; ++k) {
        const double value = k * step;
        double low = 0, high = 1;
        for (int i = 0; i < 50; ++i) {
            const double middle = (low + high) / 2;
            if ((at(middle) < value) == (first < last)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        places.push_back({value, (low + high) / 2});
    }
    return places;
}

void draw_graticule(Sheet& sheet, const PageStyle& style, const MapFrame& frame,
                    const std::function<Point(Point)>& longitude_latitude, const Words& words) {
    const PageBox box = frame.box();
    const Bounds& window = frame.window;
    const bool east_is_level = frame.turn.east_is_level();  // longitudes along the upper side
    const auto degrees_at = [&](Point page, bool east) {
        const Point at = longitude_latitude(frame.turn.map(page));
        return east ? at.x : at.y;
    };
    const auto upper = [&](double t) {
        return degrees_at({window.west + t * window.width(), window.north}, east_is_level);
    };
    const auto right = [&](double t) {
        return degrees_at({window.east, window.south + t * window.height()}, !east_is_level);
    };
    double span_x, span_y;
    try {
        span_x = upper(1) - upper(0);
        span_y = right(1) - right(0);
    } catch (const Error&) {
        return;  // the projection has no inverse there
    }
    const Lettering& lettering = sheet.lettering();
    const double tick = style.length(8), text_gap = tick + 0.45 * style.small.size_px;
    const LineStyle line{style.line(1.2), k_ink, 1, {}};
    const auto step_for = [&](double span, double pixels) {
        const double widest = lettering.width("000\u00B000\u203200\u2033 W", style.small);
        return degree_step_above(1.5 * widest * std::fabs(span) / pixels);
    };
    const double step_x = step_for(span_x, box.width());
    for (const RoundPlace& one : round_places(upper, step_x)) {
        const double x = box.left + one.place * box.width();
        sheet.line(std::array<Point, 2>{{{x, box.top - tick}, {x, box.top}}}, line);
        const std::string label = words.number(degree_words(one.value, step_x, east_is_level ? words("EW") : "NS"));
        const double half = lettering.width(label, style.small) / 2;
        if (x - half < box.left || x + half > box.right) continue;
        sheet.text(label, {x, box.top - text_gap}, style.small, Across::centre, Upright::baseline);
    }
    const double step_y = step_for(span_y, box.height());
    TextStyle upright = style.small;
    upright.angle_deg = 90;
    for (const RoundPlace& one : round_places(right, step_y)) {
        const double y = box.bottom - one.place * box.height();
        sheet.line(std::array<Point, 2>{{{box.right, y}, {box.right + tick, y}}}, line);
        const std::string label = words.number(degree_words(one.value, step_y, east_is_level ? "NS" : words("EW")));
        const double half = lettering.width(label, style.small) / 2;
        if (y - half < box.top || y + half > box.bottom) continue;
        sheet.text(label, {box.right + text_gap, y}, upright, Across::centre, Upright::top);
    }
}

}  // namespace frana::render
