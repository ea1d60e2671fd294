// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::render {

/// How an axis goes from values to places.
enum class Scale {
    linear,
    logarithmic,  ///< from the least to the greatest value; those of 0 and less have no place
    decades       ///< the same, between whole powers of ten
};

/// Decades that an axis shows: whole powers of ten round all its values, 10^low to 10^high.
struct Decades {
    int low = 0, high = 1;
};
/// Of the positive values; 1 to 10 where there is none.
Decades decades_of(const std::vector<double>& values);

/// A place along an axis; without words it is one between those that have some.
struct Tick {
    double at = 0;  ///< [px]
    std::string words;
};

/// One axis, from its values to pixels of the page.
class ChartAxis {
  public:
    /// Where `values` begin and end on the page [px], and what a label takes at least along the axis [px]. A linear
    /// axis that is `rounded` ends at labels.
    ChartAxis(Scale scale, const std::vector<double>& values, double from, double to, double room, bool rounded);

    [[nodiscard]] static bool has(Scale scale, double value);
    [[nodiscard]] double at(double value) const;
    /// Rising along the axis; those without words first.
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    [[nodiscard]] double place(double value) const;

    Scale scale_;
    double from_, to_, least_ = 0, most_ = 1, step_ = 1;
};

}  // namespace frana::render
