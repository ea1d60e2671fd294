// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/charts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "app/text/text_table.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/access/table_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "render/canvas/furniture.h"

namespace frana::app {

render::Chart chart_sheet(const MapSource& source, const std::string& what, const std::string& note,
                          const std::string& file, std::size_t panels) {
    std::vector<std::string> parts{file, page_attribution(source)};
    for (std::string& line : block_lines(source.style)) parts.push_back(std::move(line));
    render::Chart chart;
    chart.title = page_title(source, what);
    chart.subtitle = note;
    chart.long_subtitle = render::foot_line({note, scenario_line(source)});
    chart.foot = render::foot_line(parts);
    chart.words = source.style.words;
    if (panels > 0) chart.across = panels == 1 ? 1 : panels <= 4 ? 2 : 3;
    return chart;
}

namespace {

using render::Stroke;

constexpr const auto& k_colours = render::k_chart_colours;
constexpr Rgb k_blue = k_colours[0], k_vermilion = k_colours[1], k_green = k_colours[2], k_purple = k_colours[3],
              k_ground = k_colours[4];
constexpr std::size_t k_most_curves = 20;   // that look_apart() tells apart
constexpr std::size_t k_longest_name = 40;  // letters, in the key

/// A table of a result: texts and numbers by column.
class Columns {
  public:
    explicit Columns(const std::string& path) : path_(path), table_(gis::read_table(path, "RESULT_DIR")) {}

    [[nodiscard]] std::size_t rows() const { return table_.rows.size(); }
    [[nodiscard]] const std::string& text(std::size_t row, const std::string& name) const {
        return table_.rows[row][index(name)];
    }
    /// NaN for an empty cell and for non-finite values. Throws Error(input) for a word.
    [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
        const std::size_t column = index(name);
        std::vector<double> values;
        for (const auto& row : table_.rows) {
            const std::string& cell = row[column];
            const auto number = number_from_text(cell);
            if (!number && !cell.empty() && cell != "nan" && cell != "inf" && cell != "-inf") {
                throw Error(ErrorKind::input, Problem{"is not a number in the column " + name, path_,
                                                      elided(valid_utf8(cell), 80), "", "The file is damaged"});
            }
            values.push_back(number.value_or(k_no_data));
        }
        return values;
    }
    [[nodiscard]] bool has(const std::string& name) const {
        return std::find(table_.columns.begin(), table_.columns.end(), name) != table_.columns.end();
    }

  private:
    [[nodiscard]] std::size_t index(const std::string& name) const {
        const auto found = std::find(table_.columns.begin(), table_.columns.end(), name);
        if (found == table_.columns.end())
            throw Error(ErrorKind::input,
                        Problem{"has no column " + name, path_, elided(valid_utf8(joined(table_.columns, ",")), 80), "",
                                "The file is damaged or not from a run"});
        return static_cast<std::size_t>(found - table_.columns.begin());
    }

