// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include "bench/dam_break.h"
#include "bench/lattice.h"
#include "simulation/flow.h"
using namespace frana;
using namespace frana::bench;
int main(int argc, char** argv) {
    std::string which = argv[1];
    int n = atoi(argv[2]);
    double jitter = argc > 3 ? atof(argv[3]) : 0;
    std::string scheme = argc > 4 ? argv[4] : "default";
    double cfl = argc > 5 ? atof(argv[5]) : 0.5;
    double right = which == "stoker" ? 2 : which == "weak" ? 5 : 0;
    double dx = 1000.0 / n;
    int rows = 50 / dx < 4 ? 4 : int(50 / dx + .5);
    if (argc > 6) rows = atoi(argv[6]);
    GridSpec g = plain_grid(n, rows, dx);
    Raster bed = sample_raster(g, [](Point) { return 0.0; });
    Numerics num;
    num.boundary = Boundary::wall;
    num.cfl = cfl;
    num.slope_correction = SlopeCorrection::none;
    if (scheme == "paper") num.scheme = Scheme::paper;
    Material m;
    m.friction_coefficient = 0;
    auto seeds = fill_lattice(g, 2, jitter, [&](Point p) { return Seed{p.x < 500 ? 10 : right}; });
    Flow f(bed, seeds, m, num, 1);
    auto t0 = std::chrono::steady_clock::now();
    f.advance_to(20);
    double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    DamBreak ex(10, right);
    auto q = f.nodal_fields();
    double e = 0, tot = 0, em = 0, tm = 0, mx = 0;
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < n; c++) {
            Point p = g.cell_centre(r, c);
            auto w = ex.at(p.x - 500, 20);
            double d = q.depth.at(r, c);
            e += fabs(d - w.depth);
            tot += w.depth;
            em += fabs(q.momentum_x.at(r, c) - w.depth * w.velocity);
            tm += w.depth * w.velocity;
            mx = std::max(mx, fabs(q.momentum_y.at(r, c)));
        }
    printf(
        "%s n=%d jit=%.1f %s cfl %.2f: mean abs %.5f rel %.5f mom %.5f  vmax_y %.1e steps %ld parts %zu  "
        "%.2f s  %.2f Mps\n",
        which.c_str(), n, jitter, scheme.c_str(), cfl, e / (rows * n), e / tot, em / tm, mx, (long)f.steps(),
        f.particles().size(), s, f.particle_steps() / s / 1e6);
}
