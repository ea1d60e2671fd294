// SPDX-License-Identifier: Apache-2.0
#include "models/finite_volume/step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/finite_volume/jumps.h"
#include "models/finite_volume/sweeps.h"
#include "mpm/curvature.h"
#include "mpm/ground_slope.h"

namespace frana::finite_volume {
namespace {

constexpr std::int64_t k_reach = 3;  // cells beside moving ones that a step may set free or reach

// Reads the bed with what lies on it.
void read_bed(State& s, const Laws& laws, const NodeRange& range) {
    const NodeGrid& nodes = s.nodes;
    range.for_each(nodes.stride(), [&](std::size_t k, std::int64_t i, std::int64_t j) {
        const bool wall =
            nodes.is_wall(k) || (laws.gap_is_wall && nodes.is_gap(k)) || (laws.wall && nodes.is_ghost(i, j));
        s.bed[k] = nodes.bed[k] + (wall ? k_wall_height : 0) + (s.lying != nullptr ? s.lying[k] : 0);
    });
}

// Reads what follows from the ground.
void read_ground(State& s, const Laws& laws, const NodeRange& range) {
    const NodeGrid& nodes = s.nodes;
    nodes.cover({range.i0 - 1, range.i1 + 1, range.j0 - 1, range.j1 + 1});
    read_bed(s, laws, range);
    range.for_each(nodes.stride(), [&](std::size_t k, std::int64_t i, std::int64_t j) {
        const auto corner = [&](bool inside, std::int64_t next) {
            return inside ? corner_at(nodes, k, next) : Corner{0, 1};
        };
        const Corner x = corner(i > 0 && i < nodes.stride() - 1, 1),
                     y = corner(j > 0 && j < nodes.padded_rows() - 1, nodes.stride());
        const Point slope = laws.along_bed ? Point{x.slope, y.slope} : Point{};
        s.slope_x[k] = slope.x;
        s.slope_y[k] = slope.y;
        const double n = 1 + slope.x * slope.x + slope.y * slope.y;
        s.root[k] = std::sqrt(n);
        if (!laws.curved) return;
        const double turned = std::min({1.0, n * x.turn, n * y.turn});
        const BedCurvature curvature = bed_curvature(nodes, k, i, j);
        s.curvature_xx[k] = turned * curvature.xx;
        s.curvature_xy[k] = turned * curvature.xy;
        s.curvature_yy[k] = turned * curvature.yy;
    });
}

// Calls visit for the tiles within `reach` cells of a region.
template <class Visit>
void for_tiles_round(const State& s, const Region& r, std::int64_t reach, const Visit& visit) {
    const auto from = [&](std::int64_t k) { return std::max<std::int64_t>(k - reach, 0); };
    const std::int64_t last_i = std::min(r.i1 + reach, s.nodes.stride()) - 1,
                       last_j = std::min(r.j1 + reach, s.nodes.padded_rows()) - 1;
    const std::int64_t first = s.tile_of(from(r.i0), from(r.j0)), last = s.tile_of(last_i, last_j),
                       across = s.tiles.tiles_x();
    for (std::int64_t b = first / across; b <= last / across; ++b)
        for (std::int64_t a = first % across; a <= last % across; ++a) visit(b * across + a);
}

bool may_rest(const Laws& laws) {
    return laws.friction.keeps_rest() && !laws.exchange.at_nodes && !laws.friction.pore_pressure.active();
}

// Surveys a tile: what is in it and where something may move. What friction held in the last step, and was at rest
// before it, stays as it is while nothing within reach moves.
TileRecord survey(const State& s, const Laws& laws, std::int64_t tile) {
    const NodeRange range(tile, s.tiles, s.nodes);
    const StepValues& v = laws.values;
    const bool rests = may_rest(laws);
    TileRecord r{1 << 30, 0, 1 << 30, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    range.for_each(s.nodes.stride(), [&](std::size_t k, std::int64_t i, std::int64_t j) {
        const double h = s.depth[k];
        if (h == 0) return;
        ++r.wet;
        r.depth += h;
        r.deepest = std::max(r.deepest, h);
        if (h < v.minimum_depth) {
            r.thin += h;
        } else {
            ++r.covered;
        }
        // The pressure of the flow is g' h^2 / 2; before the first step as that of a flow along the bed.
        const double along = v.gravity / (s.root[k] * s.root[k]), weight = s.weight[k] > 0 ? s.weight[k] : along,
                     half = 0.5 * h * h, kinetic = 0.5 * (s.qx[k] * s.qx[k] + s.qy[k] * s.qy[k]) / h;
        r.kinetic += kinetic;
        r.energy += kinetic + v.gravity * h * s.nodes.bed[k] + half * weight;
        r.levelled += half * (weight - along);
        r.sloping += half * (v.gravity - weight);
        if (h <= v.dry || (rests && s.held[k] > 0.5 && s.start[k] == 0)) return;
        r.i0 = std::min(r.i0, static_cast<std::int32_t>(i));
        r.i1 = std::max(r.i1, static_cast<std::int32_t>(i + 1));
        r.j0 = std::min(r.j0, static_cast<std::int32_t>(j));
        r.j1 = std::max(r.j1, static_cast<std::int32_t>(j + 1));
    });
    return r;
}

// The regions of adjacent tiles within `reach` cells of what may move, none of which overlap, by rows of tiles.
std::vector<Region> regions_within(std::int64_t reach, const State& s) {
    struct Part {
        std::int64_t tile;
        Region region;
    };
    std::vector<Part> parts;
    const std::int64_t across = s.tiles.tiles_x(), down = s.tiles.tiles_y();
    for (const std::int64_t tile : s.wet) {
        const TileRecord& r = s.records[static_cast<std::size_t>(tile)];
        if (r.i1 == 0) continue;
        const std::int64_t a = tile % across, b = tile / across;
        for (std::int64_t y = std::max<std::int64_t>(b - 1, 0); y <= std::min(b + 1, down - 1); ++y)
            for (std::int64_t x = std::max<std::int64_t>(a - 1, 0); x <= std::min(a + 1, across - 1); ++x) {
                const NodeRange near(y * across + x, s.tiles, s.nodes);
                // Whole groups of four cells: the kernels take four at a time.
                const std::int64_t first = near.i0 + (std::max(r.i0 - reach - near.i0, std::int64_t{0}) & ~3),
                                   last = near.i0 + ((r.i1 + reach - near.i0 + 3) & ~3);
                const Region part{std::max(first, k_ghost), std::min({near.i1, last, s.nodes.stride() - k_ghost}),
                                  std::max({near.j0, r.j0 - reach, k_ghost}),
                                  std::min({near.j1, r.j1 + reach, s.nodes.padded_rows() - k_ghost})};
                if (part.i0 < part.i1 && part.j0 < part.j1) parts.push_back({y * across + x, part});
            }
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.tile < b.tile; });
    std::vector<Region> regions;
    std::int64_t last = -2;
    for (const Part& part : parts) {
        const bool joins =
            !regions.empty() && (part.tile == last || (part.tile == last + 1 && part.tile % across != 0));
        if (!joins) regions.push_back(part.region);
        Region& region = regions.back();
        region = {std::min(region.i0, part.region.i0), std::max(region.i1, part.region.i1),
                  std::min(region.j0, part.region.j0), std::max(region.j1, part.region.j1)};
        last = part.tile;
    }
    return regions;
}

void choose_strips(State& s, const Laws& laws, ThreadPool& pool) {
    const std::vector<Region> regions = regions_within(k_reach, s);
    if (s.strips.size() < regions.size()) s.strips.resize(regions.size());
    s.n_strips = regions.size();
    for (std::size_t n = 0; n < regions.size(); ++n) s.strips[n].region = regions[n];
    s.prepared = regions_within(k_reach + 1, s);
    for (const Region& region : s.prepared) require_ground(s, laws, region);
    if (s.lying == nullptr) return;
    std::vector<std::int64_t> tiles;  // all that the sweeps read
    for (const Region& r : s.prepared) for_tiles_round(s, r, 1, [&](std::int64_t tile) { tiles.push_back(tile); });
    make_ascending(tiles);
    pool.for_each(tiles.size(), [&](std::size_t n) { read_bed(s, laws, NodeRange(tiles[n], s.tiles, s.nodes)); });
}

double greatest(const double* lanes) {
    return std::max(std::max(lanes[0], lanes[1]), std::max(lanes[2], lanes[3]));
}
double sum(const double* lanes) {
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

// Surveys what was computed and adds it up.
StepReport account(State& s, const Laws& laws, ThreadPool& pool) {
    StepReport report;
    const double area = s.cell_area();
    s.wave = s.momentum = 0;
    std::vector<std::int64_t> computed;
    for (std::size_t n = 0; n < s.n_strips; ++n) {
        Strip& strip = s.strips[n];
        const StripTotals& t = strip.totals;
        report.max_speed = std::max(report.max_speed, greatest(t.max_speed));
        s.wave = std::max(s.wave, greatest(t.wave));
        s.momentum += area * sum(t.momentum);
        report.dissipated += area * sum(t.dissipated);
        report.moving += area * sum(t.moving);
        report.unsupported += static_cast<std::int64_t>(sum(t.unsupported));
        report.not_finite += static_cast<std::int64_t>(sum(t.not_finite));
        s.volume_left += area * strip.left;
        strip.left = 0;
        const std::int64_t first = s.tile_of(strip.region.i0, strip.region.j0),
                           last = s.tile_of(strip.region.i1 - 1, strip.region.j0);
        for (std::int64_t tile = first; tile <= last; ++tile) computed.push_back(tile);
    }
    pool.for_each(computed.size(), [&](std::size_t n) {
        s.records[static_cast<std::size_t>(computed[n])] = survey(s, laws, computed[n]);
    });
    for (std::size_t n = 0; s.nodes.any_solid() && n < computed.size(); ++n)
        NodeRange(computed[n], s.tiles, s.nodes)
            .for_each(s.nodes.stride(), [&](std::size_t k, std::int64_t, std::int64_t) {
                report.no_data += s.depth[k] > 0 && s.nodes.is_gap(k) ? 1 : 0;
            });
    computed.insert(computed.end(), s.wet.begin(), s.wet.end());
    make_ascending(computed);
    std::erase_if(computed, [&](std::int64_t tile) { return s.records[static_cast<std::size_t>(tile)].wet == 0; });
    s.wet = std::move(computed);
    return report;
}

}  // namespace

void require_ground(State& s, const Laws& laws, const Region& r) {
    for_tiles_round(s, r, k_reach, [&](std::int64_t tile) {
        std::uint8_t& ready = s.ready[static_cast<std::size_t>(tile)];
        if (ready == 0) read_ground(s, laws, NodeRange(tile, s.tiles, s.nodes));
        ready = 1;
    });
}

State::State(NodeGrid& grid) : nodes(grid), tiles(tiles_on(grid)), edges(nodes.size()) {
    for (ZeroArray<double>* array :
         {&depth,        &qx,           &qy,           &bed,    &slope_x,  &slope_y,  &root,
          &curvature_xx, &curvature_xy, &curvature_yy, &weight, &slowed_x, &slowed_y, &pull_x,
          &pull_y,       &bound,        &spare,        &held,   &head,     &start,    &before})
        *array = ZeroArray<double>(nodes.size() + 8);
    const auto count = static_cast<std::size_t>(tiles.tiles_x() * tiles.tiles_y());
    records = ZeroArray<TileRecord>(count);
    ready = ZeroArray<std::uint8_t>(count);
}

Cells State::cells(Maxima* maxima) {
    // Without maxima those go where a step no longer reads: the predictor is past.
    ZeroArray<double>&max_depth = maxima != nullptr ? maxima->depth : slowed_x,
    &max_speed = maxima != nullptr ? maxima->speed : slowed_y,
    &arrival = maxima != nullptr ? maxima->arrival_plus_1 : spare;
    return {depth.data(),   qx.data(),        qy.data(),           bed.data(),          slope_x.data(),
            slope_y.data(), root.data(),      curvature_xx.data(), curvature_xy.data(), curvature_yy.data(),
            weight.data(),  slowed_x.data(),  slowed_y.data(),     pull_x.data(),       pull_y.data(),
            bound.data(),   spare.data(),     held.data(),         head.data(),         start.data(),
            before.data(),  max_depth.data(), max_speed.data(),    arrival.data(),      nodes.stride()};
}

double stable_step(const State& s, const Laws& laws) {
    const double dx = laws.values.cell_size, reach = laws.cfl * dx;
    double dt = 2 * reach / (s.wave + std::sqrt(s.wave * s.wave + 4 * laws.values.gravity * reach));
    if (s.diffusivity > 0) dt = std::min(dt, 0.25 * dx * dx / s.diffusivity);
    return dt;
}

StepReport step(State& s, const Laws& laws, double limit, Maxima* maxima, ThreadPool& pool) {
    StepValues values = laws.values;
    choose_strips(s, laws, pool);
    Sweeps sweeps(s, laws, values, maxima, pool);
    sweeps.strain();
    values.dt = std::min(limit, stable_step(s, laws));
    values.time = s.time + values.dt;
    sweeps.prepare();
    if (laws.friction.keeps_rest()) {
        sweeps.hold();
    } else {
        sweeps.release();
    }
    sweeps.push();
    if (s.steps % 2 == 0) {
        sweeps.along_x();
        sweeps.along_y();
    } else {
        sweeps.along_y();
        sweeps.along_x();
    }
    sweeps.finish();
    sweeps.exchange();
    StepReport report = account(s, laws, pool);
    report.dt = values.dt;
    s.time = values.time;
    ++s.steps;
    find_jumps(s, laws, values.dt, pool);
    return report;
}

std::int64_t add_to_cell(State& s, const Laws& laws, std::int64_t i, std::int64_t j, double depth, Point velocity,
                         const PorePressure::State& pores) {
    require_ground(s, laws, {i, i + 1, j, j + 1});
    const auto k = static_cast<std::size_t>(j * s.nodes.stride() + i);
    const Point w = BedFrame{s.slope_x[k], s.slope_y[k], s.root[k]}.along_bed(velocity.x, velocity.y);
    s.set_pores(k, depth, pores, true);
    s.depth[k] += depth;
    s.qx[k] += depth * w.x;
    s.qy[k] += depth * w.y;
    return s.tile_of(i, j);
}

void settle(State& s, const Laws& laws, std::vector<std::int64_t> tiles, ThreadPool* pool) {
    make_ascending(tiles);
    s.wet.insert(s.wet.end(), tiles.begin(), tiles.end());
    make_ascending(s.wet);
    const double dry = laws.values.dry;
    std::vector<double> fastest(tiles.size(), s.wave);
    const auto settle_one = [&](std::size_t n) {
        const std::int64_t tile = tiles[n];
        NodeRange(tile, s.tiles, s.nodes).for_each(s.nodes.stride(), [&](std::size_t k, std::int64_t, std::int64_t) {
            s.held[k] = 0;
            if (!(s.depth[k] > dry)) return;
            const CellMotion motion = motion_of(s, laws, k);
            const double wave = std::max(std::abs(motion.u), std::abs(motion.v)) +
                                std::sqrt(laws.values.wave_factor * laws.values.gravity * s.depth[k]);
            fastest[n] = std::max(fastest[n], std::isnan(wave) ? std::numeric_limits<double>::infinity() : wave);
        });
        s.records[static_cast<std::size_t>(tile)] = survey(s, laws, tile);
    };
    if (pool != nullptr) {
        pool->for_each(tiles.size(), settle_one);
    } else {
        for (std::size_t n = 0; n < tiles.size(); ++n) settle_one(n);
    }
    for (const double wave : fastest) s.wave = std::max(s.wave, wave);
}

void renew_ground(State& s, const Laws& laws) {
    s.ready = ZeroArray<std::uint8_t>(s.ready.size());
    for (const std::int64_t tile : s.wet) {
        const NodeRange range(tile, s.tiles, s.nodes);
        require_ground(s, laws, {range.i0, range.i1, range.j0, range.j1});
    }
}

CellMotion motion_of(const State& s, const Laws& laws, std::size_t k) {
    if (!(s.depth[k] > laws.values.dry)) return {};
    const double wx = s.qx[k] / s.depth[k], wy = s.qy[k] / s.depth[k];
    const Point u = BedFrame{s.slope_x[k], s.slope_y[k], s.root[k]}.in_map(wx, wy);
    return {u.x, u.y, std::hypot(wx, wy)};
}

}  // namespace frana::finite_volume
