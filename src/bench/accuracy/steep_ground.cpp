// SPDX-License-Identifier: Apache-2.0
#include "bench/accuracy/accuracy_case.h"

#include <algorithm>
#include <cstdio>

namespace frana::bench {
namespace {

using Surface = std::function<double(Point)>;
using Profile = std::function<double(double)>;

constexpr double k_film = 0.3;  // its pressure is equivalent to 0.15 m of height

// Means of the film, weighted by volume.
struct Film {
    double height = 0;   // of the ground under it [m]
    double kinetic = 0;  // over gravity [m]
    [[nodiscard]] double energy() const { return height + kinetic; }
};

double square(double a) {
    return a * a;
}

class FilmRun {
  public:
    /// @param film position and initial speed (of the depth only the sign is used)
    FilmRun(double length, double width, double cell_size, Scheme scheme, Surface ground,
            const std::function<Seed(Point)>& film, Boundary boundary = Boundary::open)
        : ground_(std::move(ground)) {
        setup_.bed = sample_raster(
            plain_grid(std::llround(length / cell_size), std::llround(width / cell_size), cell_size), ground_);
        setup_.seeds = fill_lattice(setup_.bed.grid, 2, 0, [&](Point p) {
            const Seed seed = film(p);
            return Seed{seed.depth > 0 ? k_film : 0, seed.u, seed.v};
        });
        setup_.material = water();
        setup_.numerics = numerics_of(scheme, SlopeCorrection::normal, boundary);
        setup_.numerics.minimum_depth = 1e-6;
        setup_.numerics.flight_drag = 0;  // parabolas are exact solutions
        run_.emplace(setup_);
    }

    /// Steps to `end`, or until nothing is left; calls observe(film) after each step.
    void advance_to(double end, const std::function<void(const Film&)>& observe) {
        const double lag = setup_.numerics.scheme == Scheme::finite_volume ? 0 : 0.5;  // of leapfrog's velocities
        run_->advance_to(end, [&](const StepStatistics& step) { observe(film(lag * step.dt)); });
    }

    /// @param lag of the velocities behind the positions [s]; heights are then those of their time
    [[nodiscard]] Film film(double lag = 0) {
        const ParticleSet& particles = run_->particles();
        Film film;
        double total = 0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const double volume = particles[Field::volume][p];
            const Point v = run_->velocity(p);
            const Point at{particles[Field::x][p] - lag * v.x, particles[Field::y][p] - lag * v.y};
            film.height += volume * ground_(at);
            film.kinetic += volume * square_of_speed(particles, p, at, v) / (2 * k_gravity);
            total += volume;
        }
        if (total > 0) {
            for (double* value : {&film.height, &film.kinetic}) *value /= total;
        }
        return film;
    }
    /// By volume, in map view [m].
    [[nodiscard]] double mean_jump() {
        const JumpStatistics& jumps = run_->flow().flights().statistics();
        return jumps.volume > 0 ? jumps.way / jumps.volume : 0;
    }

    void add_cost_to(CaseStatistics& statistics) {
        statistics.particles = std::max(statistics.particles, run_->peak_particles());
        statistics.steps += run_->model().steps();
        statistics.wall_seconds += run_->seconds();
        statistics.cpu_seconds += run_->cpu_seconds();
        if (run_->non_finite() > 0) statistics.error = "values became non-finite";
    }

  private:
    // Along the bed: from the velocity stored by the particle, or from its velocity in map view there.
    [[nodiscard]] double square_of_speed(const ParticleSet& particles, std::size_t p, Point at, Point v) const {
        // Particles carry the velocity along the bed, cells are given that in map view.
        if (curvature(setup_.numerics) && setup_.numerics.scheme != Scheme::finite_volume)
            return square(particles[Field::u][p]) + square(particles[Field::v][p]);
        constexpr double k_near = 1e-3;
        const double x = (ground_({at.x + k_near, at.y}) - ground_({at.x - k_near, at.y})) / (2 * k_near);
        const double y = (ground_({at.x, at.y + k_near}) - ground_({at.x, at.y - k_near})) / (2 * k_near);
        return v.x * v.x + v.y * v.y + square(v.x * x + v.y * y);
    }