    std::string path_;
    gis::Table table_;
};

std::vector<Point> joined_points(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
    return points;
}

/// Returns each kind of row of a table, in the order of first appearance.
std::vector<std::string> kinds_of(const Columns& table, const std::string& column) {
    std::vector<std::string> kinds;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& kind = table.text(row, column);
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    }
    return kinds;
}

/// `line` as in the table.
NamedChart profile_chart(const Columns& table, const std::string& line, const std::string& stem,
                         const MapSource& source) {
    const std::vector<double> distance = table.numbers("distance_m"), bed = table.numbers("bed_m");
    const auto column = [&](const std::string& name) {
        std::vector<double> values = table.numbers(name);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (table.text(i, "line") != line) values[i] = k_no_data;
        return values;
    };
    const auto on_line = [&](const std::vector<double>& values) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (table.text(i, "line") == line) points.push_back({distance[i], values[i]});
        return points;
    };
    const auto surface = [&](const std::string& name) {
        std::vector<double> values = column(name);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] > 0 ? bed[i] + values[i] : k_no_data;
        return on_line(values);
    };
    std::vector<double> foot;
    for (const Point p : on_line(bed)) foot.push_back(p.y);
    const Words& words = source.style.words;
    const std::string metres = words("Distance") + " [m]";
    render::ChartPanel relief{words("Elevation"), metres, words("Elevation") + " [m]", {}};
    relief.series = {{words("final surface"), k_vermilion, surface(RasterName::final_depth), 2, Stroke::solid, foot},
                     {words("initial surface"), k_green, surface("release_m"), 2, Stroke::dotted},
                     {words("bed plus maximum depth"), k_blue, surface(RasterName::max_depth), 2, Stroke::dashed},
                     {words("Bed"), k_ground, on_line(bed), 2.4}};
    relief.fraction = 1.5;
    // Tables of older results lack the column.
    const bool is_normal =
        table.rows() > 0 && table.has("depth_direction") && table.text(0, "depth_direction") == k_normal;
    if (is_normal)  // it does not give the surface
        relief.series = {relief.series[1], relief.series[3]};
    render::ChartPanel depths{words("Flow depth") + ", " + words(is_normal ? k_normal : k_vertical),
                              metres,
                              words("Flow depth") + " [m]",
                              {},
                              {0}};
    depths.series = {{words("maximum"), k_blue, on_line(column(RasterName::max_depth)), 2, Stroke::dashed},
                     {words("Released"), k_green, on_line(column("release_m")), 2, Stroke::dotted},
                     {words("at the end"), k_vermilion, on_line(column(RasterName::final_depth)), 2}};
    render::ChartPanel speeds{words("Maximum velocity"), metres, words("Flow velocity") + " [m/s]", {}, {0}};
    speeds.series = {{words("maximum"), k_blue, on_line(column(RasterName::max_velocity)), 2}};
    const std::string own = elided(text_of_cell(line), k_longest_name);
    const std::string name = words.labelled(words("Profiles"), own == "flow path" ? words("Path") : own);
    render::Chart chart = chart_sheet(source, name, "", k_profile_table);
    chart.panels = {relief, depths, speeds};
    return {"profile_" + stem, chart, name};
}

NamedChart series_chart(const Columns& table, const MapSource& source) {
    const std::vector<double> time = table.numbers("time_s");
    const auto curve = [&](const std::string& name, const std::string& label, Rgb colour, double factor = 1,
                           Stroke stroke = Stroke::solid) {
        std::vector<double> values = table.numbers(name);
        for (double& value : values) value *= factor;
        return render::ChartSeries{label, colour, joined_points(time, values), 2.2, stroke};
    };
    const Words& words = source.style.words;
    const std::string seconds = words("Time") + " [s]";
    render::Chart chart = chart_sheet(source, words("Course of the flow"), "", k_series_file);
    chart.across = 2;
    chart.panels = {
        {words("Maximum velocity"),
         seconds,
         words("Flow velocity") + " [m/s]",
         {curve("max_speed_ms", "", k_vermilion)},
         {0}},
        {words("Maximum depth"),
         seconds,
         words("Flow depth") + " [m]",
         {curve("max_depth_m", words("vertical"), k_blue)},
         {0}},
        {words("Front distance"), seconds, words("Distance") + " [m]", {curve("front_distance_m", "", k_purple)}, {0}},
        {words("Covered area"),
         seconds,
         words("Area") + " [1000 m\u00B2]",
         {curve("covered_area_m2", "", k_green, 1e-3)},
         {0}},
        {words("Kinetic energy"),
         seconds,
         words("Kinetic energy") + " [GJ]",
         {curve("kinetic_energy_j", "", k_vermilion, 1e-9)},
         {0}},
        {words("Volume"),
         seconds,
         words("Volume") + " [1000 m\u00B3]",
         {curve("volume_m3", words("Inside the domain"), k_blue, 1e-3),
          curve("volume_left_m3", words("Left the domain"), k_vermilion, 1e-3, Stroke::dashed)},
         {0}}};
    return {"timeseries", chart, words("Course of the flow")};
}

