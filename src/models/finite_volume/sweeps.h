// SPDX-License-Identifier: Apache-2.0
// The sweeps of a step over its strips, for step.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "models/finite_volume/step.h"
#include "mpm/curvature.h"
#include "physics/pore_pressure.h"
#include "physics/stress_laws.h"

namespace frana::finite_volume {
namespace {

// Reads what follows from the ground.
void read_ground(State& s, const Laws& laws, const NodeRange& range);

// The arrays of a strip's sweep, in its workspace.
class Workspace {
  public:
    Workspace(Strip& strip, std::int64_t width) : width_(static_cast<std::size_t>(width) + 12) {
        const std::size_t arrays = 5 * CellRow::k_arrays + 4 * SideRow::k_arrays + 2 * FaceRow::k_arrays + 24;
        if (strip.work.size() < arrays * width_) strip.work.resize(arrays * width_);
        next_ = strip.work.data();
        for (CellRow& row : rows)
            for (double** array : {&row.depth, &row.speed, &row.normal, &row.tangential, &row.weight, &row.drive,
                                   &row.bed, &row.closed, &row.spare})
                *array = take();
        for (auto& both : sides)
            for (SideRow& row : both)
                for (double** array : {&row.depth, &row.speed, &row.normal, &row.tangential, &row.bed}) *array = take();
        for (FaceRow& row : faces)
            for (double** array : {&row.mass, &row.normal, &row.tangential, &row.pressure_below, &row.pressure_above,
                                   &row.step_below, &row.step_above})
                *array = take();
        for (auto& row : beyond)
            for (double*& array : row) array = take();
        for (auto& row : carried)
            for (double*& array : row) array = take();
    }
    CellRow rows[5];
    SideRow sides[2][2];  // of two rows, at the faces before and after them
    FaceRow faces[2];
    double* beyond[4][5];   // depth, qx, qy, carried of the two rows before and after the strip
    double* carried[2][2];  // through the faces

