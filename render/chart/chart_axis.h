// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::render {

/// Mapping of values to positions along an axis.
enum class Scale {
    linear,
    logarithmic,  ///< from the least to the greatest value; those of 0 and less have no position
    decades       ///< the same, between whole powers of ten
};

/// Decades of an axis: whole powers of ten around all its values, 10^low to 10^high.
struct Decades {
    int low = 0, high = 1;
};
/// Returns those of the positive values; 1 to 10 if there is none.
Decades decades_of(const std::vector<double>& values);

/// A position along an axis; without text it is between labelled ones.
struct Tick {
    double at = 0;  ///< [px]
    std::string words;
};

/// One axis, from its values to pixels of the page.
class ChartAxis {
  public:
    /// Where `values` begin and end on the page [px], and the least space of a label along the axis [px]. A linear axis
    /// that is `rounded` ends at labels.
    ChartAxis(Scale scale, const std::vector<double>& values, double from, double to, double room, bool rounded);

    [[nodiscard]] static bool has(Scale scale, double value);
    [[nodiscard]] double at(double value) const;
    /// Rising along the axis; unlabelled ones first.
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    [[nodiscard]] double place(double value) const;

    Scale scale_;
    double from_, to_, least_ = 0, most_ = 1, step_ = 1;
};

}  // namespace frana::render