NamedChart scores_chart(const Columns& table, const ResultReader& result, const MapSource& source) {
    const std::vector<double> threshold = table.numbers("threshold_m");
    const auto curve = [&](const std::string& name, const std::string& label, std::size_t colour, Stroke stroke) {
        return render::ChartSeries{label, k_colours[colour], joined_points(threshold, table.numbers(name)), 2.4,
                                   stroke};
    };
    const Words& words = source.style.words;
    const std::string metres = words("Depth threshold") + " [m]";
    render::ChartPanel scores{words("Scores"), metres, words("Scores"), {}, {0}};
    scores.series = {curve("jaccard", "Jaccard", 0, Stroke::solid), curve("dice", "Dice", 1, Stroke::dash_dot),
                     curve("true_positive_rate", words("True positive rate"), 2, Stroke::dashed),
                     curve("false_positive_rate", words("False positive rate"), 3, Stroke::dotted)};
    render::ChartPanel areas{words("Area difference"), metres, words("Area difference") + " [%]", {}, {0}};
    areas.series = {curve("area_difference_percent", "", 0, Stroke::solid)};
    for (render::ChartPanel* panel : {&scores, &areas}) {
        panel->x = render::Scale::logarithmic;
        panel->mark_x = result.scene_number("observed.threshold", result.scene_number("output.trace-threshold", 0.1));
    }
    scores.fraction = 1.6;
    render::Chart chart =
        chart_sheet(source, words("Scores"), words("dashed: the threshold of the comparison"), k_comparison_curve);
    chart.panels = {scores, areas};
    return {"scores", chart, words("Scores")};
}

/// One panel per quantity, one curve per place.
NamedChart places_chart(const Columns& table, const std::string& place, const MapSource& source,
                        const std::string& title, const std::string& file,
                        const std::vector<std::array<std::string, 3>>& quantities) {
    const std::vector<double> time = table.numbers("time_s");
    const Words& words = source.style.words;
    std::string note;
    std::vector<std::string> kinds = kinds_of(table, place);
    if (kinds.size() > k_most_curves) {
        note =
            words("{1} of {2}; all: {3}", {std::to_string(k_most_curves), std::to_string(kinds.size()), file + ".csv"});
        kinds.resize(k_most_curves);
    }
    render::Chart chart = chart_sheet(source, title, note, file + ".csv");
    for (const auto& [column, name, unit] : quantities) {
        const std::vector<double> values = table.numbers(column);
        render::ChartPanel panel{words(name), words("Time") + " [s]", words(name) + " [" + unit + "]", {}, {0}};
        for (const std::string& kind : kinds) {
            render::ChartSeries curve{elided(text_of_cell(kind), k_longest_name), k_blue, {}};
            render::look_apart(curve, panel.series.size());
            for (std::size_t i = 0; i < values.size(); ++i)
                if (table.text(i, place) == kind) curve.points.push_back({time[i], values[i]});
            panel.series.push_back(std::move(curve));
        }
        chart.panels.push_back(std::move(panel));
    }
    return {file, chart, title};
}

/// Returns whether a table has more than its header. Throws Error(input) if the header is missing or truncated.
bool has_rows(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string header, first;
    const bool named = std::getline(file, header) && !header.empty();
    const bool any = static_cast<bool>(std::getline(file, first));
    file.clear();
    file.seekg(-1, std::ios::end);
    if (!named || file.get() != '\n')
        throw Error(ErrorKind::input, Problem{named ? "is cut off in the middle of a row" : "has no header", path, "",
                                              "", "The file is damaged"});
    return any;
}

}  // namespace

