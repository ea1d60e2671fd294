// SPDX-License-Identifier: Apache-2.0
#include "app/input/flow_window.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/input/check_inputs.h"
#include "app/input/layer_values.h"
#include "app/input/prepare_inflow.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/marks_in.h"
#include "params/keys/scene_parameters.h"
#include "params/keys/zone_keys.h"
#include "simulation/arrivals.h"
#include "simulation/run_warnings.h"

namespace frana::app {
namespace {

constexpr double k_caution = 0.8;          // of the friction: the front runs ahead of the mass it belongs to
constexpr double k_least_friction = 0.01;  // with less, the energy line bounds nothing
constexpr int k_side_samples = 400;        // along each side of what is looked at

Bounds widened(const Bounds& b, double by) {
    return {b.west - by, b.south - by, b.east + by, b.north + by};
}

bool contains(const Bounds& outer, const Bounds& inner) {
    return outer.west < inner.west && outer.south < inner.south && outer.east > inner.east && outer.north > inner.north;
}

double distance(const Bounds& box, Point p) {
    return std::hypot(std::max({box.west - p.x, 0.0, p.x - box.east}),
                      std::max({box.south - p.y, 0.0, p.y - box.north}));
}

/// What keeps a file from being read is reported where it is used.
template <class Read>
auto if_readable(const Read& read) {
    return attempt([&] { return std::optional(read()); });
}

/// Where something comes from, and how high over the ground its energy stands there [m].
struct Origin {
    Bounds extent;
    double head = 0;
};

/// Height of the mass over the ground [m]; where a file or a volume gives it, more than any landslide's.
double thickness_bound(const ReleaseSpec& release) {
    const bool number = release.thickness && release.thickness->kind == nullptr;
    return number && !release.volume ? release.thickness->metres : 100;
}

double velocity_head(double speed, double gravity) {
    return speed * speed / (2 * gravity);
}

Bounds box_of(const gis::RasterInfo& file, const std::string& crs) {
    return gis::CrsTransform(crs.empty() ? "" : file.crs_wkt, crs, file.bounds).around(file.bounds);
}

std::optional<Origin> release_origin(const SceneReading& reading, const std::string& crs) {
    const ReleaseSpec& release = reading.scene.release;
    const double gravity = reading.scene.numerics.gravity;
    Origin origin{{}, thickness_bound(release)};
    const auto& velocity = release.velocity;
    if (velocity && velocity->kind == SourceSpec::Kind::number) origin.head += velocity_head(velocity->number, gravity);
    if (!release.perimeter) {
        if (!release.thickness || !release.thickness->as_in_file()) return std::nullopt;
        return if_readable([&] {
            const gis::RasterInfo file = reading.session.read(gis::inspect_raster, release.thickness->names.front(),
                                                              reading.where("release.thickness"));
            origin.extent = box_of(file, crs);
            return origin;
        });
    }
    return if_readable([&] {
        const std::string key = "release.perimeter";
        const gis::PolygonLayer layer =
            reading.session.read(gis::read_polygons, *release.perimeter, crs, reading.where(key),
                                 layer_choice(reading, release.perimeter_layer, key));
        origin.extent = layer.bounds;
        if (velocity && velocity->kind == SourceSpec::Kind::attribute) {
            double fastest = 0;
            for (const PolygonFeature& feature : layer.features) {
                const auto value = feature.numbers.find(velocity->name);
                if (value != feature.numbers.end()) fastest = std::max(fastest, value->second);
            }
            origin.head += velocity_head(fastest, gravity);
        }
        return origin;
    });
}

std::optional<std::vector<Origin>> inflow_origins(const SceneReading& reading, const std::string& crs) {
    return if_readable([&] {
        const double gravity = reading.scene.numerics.gravity;
        std::vector<Origin> origins;
        const gis::LineInputLayer layer =
            reading.session.read(gis::read_lines, *reading.scene.inflow.line, crs, reading.where("inflow.line"));
        for (std::size_t i = 0; i < layer.features.size(); ++i) {
            const Polyline& line = layer.features[i].line;
            Origin origin{bounds(MultiPolygon{{line, {}}}), 0};
            const double length = length_of(line);
            const Hydrograph read = read_hydrograph(hydrograph_file(reading, layer.features[i], i + 1),
                                                    reading.where("inflow.hydrograph"), gravity, length);
            for (const HydrographPoint& point : read.points) {
                if (point.discharge > 0)
                    origin.head = std::max(
                        origin.head, point.discharge / (length * point.speed) + velocity_head(point.speed, gravity));
            }
            origins.push_back(origin);
        }
        return origins;
    });
}

/// Everything that can move; none where a part of it cannot be placed.
std::optional<std::vector<Origin>> origins_of(const SceneReading& reading, const std::string& crs) {
    const SceneSpec& scene = reading.scene;
    std::vector<Origin> all;
    if (scene.release.perimeter || scene.release.thickness || scene.release.level) {
        const auto release = release_origin(reading, crs);
        if (!release) return std::nullopt;
        all.push_back(*release);
    }
    if (scene.inflow.line && scene.inflow.hydrograph) {
        const auto inflows = inflow_origins(reading, crs);
        if (!inflows) return std::nullopt;
        all.insert(all.end(), inflows->begin(), inflows->end());
    }
    if (all.empty()) return std::nullopt;
    return all;
}

/// The ground of a file: of its cells, or of its polygons, lines and points. None for a file that cannot be read.
std::optional<Bounds> ground_of(const SceneReading& reading, const std::string& file, const std::string& key,
                                const std::string& crs) {
    const Place where = reading.where(key);
    if (const auto raster = if_readable([&] { return reading.session.read(gis::inspect_raster, file, where); }))
        return box_of(*raster, crs);
    const LayerSpec choice = key == "observed.perimeter" ? reading.scene.observed.perimeter_layer : LayerSpec{};
    std::optional<Bounds> box = if_readable([&] {
        return reading.session.read(gis::read_polygons, file, crs, where, layer_choice(reading, choice, key)).bounds;
    });
    const auto add = [&](const Bounds& part) { box = box ? united(*box, part) : part; };
    if (const auto marks = if_readable([&] { return reading.session.read(gis::read_marks, file, crs, where); })) {
        for (const gis::NamedPoint& point : marks->points)
            add({point.place.x, point.place.y, point.place.x, point.place.y});
        for (const gis::NamedLine& line : marks->lines) add(bounds(MultiPolygon{{line.line, {}}}));
    }
    return box;
}

/// Files that must lie on the working grid (Parameter::is_on_map).
std::vector<Bounds> boxes_to_contain(const SceneReading& reading, const std::string& crs) {
    std::vector<Bounds> boxes;
    for (const Parameter& key : scene_parameters()) {
        if (!key.is_on_map) continue;
        const bool clipped = key.name() == "terrain.friction-zones" && reading.scene.zones.beyond_dtm == "clip";
        const auto file = key.write(reading.scene);
        if (!file || clipped) continue;
        if (const auto box = ground_of(reading, *file, key.name(), crs)) boxes.push_back(*box);
    }
    return boxes;
}

}  // namespace

Bounds united(const Bounds& a, const Bounds& b) {
    return {std::min(a.west, b.west), std::min(a.south, b.south), std::max(a.east, b.east), std::max(a.north, b.north)};
}

std::optional<Bounds> flow_window(const SceneReading& reading, const gis::RasterInfo& dtm,
                                  const std::string& working_crs, double most_area) {
    const SceneSpec& scene = reading.scene;
    const double friction = k_caution * sure_friction(scene);
    if (friction < k_least_friction) return std::nullopt;
    std::optional<std::vector<Origin>> origins = origins_of(reading, working_crs);
    if (!origins) return std::nullopt;

    const auto sample = [&](const Bounds& window) {
        return gis::sample_elevations(dtm, working_crs, window, k_side_samples, scene.terrain.vertical_unit,
                                      scene.terrain.nodata_value);
    };
    const gis::CrsTransform to_working(working_crs.empty() ? "" : dtm.crs_wkt, working_crs, dtm.bounds);
    const Bounds whole = to_working.around(dtm.bounds);
    const double cell = whole.width() / static_cast<double>(dtm.columns);
    const auto is_too_large = [&](const Bounds& box) { return box.width() * box.height() > most_area; };
    Bounds needed = origins->front().extent;
    for (const Origin& origin : *origins) needed = united(needed, origin.extent);
    if (is_too_large(needed)) return std::nullopt;
    for (Origin& origin : *origins) {
        double top = -HUGE_VAL;
        for (const gis::ElevationSample& s : sample(widened(origin.extent, 2 * cell))) top = std::max(top, s.elevation);
        if (!std::isfinite(top)) return std::nullopt;  // it lies outside the DTM: reported later
        origin.head += top;                            // now above sea level
    }
    for (const Bounds& box : boxes_to_contain(reading, working_crs)) needed = united(needed, box);

    Bounds window = widened(needed, std::max(needed.width(), needed.height()));
    const auto within_reach = [&](const gis::ElevationSample& s) {
        return std::any_of(origins->begin(), origins->end(), [&](const Origin& origin) {
            return s.elevation <= origin.head - friction * distance(origin.extent, s.place);
        });
    };
    // Looks farther until what can be reached lies within what was looked at.
    for (;;) {
        const double step = std::max(window.width(), window.height()) / k_side_samples;
        Bounds reached = needed;
        for (const gis::ElevationSample& s : sample(window)) {
            if (within_reach(s)) reached = united(reached, {s.place.x, s.place.y, s.place.x, s.place.y});
        }
        reached = widened(reached, 2 * step);
        if (is_too_large(reached)) return std::nullopt;
        if (contains(window, reached) || contains(window, whole)) return reached;
        window = widened(window, std::max(window.width(), window.height()) / 2);
    }
}

}  // namespace frana::app
