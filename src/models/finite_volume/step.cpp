// SPDX-License-Identifier: Apache-2.0
#include "models/finite_volume/step.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "mpm/curvature.h"

namespace frana::finite_volume {
namespace {

constexpr std::int64_t k_reach = 2;  // cells that a step of two sweeps reads on either side

// Reads what follows from the ground.
void read_ground(State& s, const Laws& laws, const NodeRange& range) {
    const NodeGrid& nodes = s.nodes;
    nodes.cover({range.i0 - 1, range.i1 + 1, range.j0 - 1, range.j1 + 1});
    range.for_each(nodes.stride(), [&](std::size_t k, std::int64_t i, std::int64_t j) {
        const bool wall = nodes.is_wall(k) || (laws.wall && nodes.is_ghost(i, j));
        s.bed[k] = nodes.bed[k] + (wall ? k_wall_height : 0);
        const Point slope = laws.along_bed ? node_slope(nodes, k, i, j) : Point{};
        s.slope_x[k] = slope.x;
        s.slope_y[k] = slope.y;
        s.root[k] = std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
        if (!laws.curved) return;
        const BedCurvature curvature = bed_curvature(nodes, k, i, j);
        s.curvature_xx[k] = curvature.xx;
        s.curvature_xy[k] = curvature.xy;
        s.curvature_yy[k] = curvature.yy;
    });
}

// Reads it where the sweeps over these cells need it.
void require_ground(State& s, const Laws& laws, const Region& r) {
    const auto from = [](std::int64_t k) { return std::max<std::int64_t>(k - k_reach, 0); };
    const std::int64_t last_i = std::min(r.i1 + k_reach, s.nodes.stride()) - 1,
                       last_j = std::min(r.j1 + k_reach, s.nodes.padded_rows()) - 1;
    const std::int64_t first = s.tile_of(from(r.i0), from(r.j0)), last = s.tile_of(last_i, last_j),
                       across = s.tiles.tiles_x();
    for (std::int64_t b = first / across; b <= last / across; ++b)
        for (std::int64_t a = first % across; a <= last % across; ++a) {
            std::uint8_t& ready = s.ready[static_cast<std::size_t>(b * across + a)];
            if (ready == 0) read_ground(s, laws, NodeRange(b * across + a, s.tiles, s.nodes));
            ready = 1;
        }
}

bool may_rest(const Laws& laws) {
    return laws.friction.keeps_rest() && laws.exchange_at_nodes == nullptr;
}

// Surveys a tile: what is in it and where something may move. What friction held in the last step, and was at rest
// before it, stays as it is while nothing within reach moves.
TileRecord survey(const State& s, const Laws& laws, std::int64_t tile) {
    const NodeRange range(tile, s.tiles, s.nodes);
    const StepValues& v = laws.values;
    const bool rests = may_rest(laws);
    TileRecord r{1 << 30, 0, 1 << 30, 0, 0, 0, 0, 0, 0};
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
                const Region part{std::max({near.i0, r.i0 - reach, k_ghost}),
                                  std::min({near.i1, r.i1 + reach, s.nodes.stride() - k_ghost}),
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

void choose_strips(State& s, const Laws& laws) {
    const std::vector<Region> regions = regions_within(k_reach, s);
    if (s.strips.size() < regions.size()) s.strips.resize(regions.size());
    s.n_strips = regions.size();
    for (std::size_t n = 0; n < regions.size(); ++n) s.strips[n].region = regions[n];
    s.prepared = regions_within(k_reach + 1, s);
    for (const Region& region : s.prepared) require_ground(s, laws, region);
}

// The arrays of a strip's sweep, in its workspace.
class Workspace {
  public:
    Workspace(Strip& strip, std::int64_t width) : width_(static_cast<std::size_t>(width) + 8) {
        const std::size_t arrays = 5 * CellRow::k_arrays + 2 * FaceRow::k_arrays + 12;
        if (strip.work.size() < arrays * width_) strip.work.resize(arrays * width_);
        next_ = strip.work.data();
        for (CellRow& row : rows)
            for (double** array :
                 {&row.depth, &row.speed, &row.normal, &row.tangential, &row.weight, &row.drive, &row.bed, &row.closed})
                *array = take();
        for (FaceRow& row : faces)
            for (double** array : {&row.mass, &row.normal, &row.tangential, &row.pressure_below, &row.pressure_above,
                                   &row.step_below, &row.step_above})
                *array = take();
        for (auto& row : beyond)
            for (double*& array : row) array = take();
    }
    CellRow rows[5];
    FaceRow faces[2];
    double* beyond[4][3];  // depth, qx, qy of the two rows before and after the strip

  private:
    double* take() { return std::exchange(next_, next_ + width_); }
    std::size_t width_;
    double* next_;
};

CellRow moved(const CellRow& row, std::ptrdiff_t by) {
    return {row.depth + by,  row.speed + by, row.normal + by, row.tangential + by,
            row.weight + by, row.drive + by, row.bed + by,    row.closed + by};
}
FaceRow moved(const FaceRow& row, std::ptrdiff_t by) {
    return {row.mass + by,           row.normal + by,     row.tangential + by, row.pressure_below + by,
            row.pressure_above + by, row.step_below + by, row.step_above + by};
}

class Sweeps {
  public:
    Sweeps(State& state, const Laws& laws, const StepValues& values, Maxima& maxima, ThreadPool& pool)
        : s_(state), laws_(laws), v_(values), c_(state.cells(maxima)), pool_(pool) {}

    void prepare() {
        const voellmy_bingham::BedFriction& friction = laws_.friction;
        if (!friction.summed) {
            for_prepared_rows([&](std::size_t first, std::size_t count) {
                kernels_.prepare(c_, first, count, v_, UniformFriction{friction.voellmy});
            });
            return;
        }
        BedState* const states = s_.bed_states.data();
        pool_.for_each(s_.prepared.size(), [&](std::size_t n) { fill_bed_states(s_.prepared[n]); });
        for_prepared_rows([&](std::size_t first, std::size_t count) {
            if (std::holds_alternative<NoExcess>(friction.excess)) {
                kernels_.prepare_summed(c_, first, count, v_, {NoExcess{}, states, friction.yields});
            } else {
                prepare_excess(c_, first, count, v_, friction.excess, states);
            }
        });
    }
    void hold() {
        for_rows([&](Strip&, std::size_t first, std::size_t count) { kernels_.hold(c_, first, count, v_); });
    }
    void release() {
        for_rows([&](Strip&, std::size_t first, std::size_t count) { std::fill_n(c_.held + first, count, 0.0); });
    }
    void along_x() {
        for_strips([&](Strip& strip) {
            const std::int64_t width = strip.region.i1 - strip.region.i0;
            Workspace work(strip, width + 4);
            const CellRow row = moved(work.rows[0], 1);
            const auto count = static_cast<std::size_t>(width);
            for (std::int64_t j = strip.region.j0; j < strip.region.j1; ++j) {
                const std::size_t first = index(strip.region.i0, j), before = first - 2;
                kernels_.read_row(c_, before, count + 4, c_.depth + before, c_.qx + before, c_.qy + before, false,
                                  v_.dry, work.rows[0]);
                kernels_.faces(moved(row, -1), row, moved(row, 1), moved(row, 2), count + 1, v_, work.faces[0]);
                kernels_.update(c_, first, count, false, v_, work.faces[0], moved(work.faces[0], 1));
                const double rate = v_.dt / v_.cell_size;
                if (strip.region.i0 == k_ghost) strip.left -= rate * work.faces[0].mass[0];
                if (strip.region.i1 == s_.nodes.stride() - k_ghost) strip.left += rate * work.faces[0].mass[count];
            }
        });
    }
    void along_y() {
        // What lies beyond the strips, before any of them changes.
        for_strips([&](Strip& strip) {
            Workspace work(strip, strip.region.i1 - strip.region.i0 + 4);
            const auto count = strip.region.i1 - strip.region.i0;
            for (int q = 0; q < 4; ++q) {
                const std::size_t from =
                    index(strip.region.i0, q < 2 ? strip.region.j0 - 2 + q : strip.region.j1 + q - 2);
                std::copy_n(c_.depth + from, count, work.beyond[q][0]);
                std::copy_n(c_.qx + from, count, work.beyond[q][1]);
                std::copy_n(c_.qy + from, count, work.beyond[q][2]);
            }
        });
        for_strips([&](Strip& strip) { sweep_along_y(strip); });
    }
    void finish() {
        const voellmy_bingham::BedFriction& friction = laws_.friction;
        BedState* const states = s_.bed_states.data();
        for_strips([&](Strip& strip) {
            strip.totals = {};
            if (friction.summed) fill_bed_states(strip.region);  // of what has just been reached, too
        });
        for_rows([&](Strip& strip, std::size_t first, std::size_t count) {
            if (!friction.summed) {
                kernels_.finish(c_, first, count, v_, UniformFriction{friction.voellmy}, strip.totals);
            } else if (std::holds_alternative<NoExcess>(friction.excess)) {
                kernels_.finish_summed(c_, first, count, v_, {NoExcess{}, states, friction.yields}, strip.totals);
            } else {
                finish_excess(c_, first, count, v_, friction.excess, states, strip.totals);
            }
        });
    }
    // The force of the in-plane stress, and its bound of the step.
    void strain() {
        if (std::holds_alternative<NoStress>(laws_.stress.law)) return;
        for_strips(
            [&](Strip& strip) { std::visit([&](const auto& law) { strain_strip(law, strip); }, laws_.stress.law); });
        s_.diffusivity = 0;
        for (std::size_t n = 0; n < s_.n_strips; ++n)
            s_.diffusivity = std::max(s_.diffusivity, s_.strips[n].diffusivity);
    }
    // The change of momentum by it.
    void push() {
        if (std::holds_alternative<NoStress>(laws_.stress.law)) return;
        for_rows([&](Strip&, std::size_t first, std::size_t count) {
            for (std::size_t k = first; k < first + count; ++k) {
                const double fx = v_.dt * s_.force_x[k], fy = v_.dt * s_.force_y[k];
                const Point w = BedFrame{c_.slope_x[k], c_.slope_y[k], c_.root[k]}.along_bed(fx, fy);
                c_.qx[k] += w.x;
                c_.qy[k] += w.y;
            }
        });
    }
    // Erosion and deposition: eroded material is at rest, deposited material leaves with its momentum.
    void exchange() {
        if (laws_.exchange_at_nodes == nullptr) return;
        std::vector<ExchangeReport> reports(s_.n_strips);
        pool_.for_each(s_.n_strips, [&](std::size_t n) {
            const Region& r = s_.strips[n].region;
            const NodeRange range(r.i0, r.i1, r.j0, r.j1);
            range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
                const CellMotion motion = motion_of(s_, laws_, k);
                const double mass = c_.depth[k] > v_.dry ? c_.depth[k] * s_.cell_area() : 0;
                s_.nodes.records[k].motion = {motion.u, motion.v, 0, 0, mass, 1, 0, 0};
            });
            laws_.exchange_at_nodes(range, laws_.exchange, v_.dt, 2 * v_.dry, s_.bed_states.data(), s_.nodes,
                                    s_.erodible_beds.data());
            range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
                const double change = s_.erodible_beds[k].change;
                if (change != 0) move_bed(k, change, reports[n]);
            });
        });
        for (const ExchangeReport& report : reports) s_.exchanged.merge(report);
        for_strips([&](Strip& strip) {
            const Region& r = strip.region;
            read_ground(s_, laws_, NodeRange(r.i0, r.i1, r.j0, r.j1));
        });
    }
    template <class Task>
    void for_strips(const Task& task) {
        pool_.for_each(s_.n_strips, [&](std::size_t n) { task(s_.strips[n]); });
    }
    template <class Task>
    void for_rows(const Task& task) {
        for_strips([&](Strip& strip) {
            for (std::int64_t j = strip.region.j0; j < strip.region.j1; ++j)
                task(strip, index(strip.region.i0, j), static_cast<std::size_t>(strip.region.i1 - strip.region.i0));
        });
    }