std::vector<NamedChart> result_charts(const ResultReader& result, const MapSource& source, Problems& problems) {
    std::vector<NamedChart> charts;
    const auto table = [&](const std::string& name, const auto& draw) {
        if (!result.has(name)) return;
        attempt(problems, [&] {
            // A table without rows means no flow, or no line found.
            if (has_rows(result.path(name))) draw(Columns(result.path(name)));
        });
    };
    table(k_profile_table, [&](const Columns& columns) {
        const std::vector<std::string> lines = kinds_of(columns, "line");
        std::vector<std::string> names;
        for (const std::string& line : lines) names.push_back(text_of_cell(line));
        const std::vector<std::string> stems = file_stems(names);
        for (std::size_t i = 0; i < lines.size(); ++i)
            charts.push_back(profile_chart(columns, lines[i], stems[i], source));
    });
    table(k_series_file, [&](const Columns& columns) { charts.push_back(series_chart(columns, source)); });
    table(k_gauge_table, [&](const Columns& columns) {
        charts.push_back(
            places_chart(columns, "gauge", source, source.style.words("Gauges"), "gauges",
                         {{"depth_m", worded("Flow depth"), "m"}, {"speed_ms", worded("Flow velocity"), "m/s"}}));
    });
    table(k_section_table, [&](const Columns& columns) {
        charts.push_back(
            places_chart(columns, "section", source, source.style.words("Cross-sections"), "sections",
                         {{"discharge_m3s", worded("Discharge"), "m³/s"}, {"volume_m3", worded("Volume"), "m³"}}));
    });
    table(k_comparison_curve, [&](const Columns& columns) { charts.push_back(scores_chart(columns, result, source)); });
    return charts;
}

std::vector<std::string> chart_files(const ResultReader& result, const MapSource& source, const std::string& folder) {
    std::vector<std::string> files;
    Problems drawn_later;  // repeated and reported at that time
    for (const NamedChart& one : result_charts(result, source, drawn_later)) {
        const auto more = picture_files(source.style, (std::filesystem::path(folder) / one.name).string());
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

std::vector<std::string> draw_charts(const ResultReader& result, const MapSource& source, const std::string& folder,
                                     Problems& problems) {
    std::vector<std::string> files;
    const Size size = source.style.size;
    for (const NamedChart& one : result_charts(result, source, problems)) {
        try {
            for (const std::string& file :
                 write_plain_picture(render::chart_page(one.chart, size.width, size.height), source.style,
                                     one.chart.title, (std::filesystem::path(folder) / one.name).string()))
                files.push_back(file);
        } catch (const Error& error) {
            for (Problem problem : error.problems()) {
                problem.where += (problem.where.empty() ? "" : ", ") + ("chart " + one.name);
                problems.add(Error(error.kind(), problem));
            }
        } catch (const std::exception& error) {
            problems.add({error.what(), "chart " + one.name, "", "", ""});
        }
    }
    return files;
}

bool is_drawn(const std::string& what, Findings found, const std::function<void()>& draw) {
    try {
        draw();
        found.log.note("drew " + what);
        return true;
    } catch (const std::exception& error) {
        found.warn(worded("{1} could not be drawn: {2}", {what, std::string(error.what())}));
        return false;
    }
}

void write_chart(const NamedChart& one, const MapStyle& style, const std::string& folder, bool for_page) {
    const std::filesystem::path place(folder);
    write_plain_picture(render::chart_page(one.chart, style.size.width, style.size.height), style, one.chart.title,
                        (place / "charts" / one.name).string());
    if (!for_page) return;
    std::filesystem::create_directories(place / k_page_folder);
    write_text_file((place / k_page_folder / (one.name + ".svg")).string(), page_chart_svg(one.chart));
}

std::string page_chart_svg(const render::Chart& chart) {
    // 9 of 720 units, the smallest letters, are 6.4 points on the report's 180 mm. Charts of many panels are higher.
    constexpr int k_width = 720, k_heights[] = {400, 640};
    for (const int height : k_heights) {
        try {
            return render::chart_svg(chart, k_width, height);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
        }
    }
    return render::chart_svg(chart, k_width, 1000);
}

}  // namespace frana::app
