// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace frana::test {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class RandomNumbers {
  public:
    RandomNumbers(std::uint64_t seed, std::uint64_t stream) : state_(seed * 0x9e3779b97f4a7c15ULL) {
        state_ = word() ^ (stream * 0xd1342543de82ef95ULL);
    }

    std::uint64_t word() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// In [from, to).
    double between(double from, double to) { return from + (to - from) * static_cast<double>(word() >> 11) * 0x1p-53; }
    /// Uniform in the logarithm.
    double log_between(double from, double to) { return from * std::pow(to / from, between(0, 1)); }
    /// 0 to count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(word() % count); }
    bool once_in(std::size_t count) { return below(count) == 0; }

  private:
    std::uint64_t state_;
};

}  // namespace frana::test
