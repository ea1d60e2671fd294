// SPDX-License-Identifier: Apache-2.0
#include "bench/exact/solutions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frana::bench {

DamBreak::DamBreak(double left, double right, double gravity) : left_(left), right_(right), gravity_(gravity) {
    const double celerity = std::sqrt(gravity * left);
    if (right <= 0) {
        front_speed_ = 2 * celerity;
        return;
    }
    double low = right, high = left;
    for (int i = 0; i < 200; ++i) {
        middle_ = 0.5 * (low + high);
        const double rarefaction = 2 * (celerity - std::sqrt(gravity * middle_));
        const double shock = (middle_ - right) * std::sqrt(0.5 * gravity * (middle_ + right) / (middle_ * right));
        (rarefaction > shock ? low : high) = middle_;
    }
    middle_velocity_ = 2 * (celerity - std::sqrt(gravity * middle_));
    front_speed_ = middle_ * middle_velocity_ / (middle_ - right);
}

WaterState DamBreak::at(double x, double t) const {
    const double celerity = std::sqrt(gravity_ * left_), s = x / t;
    if (s <= -celerity) return {left_, 0};
    if (s >= front_speed_) return {right_, 0};
    if (right_ > 0 && s >= middle_velocity_ - std::sqrt(gravity_ * middle_)) return {middle_, middle_velocity_};
    const double root = (2 * celerity - s) / 3;  // sqrt(g h)
    return {root * root / gravity_, 2 * (celerity + s) / 3};
}

namespace {

constexpr double k_dry = 1e-9;  // thinner films have no momentum [m]

double van_leer(double a, double b) {
    return a * b > 0 ? 2 * a * b / (a + b) : 0;
}

struct Flux {
    double mass = 0, momentum = 0;
};

Flux hll(double h_l, double u_l, double h_r, double u_r) {
    if (h_l <= k_dry && h_r <= k_dry) return {};
    const double c_l = std::sqrt(k_gravity * h_l), c_r = std::sqrt(k_gravity * h_r);
    double slow = std::min(u_l - c_l, u_r - c_r), fast = std::max(u_l + c_l, u_r + c_r);
    if (h_l <= k_dry) slow = u_r - 2 * c_r;  // a dry front moves at twice the celerity
    if (h_r <= k_dry) fast = u_l + 2 * c_l;
    const Flux left{h_l * u_l, h_l * u_l * u_l + 0.5 * k_gravity * h_l * h_l};
    const Flux right{h_r * u_r, h_r * u_r * u_r + 0.5 * k_gravity * h_r * h_r};
    if (slow >= 0) return left;
    if (fast <= 0) return right;
    const double w = 1 / (fast - slow);
    return {w * (fast * left.mass - slow * right.mass + slow * fast * (h_r - h_l)),
            w * (fast * left.momentum - slow * right.momentum + slow * fast * (h_r * u_r - h_l * u_l))};
}

double velocity(double h, double q) {
    return h > k_dry ? q / h : 0;
}

}  // namespace

RadialReference::RadialReference(double radius, double inside, double outside, double extent, double time, int cells)
    : dr_(extent / cells), cells_(static_cast<std::size_t>(cells)) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const double r0 = dr_ * static_cast<double>(i), r1 = r0 + dr_, cut = std::clamp(radius, r0, r1);
        const double fraction = (cut * cut - r0 * r0) / (r1 * r1 - r0 * r0);  // of the ring inside the cylinder
        cells_[i].h = inside * fraction + outside * (1 - fraction);
    }
    std::vector<Cell> first(cells_.size()), second(cells_.size()), middle(cells_.size());
    for (double t = 0; t < time;) {
        const double dt = std::min(0.45 * dr_ / fastest(), time - t);
        rate(cells_, first);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            middle[i] = {std::max(0.0, cells_[i].h + dt * first[i].h), cells_[i].q + dt * first[i].q};
        rate(middle, second);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            cells_[i].h = std::max(0.0, cells_[i].h + 0.5 * dt * (first[i].h + second[i].h));
            cells_[i].q += 0.5 * dt * (first[i].q + second[i].q);
            if (cells_[i].h <= k_dry) cells_[i].q = 0;
        }
        if (time - t <= dt) break;
        t += dt;
    }
}

double RadialReference::fastest() const {
    double speed = 1e-12;
    for (const Cell& cell : cells_)
        speed = std::max(speed, std::abs(velocity(cell.h, cell.q)) + 2 * std::sqrt(k_gravity * cell.h));
    return speed;
}