  private:
    template <class Task>
    void for_prepared_rows(const Task& task) {
        pool_.for_each(s_.prepared.size(), [&](std::size_t n) {
            const Region& r = s_.prepared[n];
            for (std::int64_t j = r.j0; j < r.j1; ++j) task(index(r.i0, j), static_cast<std::size_t>(r.i1 - r.i0));
        });
    }
    // The states of the bed at the beginning of the step, and every law's part.
    void fill_bed_states(const Region& r) {
        const NodeRange range(r.i0, r.i1, r.j0, r.j1);
        range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
            const double h = c_.depth[k];
            const bool wet = h > v_.dry;
            s_.nodes.records[k].sums.mass = wet ? h * s_.cell_area() : 0;
            if (!wet) return;
            const Point u = BedFrame{c_.slope_x[k], c_.slope_y[k], c_.root[k]}.in_map(c_.qx[k] / h, c_.qy[k] / h);
            const BedCurvature curvature{c_.curvature_xx[k], c_.curvature_xy[k], c_.curvature_yy[k]};
            const double supported = v_.gravity + std::max(-v_.gravity, curvature.load(u.x, u.y));
            s_.bed_states[k] = {h / c_.root[k], supported / c_.root[k], 0, 0, 0, 0, 0};
        });
        for (const auto& sweep : laws_.friction.sweeps) sweep(range, s_.nodes, s_.bed_states.data());
    }
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j) const {
        return static_cast<std::size_t>(j * c_.stride + i);
    }
    void move_bed(std::size_t k, double change, ExchangeReport& report) {
        const double area = s_.cell_area(), kept = change > 0 ? 1 - change / c_.depth[k] : 1;
        if (change > 0) {
            const CellMotion motion = motion_of(s_, laws_, k);
            report.deposited += change * area;
            report.momentum_x += change * area * motion.u;
            report.momentum_y += change * area * motion.v;
        } else {
            report.eroded -= change * area;
        }
        c_.depth[k] -= change;
        c_.qx[k] *= kept;
        c_.qy[k] *= kept;
        s_.nodes.bed[k] += change;
    }
    // Depth and velocity in map view of a row and the cells before and after it.
    void read_motion(const Strip& strip, std::int64_t j, const CellRow& row) const {
        for (std::int64_t i = strip.region.i0 - 1; i <= strip.region.i1; ++i) {
            const std::size_t k = index(i, j);
            const auto q = static_cast<std::size_t>(i - strip.region.i0 + 1);
            const CellMotion motion = motion_of(s_, laws_, k);
            row.depth[q] = c_.depth[k] > v_.dry ? c_.depth[k] : 0;
            row.speed[q] = motion.u;
            row.normal[q] = motion.v;
        }
    }
    // The force of the divergence of h sigma, from the stress at the faces between wet cells.
    template <class Law>
    void strain_strip(const Law& law, Strip& strip) {
        Workspace work(strip, strip.region.i1 - strip.region.i0 + 4);
        const auto count = static_cast<std::size_t>(strip.region.i1 - strip.region.i0);
        const CellRow *south = &work.rows[0], *here = &work.rows[1], *north = &work.rows[2];
        FaceRow lower = work.faces[0], upper = work.faces[1];
        double* const across_x = work.rows[3].depth;  // h sigma_xx and h sigma_xy at the faces of a row
        double* const along_x = work.rows[3].speed;
        strip.diffusivity = 0;
        const double inverse_dx = 1 / v_.cell_size;
        // The velocity of a cell, or of the one beside it where there is no flow.
        const auto of = [](const CellRow& row, double* CellRow::*component, std::size_t q, const CellRow& instead,
                           std::size_t p) { return row.depth[q] > 0 ? (row.*component)[q] : (instead.*component)[p]; };
        const auto stress = [&](const CellRow& b, std::size_t p, const CellRow& c, std::size_t q, double u_x,
                                double v_x, double u_y, double v_y) -> PlaneStress<double> {
            const double depth = std::min(b.depth[p], c.depth[q]);  // the mean would push thin edges too hard
            if (!(depth > 0)) return {0, 0, 0, 0};
            PlaneStress<double> s{0, 0, 0, 0};
            if constexpr (Law::active)
                s = law(StrainRate<double>{u_x, 0.5 * (u_y + v_x), v_y, 0.5 * (b.speed[p] + c.speed[q]),
                                           0.5 * (b.normal[p] + c.normal[q]), depth});
            strip.diffusivity = std::max(strip.diffusivity, s.diffusivity);
            return {depth * s.xx, depth * s.xy, depth * s.yy, 0};
        };
        const auto faces_in_y = [&](const CellRow& b, const CellRow& c, const FaceRow& to) {
            for (std::size_t q = 1; q <= count; ++q) {
                const auto gradient = [&](double* CellRow::*component) {
                    return 0.25 * inverse_dx *
                           (of(b, component, q + 1, b, q) - of(b, component, q - 1, b, q) +
                            of(c, component, q + 1, c, q) - of(c, component, q - 1, c, q));
                };
                const PlaneStress<double> s =
                    stress(b, q, c, q, gradient(&CellRow::speed), gradient(&CellRow::normal),
                           (c.speed[q] - b.speed[q]) * inverse_dx, (c.normal[q] - b.normal[q]) * inverse_dx);
                to.mass[q] = s.xy;
                to.normal[q] = s.yy;
            }
        };
        read_motion(strip, strip.region.j0 - 1, *south);
        read_motion(strip, strip.region.j0, *here);
        faces_in_y(*south, *here, lower);
        for (std::int64_t j = strip.region.j0; j < strip.region.j1; ++j) {
            read_motion(strip, j + 1, *north);
            faces_in_y(*here, *north, upper);
            for (std::size_t q = 0; q <= count; ++q) {
                const auto gradient = [&](double* CellRow::*component) {
                    return 0.25 * inverse_dx *
                           (of(*north, component, q, *here, q) - of(*south, component, q, *here, q) +
                            of(*north, component, q + 1, *here, q + 1) - of(*south, component, q + 1, *here, q + 1));
                };
                const PlaneStress<double> s =
                    stress(*here, q, *here, q + 1, (here->speed[q + 1] - here->speed[q]) * inverse_dx,
                           (here->normal[q + 1] - here->normal[q]) * inverse_dx, gradient(&CellRow::speed),
                           gradient(&CellRow::normal));
                across_x[q] = s.xx;
                along_x[q] = s.xy;
            }
            for (std::size_t q = 1; q <= count; ++q) {
                const std::size_t k = index(strip.region.i0, j) + q - 1;
                s_.force_x[k] = (across_x[q] - across_x[q - 1] + upper.mass[q] - lower.mass[q]) * inverse_dx;
                s_.force_y[k] = (along_x[q] - along_x[q - 1] + upper.normal[q] - lower.normal[q]) * inverse_dx;
            }
            std::swap(lower, upper);
            const CellRow* const last = south;
            south = here;
            here = north;
            north = last;
        }
    }
    void sweep_along_y(Strip& strip) {
        Workspace work(strip, strip.region.i1 - strip.region.i0 + 4);
        const auto count = static_cast<std::size_t>(strip.region.i1 - strip.region.i0);
        const auto read = [&](std::int64_t j, const CellRow& row) {
            const std::size_t first = index(strip.region.i0, j);
            if (j >= strip.region.j0 && j < strip.region.j1) {
                kernels_.read_row(c_, first, count, c_.depth + first, c_.qx + first, c_.qy + first, true, v_.dry, row);
            } else {
                double* const* const copy =
                    work.beyond[j < strip.region.j0 ? j - strip.region.j0 + 2 : j - strip.region.j1 + 2];
                kernels_.read_row(c_, first, count, copy[0], copy[1], copy[2], true, v_.dry, row);
            }
        };
        const auto row = [&](std::int64_t j) -> const CellRow& { return work.rows[(j - strip.region.j0 + 5) % 5]; };
        const auto faces = [&](std::int64_t j, const FaceRow& to) {
            kernels_.faces(row(j - 2), row(j - 1), row(j), row(j + 1), count, v_, to);
        };
        for (std::int64_t j = strip.region.j0 - 2; j < strip.region.j0 + 2; ++j) read(j, row(j));
        int now = 0;
        faces(strip.region.j0, work.faces[now]);
        const double rate = v_.dt / v_.cell_size;
        if (strip.region.j0 == k_ghost) strip.left -= rate * sum(work.faces[now].mass, count);
        for (std::int64_t j = strip.region.j0; j < strip.region.j1; ++j) {
            read(j + 2, row(j + 2));
            faces(j + 1, work.faces[1 - now]);
            kernels_.update(c_, index(strip.region.i0, j), count, true, v_, work.faces[now], work.faces[1 - now]);
            now = 1 - now;
        }
        if (strip.region.j1 == s_.nodes.padded_rows() - k_ghost) strip.left += rate * sum(work.faces[now].mass, count);
    }
    static double sum(const double* values, std::size_t count) {
        double total = 0;
        for (std::size_t i = 0; i < count; ++i) total += values[i];
        return total;
    }

    State& s_;
    const Laws& laws_;
    const StepValues& v_;  // the step's length is known after `strain`
    Cells c_;
    ThreadPool& pool_;
    const RowKernels& kernels_ = row_kernels();
};

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
        report.kinetic += area * sum(t.kinetic);
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
    std::sort(computed.begin(), computed.end());
    computed.erase(std::unique(computed.begin(), computed.end()), computed.end());
    std::erase_if(computed, [&](std::int64_t tile) { return s.records[static_cast<std::size_t>(tile)].wet == 0; });
    s.wet = std::move(computed);
    return report;
}

}  // namespace

