// SPDX-License-Identifier: Apache-2.0
#include "simulation/arrivals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/separate_flows.h"
#include "core/error.h"
#include "simulation/release.h"
#include "simulation/scene.h"

namespace frana {
namespace {

// Directions closer to the line's own (sine of the angle) would need an unbounded row to carry the discharge.
constexpr double k_least_crossing = 0.1;

struct OnLine {
    Point place, tangent;
};

OnLine at_distance(const Polyline& line, double distance) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        const double piece = std::hypot(b.x - a.x, b.y - a.y);
        if (distance > piece && i + 2 < line.size()) {
            distance -= piece;
            continue;
        }
        if (!(piece > 0)) continue;
        const Point t{(b.x - a.x) / piece, (b.y - a.y) / piece};
        return {{a.x + distance * t.x, a.y + distance * t.y}, t};
    }
    return {line.front(), {1, 0}};
}

Error refused(const std::string& what, const std::string& key, const std::string& value, const std::string& remedy) {
    return {ErrorKind::input, Problem{what, key, value, "", remedy}};
}

void check_ground(const Scene& scene, Point local) {
    const GridSpec& grid = scene.grid;
    const Point map = grid.map_from_local(local);
    char text[64];
    std::snprintf(text, sizeof text, "(%.1f, %.1f)", map.x, map.y);
    if (!grid.local_bounds().contains(local.x, local.y))
        throw refused("the inflow's line reaches beyond the working grid", "inflow.line", text,
                      "Shorten it or take a larger DTM");
    const Cell cell = cell_of(grid, local);
    if (!scene.terrain.has_data(cell.row, cell.column))
        throw refused("the terrain has no data under the inflow's line", "inflow.line", text, "Move the line");
    if (scene.walls && scene.walls->at(cell.row, cell.column) != 0)
        throw refused("a wall stands on the inflow's line", "inflow.line", text, "Move the line or the wall");
}

}  // namespace

double length_of(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        sum += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    return sum;
}

double critical_speed(double gravity, double discharge, double length) {
    return std::cbrt(gravity * discharge / length);
}

double volume_of(const Inflow& inflow, double end) {
    double volume = 0;
    for (std::size_t i = 0; i + 1 < inflow.hydrograph.size(); ++i) {
        const HydrographPoint &a = inflow.hydrograph[i], &b = inflow.hydrograph[i + 1];
        const double span = b.time - a.time, time = std::min(b.time, end) - a.time;
        if (time > 0) volume += time * (a.discharge + 0.5 * (b.discharge - a.discharge) * time / span);
    }
    return volume;
}

double particles_of(const Inflow& inflow, double spacing, double end) {
    double way = 0;
    for (std::size_t i = 0; i + 1 < inflow.hydrograph.size(); ++i) {
        const HydrographPoint &a = inflow.hydrograph[i], &b = inflow.hydrograph[i + 1];
        const double from = std::min(a.time, end), to = std::min(b.time, end);
        way += std::max(a.speed, b.speed) * (to - from);
    }
    return way / spacing * (length_of(inflow.line) / spacing + 1);
}

std::vector<InflowBatch> cut_hydrograph(const std::vector<HydrographPoint>& hydrograph, double spacing, double end) {
    std::vector<InflowBatch> batches;
    InflowBatch open;  // since the last row
    double since = hydrograph.empty() ? 0 : hydrograph.front().time;
    const auto close = [&](double time) {
        if (open.volume > 0) batches.push_back({time, open.volume, open.length, open.length / (time - since)});
        open = {};
        since = time;
    };
    for (std::size_t i = 0; i + 1 < hydrograph.size() && hydrograph[i].time < end; ++i) {
        HydrographPoint a = hydrograph[i];
        const HydrographPoint b = hydrograph[i + 1];
        const double span = b.time - a.time;
        if (!(span > 0)) continue;
        if (a.discharge == 0 && b.discharge == 0) {  // a pause: the row ends with the part that has
                                                     // crossed
            close(a.time);
            since = b.time;
            continue;
        }
        const auto at = [&](double time) {
            const double s = (time - hydrograph[i].time) / span;
            return HydrographPoint{time, (1 - s) * hydrograph[i].discharge + s * b.discharge,
                                   (1 - s) * hydrograph[i].speed + s * b.speed};
        };
        const HydrographPoint last = b.time <= end ? b : at(end);
        const double acceleration = (b.speed - hydrograph[i].speed) / span;
        while (a.time < last.time) {
            // Time until the row is full: length + v t + acceleration t^2 / 2 = spacing.
            const bool begun = open.length > 0;
            const double missing = spacing - open.length;
            const double root = a.speed * a.speed + 2 * acceleration * missing;
            const double full = root > 0 ? 2 * missing / (a.speed + std::sqrt(root)) : last.time - a.time;
            const bool fills = full < last.time - a.time;
            const HydrographPoint to = fills ? at(a.time + full) : last;
            const double dt = to.time - a.time;
            open.volume += 0.5 * (a.discharge + to.discharge) * dt;
            open.length += 0.5 * (a.speed + to.speed) * dt;
            if (fills) close(to.time);
            if (!(dt > 0) && !begun) break;  // a whole row in less than the resolution of time
            a = to;
        }
        if (last.discharge == 0 || last.time >= end || i + 2 == hydrograph.size()) close(last.time);
    }
    return batches;
}

