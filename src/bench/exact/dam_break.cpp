// SPDX-License-Identifier: Apache-2.0
#include "bench/exact/dam_break.h"

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

}  // namespace frana::bench
