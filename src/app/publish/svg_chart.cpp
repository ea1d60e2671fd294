// SPDX-License-Identifier: Apache-2.0
#include "app/publish/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/text/number_text.h"
#include "core/utf8.h"

namespace frana::app {
namespace {

constexpr double k_width = 640, k_height = 260, k_left = 64, k_right = 12, k_top = 10, k_bottom = 44;
constexpr std::size_t k_most_points = 600;

struct Axis {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    bool log = false;

    void include(double value) {
        if (!usable(value)) return;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    [[nodiscard]] bool usable(double value) const { return std::isfinite(value) && (!log || value > 0); }
    [[nodiscard]] double share(double value) const {
        return log ? std::log(value / least) / std::log(most / least) : (value - least) / (most - least);
    }
    void finish() {
        if (least > most) least = log ? 0.1 : 0, most = 1;
        if (!log) least = std::min(least, 0.0);
        if (least == most) most = log ? 10 * least : least + 1;
    }
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> list;
        if (log) {
            for (double t = std::pow(10.0, std::ceil(std::log10(least) - 1e-9)); t <= most * (1 + 1e-9); t *= 10)
                list.push_back(t);
            return list;
        }
        const double rough = (most - least) / 5, decade = std::pow(10.0, std::floor(std::log10(rough)));
        double step = 10 * decade;
        for (const double factor : {5.0, 2.0, 1.0})
            if (factor * decade >= rough) step = factor * decade;
        for (double t = std::ceil(least / step - 1e-9) * step; t <= most + 1e-9 * step; t += step)
            list.push_back(std::abs(t) < 1e-9 * step ? 0 : t);
        return list;
    }
};

std::string pixel(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// Least and greatest of every stretch, in their order.
std::vector<std::size_t> shown_points(const SvgSeries& series) {
    std::vector<std::size_t> shown;
    const std::size_t count = series.y.size();
    const std::size_t stretch = std::max<std::size_t>(1, 2 * count / k_most_points);
    for (std::size_t begin = 0; begin < count; begin += stretch) {
        const std::size_t end = std::min(count, begin + stretch);
        const auto [least, most] = std::minmax_element(series.y.begin() + static_cast<std::ptrdiff_t>(begin),
                                                       series.y.begin() + static_cast<std::ptrdiff_t>(end));
        auto a = static_cast<std::size_t>(least - series.y.begin()),
             b = static_cast<std::size_t>(most - series.y.begin());
        if (a > b) std::swap(a, b);
        shown.push_back(a);
        if (b != a) shown.push_back(b);
    }
    return shown;
}

}  // namespace

std::string html_escaped(const std::string& text) {
    std::string out;
    for (const char c : valid_utf8(text)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (c == '\'')
            out += "&#39;";
        else
            out += c;
    }
    return out;
}

std::string svg_chart(const SvgChart& chart) {
    Axis x, y;
    x.log = chart.log_x;
    for (const SvgSeries& series : chart.series) {
        for (const double value : series.x) x.include(value);
        for (const double value : series.y) y.include(value);
    }
    x.finish();
    y.finish();
    const double plot_width = k_width - k_left - k_right, plot_height = k_height - k_top - k_bottom;
    const auto px = [&](double value) { return k_left + plot_width * x.share(value); };
    const auto py = [&](double value) { return k_top + plot_height * (1 - y.share(value)); };
    const auto text = [](double at_x, double at_y, const std::string& anchor, const std::string& words) {
        return "<text x=\"" + pixel(at_x) + "\" y=\"" + pixel(at_y) + "\" text-anchor=\"" + anchor + "\">" +
               html_escaped(words) + "</text>\n";
    };
    std::string svg = "<svg viewBox=\"0 0 " + pixel(k_width) + " " + pixel(k_height) + "\" role=\"img\">\n";
    for (const double tick : x.ticks()) {
        svg += "<path class=\"grid\" d=\"M" + pixel(px(tick)) + " " + pixel(k_top) + "V" + pixel(k_height - k_bottom) +
               "\"/>\n" + text(px(tick), k_height - k_bottom + 15, "middle", figure(tick, 4));
    }
    for (const double tick : y.ticks()) {
        svg += "<path class=\"grid\" d=\"M" + pixel(k_left) + " " + pixel(py(tick)) + "H" + pixel(k_width - k_right) +
               "\"/>\n" + text(k_left - 6, py(tick) + 4, "end", figure(tick, 4));
    }
    svg += text(k_left + plot_width / 2, k_height - 8, "middle", chart.x_label);
    svg += "<text transform=\"translate(13 " + pixel(k_top + plot_height / 2) +
           ") rotate(-90)\" text-anchor=\"middle\">" + html_escaped(chart.y_label) + "</text>\n";
    double legend_y = k_top + 14;
    for (const SvgSeries& series : chart.series) {
        std::string path;
        bool pen_down = false;
        for (const std::size_t i : shown_points(series)) {
            if (!x.usable(series.x[i]) || !y.usable(series.y[i])) {
                pen_down = false;
                continue;
            }
            path += (pen_down ? "L" : "M") + pixel(px(series.x[i])) + " " + pixel(py(series.y[i]));
            pen_down = true;
        }
        svg += "<path class=\"line\" stroke=\"" + series.colour + "\" d=\"" + path + "\"/>\n";
        if (chart.series.size() < 2) continue;
        svg += "<path class=\"line\" stroke=\"" + series.colour + "\" d=\"M" + pixel(k_width - k_right - 24) + " " +
               pixel(legend_y - 4) + "h18\"/>\n" + text(k_width - k_right - 30, legend_y, "end", series.label);
        legend_y += 15;
    }
    return svg + "</svg>\n";
}

}  // namespace frana::app
