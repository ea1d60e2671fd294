// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/difference_layer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "app/text/number_text.h"
#include "core/colour.h"
#include "core/error.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/raster/raster_in.h"

namespace frana::app {
namespace {

/// Returns the terrain around a raster: its own cells if in the same CRS, else warped to the raster's.
Raster terrain_for(const Raster& layer, const std::string& dtm) {
    const gis::RasterInfo info = gis::inspect_raster(dtm, "--dtm");
    const std::string& crs = layer.grid.crs_wkt;
    const bool same = crs.empty() || info.crs_wkt.empty() || gis::crs_name(info.crs_wkt) == gis::crs_name(crs);
    if (same && !info.rotated && std::abs(info.cell_x - info.cell_y) < 1e-6 * info.cell_x)
        return gis::read_result_raster(dtm);
    return gis::read_raster_on(dtm, layer.grid, "", gis::Resampling::automatic, "auto", std::nullopt, "--dtm").raster;
}

}  // namespace

ForeignMap read_foreign_map(const std::string& file, const std::optional<std::string>& dtm,
                            const std::optional<std::string>& unit, const std::optional<double>& above,
                            const Words& words) {
    ForeignMap map;
    map.source.style.words = words;
    map.layer = read_map_layer(file, words, true);
    if (map.layer.unit.empty()) map.layer.unit = unit.value_or("");
    if (above) {
        for (double& value : map.layer.values.values)
            if (!(value > *above)) value = k_no_data;
        map.layer.notes.push_back("> " + words.number(number_text(*above)) + " " + map.layer.unit);
    }
    const GridSpec& grid = map.layer.values.grid;
    MapSource& source = map.source;
    if (dtm) {
        source.terrain = terrain_for(map.layer.values, *dtm);
        if (are_apart(source.terrain.grid.bounds(), grid.bounds())) {
            throw Error(ErrorKind::input, Problem{"does not overlap the raster", "--dtm", *dtm, "",
                                                  "Check the coordinate reference systems of both files"});
        }
    }
    source.longitude_latitude = longitude_latitude(grid.crs_wkt);
    source.title = map.layer.name;
    source.foreign = true;
    source.crs_label = gis::crs_name(grid.crs_wkt);
    if (!grid.crs_wkt.empty()) {
        source.convergence_deg = gis::meridian_convergence_deg(
            grid.crs_wkt, {(grid.west + grid.east()) / 2, (grid.south() + grid.north) / 2});
    }
    return map;
}

namespace {

constexpr std::size_t k_most_bounds = 5;  // on each side: more colours cannot be told apart

Error refusal(const ResultReader& second, const std::string& what, const std::string& value, const std::string& limit) {
    return {ErrorKind::input, Problem{what, "--difference", second.directory() + ": " + value, limit,
                                      "Run one of the scenes with the other's terrain.crs, cell-size and bounds"}};
}

/// Number of whole cells between two lattice lines; throws if there is no such number.
std::int64_t cells_between(double from, double to, double cell, const ResultReader& second) {
    constexpr double k_tolerance = 1e-3;  // of a cell
    const double cells = (to - from) / cell;
    if (std::fabs(cells - std::round(cells)) > k_tolerance)
        throw refusal(second,
                      "has cells that do not coincide with those of the result: values between cells are not made up",
                      "shifted by " + shortest_text(to - from) + " m", "whole cells of " + shortest_text(cell) + " m");
    return std::llround(cells);
}

/// The cells of both.
GridSpec common_grid(const GridSpec& a, const GridSpec& b, const ResultReader& second) {
    if (a.crs_wkt != b.crs_wkt && gis::crs_name(a.crs_wkt) != gis::crs_name(b.crs_wkt))
        throw refusal(second, "has another coordinate reference system than the result", gis::crs_name(b.crs_wkt),
                      gis::crs_name(a.crs_wkt));
    if (a.cell_size != b.cell_size)
        throw refusal(second, "has cells of another size than the result", shortest_text(b.cell_size) + " m",
                      shortest_text(a.cell_size) + " m");
    const std::int64_t right = cells_between(a.west, b.west, a.cell_size, second),
                       down = cells_between(b.north, a.north, a.cell_size, second);
    const std::int64_t left = std::min<std::int64_t>(right, 0), top = std::min<std::int64_t>(down, 0);
    GridSpec all = a;
    all.west += static_cast<double>(left) * a.cell_size;
    all.north -= static_cast<double>(top) * a.cell_size;
    all.columns = std::max<std::int64_t>(a.columns, right + b.columns) - left;
    all.rows = std::max<std::int64_t>(a.rows, down + b.rows) - top;
    return all;
}

/// The place of a raster's upper left cell in a larger one.
struct Shift {
    std::int64_t columns, rows;
};
Shift shift_of(const GridSpec& part, const GridSpec& all) {
    return {std::llround((part.west - all.west) / all.cell_size),
            std::llround((all.north - part.north) / all.cell_size)};
}

/// Calls `visit(cell of all, value)` for every value of a raster.
template <class Visit>
void for_each_value(const Raster& part, const GridSpec& all, const Visit& visit) {
    const Shift shift = shift_of(part.grid, all);
    part.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const auto at = static_cast<std::int64_t>(cell);
        const std::int64_t row = at / part.grid.columns + shift.rows, column = at % part.grid.columns + shift.columns;
        visit(static_cast<std::size_t>(row * all.columns + column), value);
    });
}

Raster placed(const Raster& part, const GridSpec& all) {
    Raster whole(all, k_no_data);
    for_each_value(part, all, [&](std::size_t cell, double value) { whole.values[cell] = value; });
    return whole;
}

