// SPDX-License-Identifier: Apache-2.0
#include "app/input/survey_input.h"

#include "app/input/fragility_input.h"

#include "gis/raster/picture_file.h"

#include <algorithm>

#include "core/words/words.h"
#include "params/keys/scene_spec.h"
#include "simulation/scene_values.h"

namespace frana::app {
namespace {

/// Reads one key's marks, if it is set; adds problems to `problems`.
std::optional<gis::Marks> marks_of(const std::optional<std::string>& file, const std::string& key,
                                   const SceneReading& reading, const GridSpec& grid, Problems& problems) {
    if (!file) return std::nullopt;
    return attempt(problems, [&] {
        return std::optional(reading.session.read(gis::read_marks, *file, grid.crs_wkt, reading.where(key)));
    });
}

/// Returns the lines of a key that requires lines.
std::vector<gis::NamedLine> lines_of(const std::optional<gis::Marks>& marks, const std::string& file,
                                     const Place& where, const GridSpec& grid, Problems& problems) {
    if (!marks) return {};
    if (marks->lines.empty() || !marks->points.empty() || marks->polygons > 0)
        problems.add({"is not a layer of lines", where, file, "lines of two points or more", "Draw lines"});
    for (const gis::NamedLine& line : marks->lines) check_inside(line.line, grid, "line " + line.name, where, problems);
    return marks->lines;
}

std::vector<Gauge> gauges_of(const std::optional<gis::Marks>& marks, const std::string& file, const Place& where,
                             const GridSpec& grid, Problems& problems) {
    std::vector<Gauge> gauges;
    if (!marks) return gauges;
    if (marks->points.empty() || !marks->lines.empty() || marks->polygons > 0)
        problems.add({"is not a layer of points", where, file, "points", "Draw points"});
    for (const gis::NamedPoint& point : marks->points) {
        check_inside({point.place}, grid, "gauge " + point.name, where, problems);
        gauges.push_back({point.name, point.place});
    }
    return gauges;
}

template <class Named>
void require_different_names(const std::vector<Named>& list, const Place& where, Problems& problems) {
    std::vector<std::string> names;
    for (const Named& one : list) names.push_back(one.name);
    check_names(std::move(names), where, problems);
}

}  // namespace

std::optional<Bounds> Survey::box() const {
    std::optional<Bounds> all;
    const auto include = [&all](Point p) {
        if (!all) all = Bounds{p.x, p.y, p.x, p.y};
        *all = {std::min(all->west, p.x), std::min(all->south, p.y), std::max(all->east, p.x),
                std::max(all->north, p.y)};
    };
    for (const auto* area : {&scar, &deposit})
        for (const Polygon& polygon : *area)
            for (const Point& point : polygon.outer) include(point);
    for (const gis::NamedPoint& tip : tips) include(tip.place);
    return all;
}

MultiPolygon parts_of(const std::vector<Feature>& features) {
    MultiPolygon all;
    for (const Feature& feature : features)
        all.insert(all.end(), feature.shape.areas.begin(), feature.shape.areas.end());
    return all;
}

void add_surveyed(const std::string& file, const std::string& crs_wkt, const Place& where, Findings found,
                  Survey& survey) {
    gis::Marks marks = gis::read_marks(file, crs_wkt, where);
    const auto closed = [](const gis::NamedLine& line) {
        return line.line.size() > 3 && line.line.front().x == line.line.back().x &&
               line.line.front().y == line.line.back().y;
    };
    const auto areas = marks.polygons + std::count_if(marks.lines.begin(), marks.lines.end(), closed);
    if (areas > 0) {
        const gis::PolygonLayer layer = gis::read_polygons(file, crs_wkt, where);
        found.warn_of(worded("Observed outline"), layer.warnings);
        const MultiPolygon parts = parts_of(layer.features);
        survey.scar.insert(survey.scar.end(), parts.begin(), parts.end());
        survey.scar_label = file;
        return;
    }
    survey.fronts.insert(survey.fronts.end(), marks.lines.begin(), marks.lines.end());
    survey.tips.insert(survey.tips.end(), marks.points.begin(), marks.points.end());
    survey.front_label = file;
}

UsedFile add_deposit(const std::string& file, const GridSpec& grid, const Place& where, Findings found,
                     Survey& survey) {
    survey.deposit_label = file;
    const auto info = attempt([&] { return std::optional(gis::inspect_raster(file, where)); });
    if (!info) {
        const gis::PolygonLayer layer = gis::read_polygons(file, grid.crs_wkt, where);
        found.warn_of(worded("deposit"), layer.warnings);
        survey.deposit = parts_of(layer.features);
        return used_polygons(worded("Surveyed deposit"), file, layer);
    }
    gis::RasterRead read = gis::read_raster_on(file, grid, "", gis::Resampling::automatic);
    found.warn_of(worded("deposit"), read.warnings);
    found.log.note("elevation change resampled to the grid: " + read.resampling_used);
    UsedFile used = used_raster(worded("Surveyed deposit"), *info, read);
    survey.elevation_change = std::move(read.raster);
    return used;
}

ExtraInput prepare_extra(const SceneReading& reading, const GridSpec& grid, std::vector<UsedFile>& files,
                         Findings found, Problems& problems) {
    const OutputSpec& output = reading.scene.output;
    ExtraInput extra;
    const auto keep = [&](const std::string& what, const std::optional<std::string>& file,
                          const std::optional<gis::Marks>& marks) {
        if (marks) files.push_back(used_marks(what, *file, *marks));
    };
    const std::string gauges_key = "output.gauges", sections_key = "output.cross-sections",
                      profiles_key = "output.profiles", front_key = "observed.front", deposit_key = "observed.deposit";

    const auto gauges = marks_of(output.gauges, gauges_key, reading, grid, problems);
    keep(worded("Gauges"), output.gauges, gauges);
    extra.gauges = gauges_of(gauges, output.gauges.value_or(""), reading.where(gauges_key), grid, problems);
    require_different_names(extra.gauges, reading.where(gauges_key), problems);

    const auto sections = marks_of(output.sections, sections_key, reading, grid, problems);
    keep(worded("Cross-sections"), output.sections, sections);
    for (gis::NamedLine& line :
         lines_of(sections, output.sections.value_or(""), reading.where(sections_key), grid, problems))
        extra.sections.push_back({line.name, std::move(line.line)});
    require_different_names(extra.sections, reading.where(sections_key), problems);

    const auto profiles = marks_of(output.profiles, profiles_key, reading, grid, problems);
    keep(worded("Profiles"), output.profiles, profiles);
    extra.profiles = lines_of(profiles, output.profiles.value_or(""), reading.where(profiles_key), grid, problems);
    require_different_names(extra.profiles, reading.where(profiles_key), problems);

    if (const auto& picture = output.map_background) {
        attempt(problems, [&] {
            files.push_back(
                used_picture(worded("Base map"), *picture,
                             gis::check_picture(*picture, grid.crs_wkt, reading.where("output.map-background"))));
        });
    }
    if (const auto& context = output.map_context) {
        attempt(problems, [&] {
            files.push_back(
                used_features(worded("Surroundings"), *context,
                              reading.session.read(gis::read_features, *context, grid.crs_wkt,
                                                   reading.where("output.map-context"), std::string(), std::string())));
        });
    }
    if (const auto& logo = output.map_logo) {
        attempt(problems, [&] {
            const Place where = reading.where("output.map-logo");
            files.push_back(used_picture(worded("Logo"), *logo, gis::read_logo(*logo, where).checksum));
        });
    }
    if (const auto& exposed = output.exposure) {
        attempt(problems, [&] {
            extra.exposure =
                reading.session.read(gis::read_features, *exposed, grid.crs_wkt, reading.where("output.exposure"),
                                     output.exposure_name.value_or(""), output.exposure_count.value_or(""));
            files.push_back(used_features(worded("Exposed features"), *exposed, *extra.exposure));
            if (reading.scene.exposure.fragility) extra.fragility = fragility_of(reading, *extra.exposure, files);
        });
    }
    if (const auto& front = reading.scene.observed.front) {
        attempt(problems, [&] {
            const gis::Marks marks =
                reading.session.read(gis::read_marks, *front, grid.crs_wkt, reading.where(front_key));
            files.push_back(used_marks(worded("Surveyed front"), *front, marks));
            add_surveyed(*front, grid.crs_wkt, reading.where(front_key), found, extra.survey);
            if (!extra.survey.scar.empty()) {
                problems.add({"is an area", reading.where(front_key), *front, "open lines or points",
                              "Give areas as observed.perimeter"});
            }
        });
    }
    if (const auto& deposit = reading.scene.observed.deposit)
        attempt(problems,
                [&] { files.push_back(add_deposit(*deposit, grid, reading.where(deposit_key), found, extra.survey)); });
    return extra;
}

}  // namespace frana::app