InflowSource::InflowSource(const Scene& scene, const Inflow& inflow) : gravity_(scene.numerics.gravity) {
    Polyline line;
    for (const Point& map : inflow.line) line.push_back(scene.grid.local_from_map(map));
    const double length = length_of(line), spacing = lattice_spacing(scene);
    if (line.size() < 2 || !(length > 0))
        throw refused("the inflow's line has no length", "inflow.line", "", "Redraw it");
    const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
    std::vector<Point> slopes, tangents;
    double towards_left = 0;  // fall of the ground to the left of the line
    for (std::size_t k = 0; k < count; ++k) {
        const double fraction = 1 / static_cast<double>(count);
        const OnLine on = at_distance(line, (static_cast<double>(k) + 0.5) * fraction * length);
        check_ground(scene, on.place);
        slopes.push_back(gradient(scene.terrain, cell_of(scene.grid, on.place)));
        tangents.push_back(on.tangent);
        towards_left += (slopes.back().x * on.tangent.y - slopes.back().y * on.tangent.x) * fraction;
        mouths_.push_back({on.place, {}, 1, fraction * length, fraction});
    }
    if (!inflow.azimuth && !(std::abs(towards_left) > 1e-6))
        throw refused("the ground is level across the inflow's line", "inflow.line", "", "Give inflow.direction");
    for (std::size_t k = 0; k < count; ++k) {
        Mouth& mouth = mouths_[k];
        const Point t = tangents[k];
        const double side = towards_left > 0 ? 1 : -1;
        mouth.direction = inflow.azimuth ? Point{std::sin(*inflow.azimuth), std::cos(*inflow.azimuth)}
                                         : Point{-t.y * side, t.x * side};
        const double crossing = std::abs(t.x * mouth.direction.y - t.y * mouth.direction.x);
        if (crossing < k_least_crossing)
            throw refused("the inflow would run along its line", "inflow.direction", "",
                          "Choose a direction across the line, or remove the key");
        mouth.width *= crossing;
        mouth.map_fraction = map_fraction(scene.numerics, slopes[k], mouth.direction);
        check_ground(scene, {mouth.place.x + spacing * mouth.direction.x, mouth.place.y + spacing * mouth.direction.y});
    }
    batches_ = cut_hydrograph(inflow.hydrograph, spacing, scene.time.end);
}

InflowSource::Piece InflowSource::piece_of(const Mouth& mouth, const InflowBatch& batch) const {
    Piece piece{};
    piece.length = batch.length * mouth.map_fraction;
    piece.area = piece.length * mouth.width;
    piece.depth = batch.volume * mouth.fraction / piece.area;
    // The flow upstream of the line is not computed but exerts pressure on it: the row is given that impulse, g h^2 / 2
    // per second and metre, so that the flux of momentum is h v^2 + g h^2 / 2. Below the critical speed a flow's depth
    // is controlled from downstream, and more than one and a half times the speed would be a jet.
    piece.speed = batch.speed + 0.5 * batch.speed * std::min(1.0, gravity_ * piece.depth / (batch.speed * batch.speed));
    return piece;
}

double InflowSource::emit(ParticleSet& particles) {
    const InflowBatch& batch = batches_[next_++];
    double given = 0;
    for (const Mouth& mouth : mouths_) {
        const Piece piece = piece_of(mouth, batch);
        const double speed = piece.speed * mouth.map_fraction;
        ParticleRow row = ParticleSet::initial_row();
        get(row, Field::x) = mouth.place.x + 0.5 * piece.length * mouth.direction.x;
        get(row, Field::y) = mouth.place.y + 0.5 * piece.length * mouth.direction.y;
        get(row, Field::u) = speed * mouth.direction.x;
        get(row, Field::v) = speed * mouth.direction.y;
        get(row, Field::area) = piece.area;
        get(row, Field::volume) = batch.volume * mouth.fraction;
        given += get(row, Field::volume);
        particles.push_back(row);
    }
    return given;
}