State::State(NodeGrid grid)
    : nodes(std::move(grid)),
      tiles{nodes.columns(),
            nodes.rows(),
            k_ghost,
            nodes.cell_size(),
            nodes.scale().origin_x - k_ghost,
            nodes.scale().origin_y - k_ghost} {
    for (ZeroArray<double>* array :
         {&depth, &qx, &qy, &bed, &slope_x, &slope_y, &root, &curvature_xx, &curvature_xy, &curvature_yy, &weight,
          &slowed_x, &slowed_y, &pull_x, &pull_y, &bound, &held, &head, &start})
        *array = ZeroArray<double>(nodes.size() + 8);
    const auto count = static_cast<std::size_t>(tiles.tiles_x() * tiles.tiles_y());
    records = ZeroArray<TileRecord>(count);
    ready = ZeroArray<std::uint8_t>(count);
}

Cells State::cells(Maxima& maxima) {
    return {depth.data(),        qx.data(),
            qy.data(),           bed.data(),
            slope_x.data(),      slope_y.data(),
            root.data(),         curvature_xx.data(),
            curvature_xy.data(), curvature_yy.data(),
            weight.data(),       slowed_x.data(),
            slowed_y.data(),     pull_x.data(),
            pull_y.data(),       bound.data(),
            held.data(),         head.data(),
            start.data(),        maxima.depth.data(),
            maxima.speed.data(), maxima.arrival_plus_1.data(),
            nodes.stride()};
}