    Surface ground_;
    Setup setup_;
    std::optional<TimedFlow> run_;
};

CaseStatistics statistics_of(double cell_size, std::vector<CaseStatistic> own, CaseStatistics cost) {
    cost.cell_size = cell_size;
    for (const CaseStatistic& statistic : own) {
        cost.l1_depth = std::max(cost.l1_depth, std::abs(statistic.value));
        cost.l1_momentum += std::abs(statistic.value) / static_cast<double>(own.size());
    }
    cost.l2_depth = cost.linf_depth = cost.l1_depth;
    cost.l2_momentum = cost.l1_momentum;
    cost.own = std::move(own);
    return cost;
}

// A frame whose first axis is at an angle to the grid's.
struct Turned {
    Point origin;
    double cosine, sine;

    Turned(Point from, double angle_deg)
        : origin(from), cosine(std::cos(angle_deg * k_degree)), sine(std::sin(angle_deg * k_degree)) {}
    [[nodiscard]] Point in(Point p) const {
        const double x = p.x - origin.x, y = p.y - origin.y;
        return {cosine * x + sine * y, cosine * y - sine * x};
    }
};

Seed disc(Point p, Point middle, double radius) {
    return {square(p.x - middle.x) + square(p.y - middle.y) < radius * radius ? 1.0 : 0.0};
}

std::string text_of(const char* format, double a, double b, double c) {
    char text[128];
    std::snprintf(text, sizeof text, format, a, b, c);
    return text;
}

// Particles of a film, all with the same energy, that of rest at a height, so that none overtakes another (where they
// meet, a continuum loses energy) and all follow the same path. They start along the first axis.
Seed flowing(const Turned& frame, Point p, Point middle, double radius, double height, const Profile& profile) {
    const Point at = frame.in(p);
    Seed seed = disc(at, middle, radius);
    const double z = profile(at.x), slope = (profile(at.x + 0.5) - profile(at.x - 0.5));
    if (!(z < height)) return {};
    const double speed = std::sqrt(2 * k_gravity * (height - z) / (1 + slope * slope));
    seed.u = speed * frame.cosine;
    seed.v = speed * frame.sine;
    return seed;
}

constexpr double k_margin = 80, k_film_radius = 12;

// A film that flows along a profile, at an angle to the grid.
FilmRun along(const Profile& profile, double length, double start, double height, double angle_deg, double cell_size,
              Scheme scheme) {
    const Turned frame({k_margin, k_margin}, angle_deg);
    return FilmRun(
        2 * k_margin + length * frame.cosine, 2 * k_margin + length * frame.sine, cell_size, scheme,
        [=](Point p) { return profile(frame.in(p).x); },
        [&](Point p) {
            return flowing(frame, p, {start, 0}, k_film_radius, height, profile);
        });
}

constexpr double k_angles[] = {0.0, 30.0};

// Height climbed over height fallen.
double climb(double cell_size, Scheme scheme, double down_deg, double up_deg, double angle_deg, CaseStatistics& cost) {
    constexpr double k_fall = 200, k_start = 150;
    const double down = std::tan(down_deg * k_degree), up = std::tan(up_deg * k_degree);
    const double ahead = k_start / down, beyond = k_fall / up;
    const auto profile = [=](double s) { return s < ahead ? (ahead - s) * down : (s - ahead) * up; };
    FilmRun run = along(profile, ahead + 3.5 * beyond, 0, k_fall, angle_deg, cell_size, scheme);
    const double time =
        std::sqrt(2 * k_fall / k_gravity) * (0.5 / std::sin(down_deg * k_degree) + 1 / std::sin(up_deg * k_degree));
    // The foremost particles turn and meet those behind: the film is measured before.
    Film climbing;
    double lowest = k_fall;
    run.advance_to(2 * time, [&](const Film& now) {
        lowest = std::min(lowest, now.height);
        if (climbing.height == 0 && lowest < 0.3 * k_fall && now.height > 0.5 * k_fall) climbing = now;
    });
    run.add_cost_to(cost);
    return climbing.energy() / k_fall;
}

CaseStatistics run_valley(double cell_size, Scheme scheme) {
    CaseStatistics cost;
    std::vector<CaseStatistic> own;
    constexpr double k_pairs[][2] = {{30, 45}, {20, 50}, {30, 60}, {45, 70}, {60, 20}};
    for (const double angle : k_angles) {
        for (const auto& [down, up] : k_pairs) {
            own.push_back({text_of("climb over fall - 1, %g/%g, turned by %g", down, up, angle),
                           climb(cell_size, scheme, down, up, angle, cost) - 1, 0.02});
        }
    }
    return statistics_of(cell_size, own, cost);
}

// Height climbed by the centre of a film that starts at rest on the upper half of a face, over height fallen. On the
// other side its faster part overtakes the slower.
double surge_climb(double cell_size, Scheme scheme, double down_deg, double up_deg, CaseStatistics& cost) {
    constexpr double k_fall = 200, k_width = 40;
    const double down = std::tan(down_deg * k_degree), up = std::tan(up_deg * k_degree);
    const double top = k_margin, foot = top + k_fall / down, length = foot + 1.5 * k_fall / up;
    FilmRun run(
        length, k_width, cell_size, scheme,
        [=](Point p) { return p.x < foot ? (foot - p.x) * down : (p.x - foot) * up; },
        [=](Point p) { return Seed{p.x > top && p.x < top + 0.5 * k_fall / down ? 1.0 : 0.0}; }, Boundary::wall);
    const double start = run.film().height,
                 time = 1.2 * std::sqrt(2 * k_fall / k_gravity) *
                        (1 / std::sin(down_deg * k_degree) + 1 / std::sin(up_deg * k_degree));
    double lowest = start, highest = 0;
    run.advance_to(time, [&](const Film& now) {
        lowest = std::min(lowest, now.height);
        if (lowest < 0.5 * start) highest = std::max(highest, now.height);
    });
    run.add_cost_to(cost);
    return highest / start;
}

// Exact: shallow flow along the bed, with g cos(slope) normal to it, by finite volumes (HLL, minmod) of 0.25 m, which
// differ from those of 0.5 m by less than 0.002.
CaseStatistics run_valley_surge(double cell_size, Scheme scheme) {
    CaseStatistics cost;
    std::vector<CaseStatistic> own;
    constexpr double k_climbs[][3] = {{30, 40, 0.949}, {30, 60, 0.927}, {60, 20, 0.981}, {60, 50, 0.965}};
    for (const auto& [down, up, exact] : k_climbs) {
        own.push_back({text_of("climb over fall, %g/%g, less that of the exact flow%.0s", down, up, 0),
                       surge_climb(cell_size, scheme, down, up, cost) - exact, 0.05});
    }
    return statistics_of(cell_size, own, cost);
}

// A half-pipe of parabolic section whose axis falls by 35 degrees along a quarter circle between two straights.
CaseStatistics run_gully_bend(double cell_size, Scheme scheme) {
    constexpr double k_bend = 150, k_straight = 120, k_slope = 0.7, k_section = 60, k_height = 400;
    constexpr double k_quarter = 1.5707963267948966 * k_bend;
    const Point centre{60 + k_straight, 100 + k_bend};
    const auto ground = [=](Point p) {
        double way = 0, aside = 0;
        if (p.x < centre.x) {  // eastwards
            way = p.x - 60;
            aside = p.y - (centre.y - k_bend);
        } else if (p.y > centre.y) {  // northwards
            way = k_straight + k_quarter + (p.y - centre.y);
            aside = p.x - (centre.x + k_bend);
        } else {
            way = k_straight + k_bend * std::atan2(p.x - centre.x, centre.y - p.y);
            aside = std::hypot(p.x - centre.x, p.y - centre.y) - k_bend;
        }
        return k_height - k_slope * way + square(aside) / (2 * k_section);
    };
    const Turned frame({60, centre.y - k_bend}, 0);
    const double height = k_height + 10;
    FilmRun run(460, 520, cell_size, scheme, ground, [&](Point p) {
        Seed seed = flowing(frame, p, {40, 0}, k_film_radius, height, [=](double s) { return k_height - k_slope * s; });
        const double slope = 1 + k_slope * k_slope, spare = height - ground(p);
        seed.u = spare > 0 ? std::sqrt(2 * k_gravity * spare / slope) : 0;
        return seed;
    });
    run.advance_to(11, [](const Film&) {});
    const Film end = run.film();
    CaseStatistics cost;
    run.add_cost_to(cost);
    return statistics_of(cell_size,
                         {{"energy gained over fall", (end.energy() - height) / (height - end.height), 0.02}}, cost);
}

// At 20 m/s over an edge of 50 m: a parabola, then further at 20 m/s.
CaseStatistics run_cliff_jump(double cell_size, Scheme scheme) {
    constexpr double k_speed = 20, k_edge = 100, k_drop = 50;
    const double flies = std::sqrt(2 * k_drop / k_gravity);
    CaseStatistics cost;
    std::vector<CaseStatistic> own;
    for (const double angle : k_angles) {
        const Turned frame({k_margin, k_margin}, angle);
        const auto profile = [=](double s) { return s < k_edge ? k_drop : 0; };
        FilmRun run = along(profile, 300, 40, k_drop + square(k_speed) / (2 * k_gravity), angle, cell_size, scheme);
        run.advance_to(9, [](const Film&) {});
        own.push_back({text_of("mean length of the jump over the parabola's - 1, turned by %g%.0s%.0s", angle, 0, 0),
                       run.mean_jump() / (k_speed * flies) - 1, 0.05});
        own.push_back({text_of("speed after it over that before - 1, turned by %g%.0s%.0s", angle, 0, 0),
                       std::sqrt(2 * k_gravity * run.film().kinetic) / k_speed - 1, 0.02});
        run.add_cost_to(cost);
    }
    return statistics_of(cell_size, own, cost);
}

}  // namespace