  private:
    double* take() { return std::exchange(next_, next_ + width_); }
    std::size_t width_;
    double* next_;
};

CellRow moved(const CellRow& row, std::ptrdiff_t by) {
    return {row.depth + by, row.speed + by, row.normal + by, row.tangential + by, row.weight + by,
            row.drive + by, row.bed + by,   row.closed + by, row.spare + by};
}
SideRow moved(const SideRow& row, std::ptrdiff_t by) {
    return {row.depth + by, row.speed + by, row.normal + by, row.tangential + by, row.bed + by};
}
FaceRow moved(const FaceRow& row, std::ptrdiff_t by) {
    return {row.mass + by,           row.normal + by,     row.tangential + by, row.pressure_below + by,
            row.pressure_above + by, row.step_below + by, row.step_above + by};
}

// The cell n cells beyond an open edge that only what moves outwards passes: the flow goes on as it comes, with the
// fall of its surface; of one that stays, the mirror image.
// @param edge, inner the cell at the edge and the next, at e and i  @param out 1: the sweep leaves there; -1: it enters
// @param half of dt over the cell size, if the fall of half a step counts
void continue_beyond(const CellRow& edge, std::size_t e, const CellRow& inner, std::size_t i, int n, double out,
                     const CellRow& beyond, std::size_t b, double half) {
    constexpr double k_leaving = 1e-9;  // of the speed of waves: rounding must not drain a lake
    const double fall = inner.depth[i] + inner.bed[i] - (edge.depth[e] + edge.bed[e]);
    const bool leaves = out * edge.speed[e] + half * edge.weight[e] * std::max(fall, 0.0) >
                        k_leaving * std::sqrt(edge.weight[e] * edge.depth[e]);
    const CellRow& from = leaves || n == 1 ? edge : inner;
    const std::size_t q = leaves || n == 1 ? e : i;
    for (double* CellRow::*same :
         {&CellRow::depth, &CellRow::tangential, &CellRow::weight, &CellRow::drive, &CellRow::closed, &CellRow::spare})
        (beyond.*same)[b] = (from.*same)[q];
    beyond.speed[b] = (leaves ? 1 : -1) * from.speed[q];
    beyond.normal[b] = (leaves ? 1 : -1) * from.normal[q];
    beyond.bed[b] = from.bed[q] - (leaves && inner.depth[i] > 0 ? n * std::max(fall, 0.0) : 0);
}

class Sweeps {
  public:
    Sweeps(State& state, const Laws& laws, const StepValues& values, Maxima* maxima, ThreadPool& pool)
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
        pool_.for_each(s_.prepared.size(), [&](std::size_t n) { fill_bed_states(s_.prepared[n], 0); });
        for_prepared_rows([&](std::size_t first, std::size_t count) {
            if (!friction.excess.speed_after) {
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
                if (!laws_.wall) {
                    for (int n = 1; n <= 2; ++n) {
                        if (strip.region.i0 == k_ghost)
                            continue_beyond(row, 1, row, 2, n, -1, moved(row, -n), 1, half_of_fall());
                        if (strip.region.i1 == s_.nodes.stride() - k_ghost)
                            continue_beyond(row, count, row, count - 1, n, 1, moved(row, n), count, half_of_fall());
                    }
                }
                const SideRow &before_cells = work.sides[0][0], &after_cells = work.sides[0][1];
                kernels_.sides(moved(row, -1), row, moved(row, 1), count + 2, v_, before_cells, after_cells);
                kernels_.faces(moved(row, -1), row, moved(row, 1), moved(row, 2), after_cells, moved(before_cells, 1),
                               count + 1, v_, work.faces[0]);
                const double rate = v_.dt / v_.cell_size;
                for (int n = 0; n < carried(); ++n) {
                    double *const content = s_.carried[n].data() + first, *const flux = work.carried[0][n];
                    carry(work.faces[0].mass, count + 1, c_.depth + first - 1, content - 1, c_.depth + first, content,
                          flux);
                    change(flux, flux + 1, count, rate, content);
                }
                kernels_.update(c_, first, count, false, v_, work.faces[0], moved(work.faces[0], 1));
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
                for (int n = 0; n < carried(); ++n)
                    std::copy_n(s_.carried[n].data() + from, count, work.beyond[q][3 + n]);
            }
        });
        for_strips([&](Strip& strip) { sweep_along_y(strip); });
    }
    void finish() {
        const voellmy_bingham::BedFriction& friction = laws_.friction;
        BedState* const states = s_.bed_states.data();
        for_strips([&](Strip& strip) {
            strip.totals = {};
            if (friction.summed) fill_bed_states(strip.region, v_.dt);  // of what has just been reached, too
        });
        for_rows([&](Strip& strip, std::size_t first, std::size_t count) {
            if (!friction.summed) {
                kernels_.finish(c_, first, count, v_, UniformFriction{friction.voellmy}, strip.totals);
            } else if (!friction.excess.speed_after) {
                kernels_.finish_summed(c_, first, count, v_, {NoExcess{}, states, friction.yields}, strip.totals);
            } else {
                finish_excess(c_, first, count, v_, friction.excess, states, strip.totals);
            }
        });
    }
    // The force of the in-plane stress, and its bound of the step.
    void strain() {
        if (!laws_.stress.law) return;
        StressLaws::for_each([&]<class Law>() {
            if (const Law* const law = laws_.stress.law.target<Law>())
                for_strips([&](Strip& strip) { strain_strip(*law, strip); });
        });
        s_.diffusivity = 0;
        for (std::size_t n = 0; n < s_.n_strips; ++n)
            s_.diffusivity = std::max(s_.diffusivity, s_.strips[n].diffusivity);
    }
    // The change of momentum by it.
    void push() {
        if (!laws_.stress.law) return;
        for_rows([&](Strip&, std::size_t first, std::size_t count) {
            for (std::size_t k = first; k < first + count; ++k) {
                const double fx = v_.dt * s_.force_x[k], fy = v_.dt * s_.force_y[k];
                const Point w = BedFrame{c_.slope_x[k], c_.slope_y[k], c_.root[k]}.along_bed(fx, fy);
                c_.qx[k] += w.x;
                c_.qy[k] += w.y;
            }
        });
    }
    // Eroded material is at rest, deposited and detrained material leaves with its momentum.
    void exchange() {
        if (!laws_.exchange.at_nodes) return;
        for_strips([&](Strip& strip) {
            const Region& r = strip.region;
            const NodeRange range(r.i0, r.i1, r.j0, r.j1);
            range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
                const CellMotion motion = motion_of(s_, laws_, k);
                const double mass = c_.depth[k] > v_.dry ? c_.depth[k] * s_.cell_area() : 0;
                s_.nodes.records[k].motion = {motion.u, motion.v, 0, 0, mass, 1, 0, 0};
            });
            laws_.exchange.at_nodes(range, v_.dt, 2 * v_.dry, s_.bed_states.data(), s_.nodes, s_.erodible_beds.data());
        });
        // After all have been computed: slopes are read across strips.
        std::vector<ExchangeReport> reports(s_.n_strips);
        pool_.for_each(s_.n_strips, [&](std::size_t n) {
            const Region& r = s_.strips[n].region;
            NodeRange(r.i0, r.i1, r.j0, r.j1).for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
                const ErodibleBed& bed = s_.erodible_beds[k];
                for (const double change : {bed.change, bed.held})
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
    [[nodiscard]] double half_of_fall() const { return laws_.films ? 0.5 * v_.dt / v_.cell_size : 0; }
    [[nodiscard]] int carried() const { return s_.carried[0].size() == 0 ? 0 : s_.carried[1].size() == 0 ? 1 : 2; }
    // What passes faces with their mass: of the cell from which it comes.
    static void carry(const double* mass, std::size_t count, const double* depth_below, const double* below,
                      const double* depth_above, const double* above, double* flux) {
        for (std::size_t q = 0; q < count; ++q)
            flux[q] = mass[q] > 0   ? mass[q] * (below[q] / depth_below[q])
                      : mass[q] < 0 ? mass[q] * (above[q] / depth_above[q])
                                    : 0;
    }
    static void change(const double* before, const double* after, std::size_t count, double rate, double* content) {
        for (std::size_t q = 0; q < count; ++q) content[q] -= rate * (after[q] - before[q]);
    }
    // The states of the bed, and every law's part. Pore pressure advances over dt, and acts as in the middle of it.
    void fill_bed_states(const Region& r, double dt) {
        const PorePressure& law = laws_.friction.pore_pressure;
        const NodeRange range(r.i0, r.i1, r.j0, r.j1);
        range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
            const double h = c_.depth[k];
            const bool wet = h > v_.dry;
            s_.nodes.records[k].sums.mass = wet ? h * s_.cell_area() : 0;
            if (!wet) return;
            const Point u = BedFrame{c_.slope_x[k], c_.slope_y[k], c_.root[k]}.in_map(c_.qx[k] / h, c_.qy[k] / h);
            const BedCurvature curvature{c_.curvature_xx[k], c_.curvature_xy[k], c_.curvature_yy[k]};
            const double supported = v_.gravity + std::max(-v_.gravity, curvature.load(u.x, u.y));
            double ratio = 0;
            if (carried() > 0) {
                PorePressure::State pores = s_.pores(k);
                const auto half_step = [&] {
                    pores = law.after(pores, h / c_.root[k], std::hypot(c_.qx[k], c_.qy[k]) / h,
                                      v_.gravity / c_.root[k], 0.5 * dt);
                };
                half_step();
                ratio = pores.ratio;
                half_step();
                if (dt > 0) s_.set_pores(k, h, pores);
            }
            s_.bed_states[k] = {h / c_.root[k], supported / c_.root[k], 0, 0, 0, 0, ratio};
        });
        for (const auto& sweep : laws_.friction.sweeps) sweep(range, s_.nodes, s_.bed_states.data());
        if (dt > 0)
            range.for_each(c_.stride, [&](std::size_t k, std::int64_t, std::int64_t) {
                const double share = c_.depth[k] > v_.dry ? friction_share(c_.before[k], c_.depth[k]) : 1;
                for (double BedState::*part : {&BedState::yield, &BedState::linear, &BedState::square})
                    s_.bed_states[k].*part *= share;
            });
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
            s_.set_pores(k, -change, laws_.exchange.bed, true);
        }
        for (int n = 0; n < carried(); ++n) s_.carried[n][k] *= kept;
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
            const PlaneStress<double> s =
                law(StrainRate<double>{u_x, 0.5 * (u_y + v_x), v_y, 0.5 * (b.speed[p] + c.speed[q]),
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
        // Of rows that are not updated yet.
        const auto content = [&](std::int64_t j, int n) -> const double* {
            if (j < strip.region.j0) return work.beyond[1][n];
            if (j >= strip.region.j1) return work.beyond[2][n];
            const std::size_t first = index(strip.region.i0, j);
            return (n == 0 ? c_.depth : s_.carried[n - 3].data()) + first;
        };
        const auto sides = [&](std::int64_t j) {
            const auto& both = work.sides[(j - strip.region.j0 + 2) % 2];
            kernels_.sides(row(j - 1), row(j), row(j + 1), count, v_, both[0], both[1]);
        };
        const auto faces = [&](std::int64_t j, int to) {
            sides(j);
            kernels_.faces(row(j - 2), row(j - 1), row(j), row(j + 1), work.sides[(j - strip.region.j0 + 1) % 2][1],
                           work.sides[(j - strip.region.j0 + 2) % 2][0], count, v_, work.faces[to]);
            for (int n = 0; n < carried(); ++n)
                carry(work.faces[to].mass, count, content(j - 1, 0), content(j - 1, 3 + n), content(j, 0),
                      content(j, 3 + n), work.carried[to][n]);
        };
        // The row beyond an open edge that is n rows from it.
        const auto continue_row = [&](std::int64_t edge, int out, int n) {
            if (laws_.wall) return;
            for (std::size_t q = 0; q < count; ++q)
                continue_beyond(row(edge), q, row(edge - out), q, n, out, row(edge + n * out), q, half_of_fall());
        };
        const auto read_next = [&](std::int64_t j) {
            const std::int64_t end = s_.nodes.padded_rows() - k_ghost;
            read(j, row(j));
            if (j >= end) continue_row(end - 1, 1, static_cast<int>(j + 1 - end));
        };
        for (std::int64_t j = strip.region.j0 - 2; j < strip.region.j0 + 2; ++j) read_next(j);
        for (int n = 1; strip.region.j0 == k_ghost && n <= 2; ++n) continue_row(k_ghost, -1, n);
        int now = 0;
        sides(strip.region.j0 - 1);
        faces(strip.region.j0, now);
        const double rate = v_.dt / v_.cell_size;
        if (strip.region.j0 == k_ghost) strip.left -= rate * sum(work.faces[now].mass, count);
        for (std::int64_t j = strip.region.j0; j < strip.region.j1; ++j) {
            read_next(j + 2);
            faces(j + 1, 1 - now);
            for (int n = 0; n < carried(); ++n)
                change(work.carried[now][n], work.carried[1 - now][n], count, rate,
                       s_.carried[n].data() + index(strip.region.i0, j));
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

}  // namespace
}  // namespace frana::finite_volume