void RadialReference::rate(const std::vector<Cell>& state, std::vector<Cell>& change) const {
    const std::size_t n = state.size();
    const auto h = [&](std::ptrdiff_t i) {  // mirrored at both walls
        const auto k = static_cast<std::size_t>(i < 0 ? -i - 1 : i);
        return state[k < n ? k : 2 * n - 1 - k].h;
    };
    const auto u = [&](std::ptrdiff_t i) {
        const auto k = static_cast<std::size_t>(i < 0 ? -i - 1 : i);
        const Cell& cell = state[k < n ? k : 2 * n - 1 - k];
        return (i < 0 || k >= n ? -1 : 1) * velocity(cell.h, cell.q);
    };
    const auto slope = [](const auto& f, std::ptrdiff_t i) { return 0.5 * van_leer(f(i) - f(i - 1), f(i + 1) - f(i)); };
    std::vector<Flux> faces(n + 1);
    for (std::ptrdiff_t f = 0; f <= static_cast<std::ptrdiff_t>(n); ++f) {
        faces[static_cast<std::size_t>(f)] =
            hll(h(f - 1) + slope(h, f - 1), u(f - 1) + slope(u, f - 1), h(f) - slope(h, f), u(f) - slope(u, f));
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double r0 = dr_ * static_cast<double>(i), r1 = r0 + dr_, ring = 0.5 * (r1 * r1 - r0 * r0);
        change[i].h = (r0 * faces[i].mass - r1 * faces[i + 1].mass) / ring;
        change[i].q =
            (r0 * faces[i].momentum - r1 * faces[i + 1].momentum + 0.5 * k_gravity * state[i].h * state[i].h * dr_) /
            ring;
    }
}

WaterState RadialReference::at(double r) const {
    const double s = r / dr_ - 0.5;
    const auto last = static_cast<double>(cells_.size() - 1);
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(s), 0.0, last - 1));
    const double w = std::clamp(s - static_cast<double>(i), 0.0, 1.0);
    const double depth = (1 - w) * cells_[i].h + w * cells_[i + 1].h;
    return {depth, velocity(depth, (1 - w) * cells_[i].q + w * cells_[i + 1].q)};
}

double RadialReference::reach(double depth) const {
    for (std::size_t i = cells_.size(); i-- > 0;)
        if (cells_[i].h > depth) return dr_ * (static_cast<double>(i) + 1);
    return 0;
}

double RadialReference::volume() const {
    double sum = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) sum += cells_[i].h * dr_ * dr_ * (static_cast<double>(i) + 0.5);
    return sum;
}

namespace {

using Variables = std::array<double, 4>;  // f, f', g, g'

Variables plus(const Variables& a, double dt, const Variables& b) {
    return {a[0] + dt * b[0], a[1] + dt * b[1], a[2] + dt * b[2], a[3] + dt * b[3]};
}

}  // namespace

SimilaritySolution::SimilaritySolution(double slope_deg, double friction_deg, double height, double radius, double time,
                                       double earth_pressure)
    : height_(height), radius_(radius) {
    const double normal = k_gravity * std::cos(slope_deg * k_degree);
    const double friction = normal * std::tan(friction_deg * k_degree);
    const double drive = k_gravity * std::sin(slope_deg * k_degree) - friction;
    const double spread = 2 * earth_pressure * normal * height / (radius * radius);
    const auto rate = [&](double t, const Variables& y) {
        return Variables{y[1], spread / (y[0] * y[0] * y[2]), y[3],
                         spread / (y[0] * y[2] * y[2]) - friction * y[3] / (drive * t)};
    };
    // At the start g' = r t with r = spread - friction r / drive, since u = drive t.
    const double start = 1e-6 * time, sideways = spread * drive / (drive + friction);
    Variables y{1 + 0.5 * spread * start * start, spread * start, 1 + 0.5 * sideways * start * start, sideways * start};
    // Steps that grow with time: the rate of the sideways friction is friction / (drive t).
    for (double t = start; t < time;) {
        const double dt = std::min({0.01 * t, 1e-3 * time, time - t});
        const Variables k1 = rate(t, y), k2 = rate(t + 0.5 * dt, plus(y, 0.5 * dt, k1));
        const Variables k3 = rate(t + 0.5 * dt, plus(y, 0.5 * dt, k2)), k4 = rate(t + dt, plus(y, dt, k3));
        for (std::size_t i = 0; i < 4; ++i) y[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        if (time - t <= dt) break;
        t += dt;
    }
    f_ = y[0];
    f_rate_ = y[1];
    g_ = y[2];
    g_rate_ = y[3];
    middle_ = 0.5 * drive * time * time;
    speed_ = drive * time;
}

ExactState SimilaritySolution::at(Point place) const {
    const double x = place.x - middle_, y = place.y;
    const double a = x / (radius_ * f_), b = y / (radius_ * g_), depth = height_ / (f_ * g_) * (1 - a * a - b * b);
    if (!(depth > 0)) return {};
    return {depth, depth * (speed_ + x * f_rate_ / f_), depth * y * g_rate_ / g_};
}

}  // namespace frana::bench