/// Bounds of classes on both sides of zero: those of the quantity, open at both ends; without any, round ones up to the
/// greatest difference.
std::vector<double> symmetric(const std::vector<double>& classes, const Raster& values) {
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    std::vector<double> above;
    for (const double bound : classes)
        if (bound > 0 && std::isfinite(bound) && above.size() < k_most_bounds) above.push_back(bound);
    const bool fixed = !above.empty();
    if (!fixed) {
        double greatest = 0;
        values.values.for_each_stored([&](std::size_t, double value) {
            if (std::isfinite(value)) greatest = std::max(greatest, std::fabs(value));
        });
        above = nice_classes(greatest, static_cast<int>(k_most_bounds));
        above.erase(above.begin());
    }
    std::vector<double> all;
    if (fixed) all.push_back(-k_infinity);
    for (auto bound = above.rbegin(); bound != above.rend(); ++bound) all.push_back(-*bound);
    all.insert(all.end(), above.begin(), above.end());
    if (fixed) all.push_back(k_infinity);
    return all;
}

bool same_outline(const MultiPolygon& a, const MultiPolygon& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Polygon& p, const Polygon& q) {
        return std::equal(p.outer.begin(), p.outer.end(), q.outer.begin(), q.outer.end(),
                          [](Point x, Point y) { return x.x == y.x && x.y == y.y; });
    });
}

/// The titles of both; where they are the same, as of two runs of one scene, with as much of their folders as differs.
std::pair<std::string, std::string> names_of(const MapSource& a, const ResultReader& first, const MapSource& b,
                                             const ResultReader& second) {
    namespace fs = std::filesystem;
    if (a.title != b.title) return {a.title, b.title};
    const auto folder_of = [](const ResultReader& result) {
        const fs::path folder = fs::absolute(result.directory()).lexically_normal();
        return folder.has_filename() ? folder : folder.parent_path();
    };
    fs::path x = folder_of(first), y = folder_of(second), end_of_x = x.filename(), end_of_y = y.filename();
    for (; x != y && end_of_x == end_of_y; end_of_x = x.filename() / end_of_x, end_of_y = y.filename() / end_of_y) {
        x = x.parent_path();
        y = y.parent_path();
    }
    return {a.title + " (" + valid_utf8(end_of_x.string()) + ")", b.title + " (" + valid_utf8(end_of_y.string()) + ")"};
}

/// Adds what belongs to the second result alone.
void add_second(MapSource& source, const MapSource& second, const GridSpec& all) {
    Raster terrain = placed(second.terrain.grid.columns > 0 ? second.terrain : source.terrain, all);
    if (source.terrain.grid.columns > 0)
        for_each_value(source.terrain, all, [&](std::size_t cell, double value) { terrain.values[cell] = value; });
    source.terrain = std::move(terrain);
    Raster extent(all, k_no_data);
    const auto add = [&](const Raster& one) {
        if (one.grid.columns == 0) return;
        for_each_value(one, all, [&](std::size_t cell, double value) { extent.values[cell] = value; });
    };
    add(source.extent);
    add(second.extent);
    source.extent = std::move(extent);
}

}  // namespace

DifferenceMap difference_map(const ResultReader& first, const ResultReader& second, const std::string& name) {
    MapLayer a = first.map_layer(name), b = second.map_layer(name);
    if (!a.categories.empty() || !b.categories.empty() || a.dots || b.dots)
        throw Error(ErrorKind::input, Problem{"has classes or particles, which have no difference", "--map", name,
                                              "a raster of numbers: max_depth, max_velocity, max_pressure", ""});
    const GridSpec all = common_grid(a.values.grid, b.values.grid, second);
    DifferenceMap map{first.map_source(), {}};
    const MapSource other = second.map_source();
    const bool both = a.palette == "time";  // a time without flow is not 0
    MapLayer& layer = map.layer;
    layer.values = Raster(all, k_no_data);
    Raster seen(all, k_no_data);
    for_each_value(a.values, all, [&](std::size_t cell, double value) {
        if (!both) layer.values.values[cell] = value;
        seen.values[cell] = value;
    });
    for_each_value(b.values, all, [&](std::size_t cell, double value) {
        const double here = std::as_const(seen).values[cell];
        if (!std::isnan(here))
            layer.values.values[cell] = here - value;
        else if (!both)
            layer.values.values[cell] = -value;
    });
    layer.name = "difference_" + a.name;
    const Words& words = map.source.style.words;
    layer.title = words.labelled(words("Difference"), a.title);
    layer.unit = a.unit;
    layer.palette = "difference";
    layer.classes = symmetric(a.classes, layer.values);
    layer.time = a.time;
    layer.source = a.source + ", A − B";
    layer.notes_alone = true;
    const auto [name_of_a, name_of_b] = names_of(map.source, first, other, second);
    layer.notes = {words.labelled("A", name_of_a), words.labelled("B", name_of_b), "A − B",
                   both ? words("cells that both reach") : words("0 where not reached")};
    add_second(map.source, other, all);
    map.source.scenario =
        sentences(words.labelled("A", scenario_line(map.source)), words.labelled("B", scenario_line(other)));
    map.source.warnings.clear();
    constexpr Rgb k_release_of_second{120, 60, 0};
    if (!other.release.empty() && !same_outline(other.release, map.source.release))
        map.source.marks.push_back({words("Release") + " B", other.release, k_release_of_second, 2, true});
    return map;
}

}  // namespace frana::app