/// A film without friction, too thin for its own pressure to matter, moves over steep ground as a point mass on the
/// surface does: |speed along the bed|^2 / 2 + g Z is constant (a constraint that does no work; Goldstein, Classical
/// Mechanics). All of a film has the same energy, so that no particle overtakes another. Each case is run along the
/// grid and, if it has a direction, at 30 degrees to it.
///
///   valley      down one side of a V and up the other; own values: height climbed over height fallen (200 m),
///               minus 1, for five pairs of slopes; measured half-way up, before the foremost turn and meet
///               those behind
///   valley-surge  the same from rest on half of a face: climb less that of the exact flow, for four pairs
///   gully-bend  down a half-pipe that turns by 90 degrees; change of the energy over the fall
///
/// l1_depth of these cases is the largest of their own values, l1_momentum the mean.
std::vector<AccuracyCase> steep_ground() {
    const std::vector<double> cells{10, 5, 2.5, 1.25};
    return {{"valley", "thin film without friction down one side of a V and up the other", cells, false, run_valley},
            {"valley-surge", "thin film without friction into a V, whose parts overtake each other on the other side",
             cells, false, run_valley_surge},
            {"gully-bend", "thin film without friction down a half-pipe round a bend", cells, false, run_gully_bend},
            {"cliff-jump", "film of 30 cm without friction over an edge of 50 m", cells, false, run_cliff_jump, true}};
}

}  // namespace frana::bench