std::vector<Point> InflowSource::places() const {
    std::vector<Point> all;
    for (const Mouth& mouth : mouths_) all.push_back(mouth.place);
    return all;
}

InflowSource::Extremes InflowSource::extremes() const {
    Extremes greatest;
    for (const InflowBatch& batch : batches_) {
        for (const Mouth& mouth : mouths_) {
            const Piece piece = piece_of(mouth, batch);
            greatest.depth = std::max(greatest.depth, piece.depth);
            greatest.speed = std::max(greatest.speed, piece.speed);
        }
    }
    return greatest;
}

Point InflowSource::midpoint() const {
    Point sum;
    for (const Mouth& mouth : mouths_) {
        sum.x += mouth.place.x * mouth.fraction;
        sum.y += mouth.place.y * mouth.fraction;
    }
    return sum;
}

Arrivals::Arrivals(const Scene& scene, std::vector<Entry> later) : later_(std::move(later)) {
    for (const Inflow& inflow : scene.inflows) sources_.emplace_back(scene, inflow);
}

double Arrivals::next_time() const {
    double time = std::numeric_limits<double>::infinity();
    if (next_entry_ < later_.size()) time = later_[next_entry_].time;
    for (const InflowSource& source : sources_) {
        if (!source.done()) time = std::min(time, source.next_time());
    }
    return time;
}

Arrivals::Arrived Arrivals::collect(double time) {
    Arrived arrived;
    for (; next_entry_ < later_.size() && later_[next_entry_].time <= time; ++next_entry_) {
        Entry& entry = later_[next_entry_];
        for (std::size_t p = 0; p < entry.particles.size(); ++p) {
            arrived.particles.push_back(entry.particles.row(p));
            arrived.failed.push_back(entry.particles.row(p));
        }
        arrived.areas.insert(arrived.areas.end(), entry.areas.begin(), entry.areas.end());
        entry.particles = ParticleSet();
    }
    for (InflowSource& source : sources_) {
        while (!source.done() && source.next_time() <= time) arrived.inflow += source.emit(arrived.particles);
    }
    return arrived;
}

std::size_t Arrivals::particles_left() const {
    std::size_t count = 0;
    for (std::size_t i = next_entry_; i < later_.size(); ++i) count += later_[i].particles.size();
    for (const InflowSource& source : sources_) count += source.particles_left();
    return count;
}

namespace {

constexpr double k_least_volume = 0.01;  // of the greatest release

struct Group {
    double volume = 0, x = 0, y = 0;  // sums over its cells
};

std::vector<Group> groups_of(const Raster& depth) {
    const SeparateFlows releases(depth, depth);
    std::vector<Group> groups(releases.count());
    const GridSpec& grid = depth.grid;
    depth.values.for_each_stored([&](std::size_t cell, double metres) {
        if (!(metres > 0)) return;
        const auto n = static_cast<std::int64_t>(cell);
        const Point at = grid.local_from_map(grid.cell_centre(n / grid.columns, n % grid.columns));
        Group& group = groups[releases.flow_of(cell)];
        group.volume += metres;
        group.x += metres * at.x;
        group.y += metres * at.y;
    });
    return groups;
}

}  // namespace

FrontOrigins::FrontOrigins(const Release& release, const Arrivals& arrivals) {
    if (release.volume > 0) {
        const std::vector<Group> groups = groups_of(release.depth);
        double greatest = 0;
        for (const Group& group : groups) greatest = std::max(greatest, group.volume);
        for (const Group& group : groups)
            if (group.volume >= k_least_volume * greatest)
                places_.push_back({group.x / group.volume, group.y / group.volume});
        // The particles' own, where there is one.
        if (places_.size() == 1) places_.front() = release.centroid;
    }
    for (const InflowSource& source : arrivals.sources()) places_.push_back(source.midpoint());
    std::stable_sort(places_.begin(), places_.end(), [](Point a, Point b) { return a.x < b.x; });
}

double FrontOrigins::squared_distance(Point place) const noexcept {
    const auto squared = [&](Point origin) {
        const double x = place.x - origin.x, y = place.y - origin.y;
        return x * x + y * y;
    };
    if (single()) return squared(places_.front());
    const auto too_far = [&](Point origin, double least) {
        const double x = place.x - origin.x;
        return x * x > least;
    };
    auto right =
        std::lower_bound(places_.begin(), places_.end(), place.x, [](Point origin, double x) { return origin.x < x; });
    auto left = right;
    double least = HUGE_VAL;
    for (; right != places_.end() && !too_far(*right, least); ++right) least = std::min(least, squared(*right));
    for (; left != places_.begin() && !too_far(*std::prev(left), least); --left)
        least = std::min(least, squared(*std::prev(left)));
    return least;
}

}  // namespace frana