double stable_step(const State& s, const Laws& laws) {
    const double dx = laws.values.cell_size, reach = laws.cfl * dx;
    double dt = 2 * reach / (s.wave + std::sqrt(s.wave * s.wave + 4 * laws.values.gravity * reach));
    if (s.diffusivity > 0) dt = std::min(dt, 0.25 * dx * dx / s.diffusivity);
    return dt;
}

StepReport step(State& s, const Laws& laws, double limit, Maxima& maxima, ThreadPool& pool) {
    StepValues values = laws.values;
    choose_strips(s, laws);
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
    return report;
}

void add_to_cell(State& s, const Laws& laws, std::int64_t i, std::int64_t j, double depth, double u, double v) {
    require_ground(s, laws, {i, i + 1, j, j + 1});
    const auto k = static_cast<std::size_t>(j * s.nodes.stride() + i);
    const Point w = BedFrame{s.slope_x[k], s.slope_y[k], s.root[k]}.along_bed(u, v);
    s.depth[k] += depth;
    s.qx[k] += depth * w.x;
    s.qy[k] += depth * w.y;
    s.wet.push_back(s.tile_of(i, j));
}

void settle(State& s, const Laws& laws) {
    std::sort(s.wet.begin(), s.wet.end());
    s.wet.erase(std::unique(s.wet.begin(), s.wet.end()), s.wet.end());
    const double dry = laws.values.dry;
    for (const std::int64_t tile : s.wet) {
        NodeRange(tile, s.tiles, s.nodes).for_each(s.nodes.stride(), [&](std::size_t k, std::int64_t, std::int64_t) {
            s.held[k] = 0;
            if (!(s.depth[k] > dry)) return;
            const CellMotion motion = motion_of(s, laws, k);
            s.wave = std::max(s.wave, std::max(std::abs(motion.u), std::abs(motion.v)) +
                                          std::sqrt(laws.values.wave_factor * laws.values.gravity * s.depth[k]));
        });
        s.records[static_cast<std::size_t>(tile)] = survey(s, laws, tile);
    }
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
