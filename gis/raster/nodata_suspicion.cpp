// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/nodata_suspicion.h"

#include <algorithm>
#include <cmath>

#include "core/shortest_text.h"

namespace frana::gis {
namespace {

// Fraction of the value itself: ground does not fall by a quarter of its height from one cell to the next.
constexpr double k_wall = 0.25;

Sentence undeclared(const std::string& path, std::int64_t cells, double value) {
    return worded(
        "{1}: {2} cells have the value {3}, which the file does not declare as nodata; they were read as values. If "
        "they are nodata, declare it: gdal_edit.py -a_nodata {3} FILE",
        {path, std::to_string(cells), shortest_text(value)});
}

}  // namespace

void NodataSuspicion::examine(const std::vector<double>& values, int columns) {
    for (std::size_t i = 0; i < k_customary.size(); ++i)
        found_[i] += std::count(values.begin(), values.end(), k_customary[i]);
    const auto width = static_cast<std::size_t>(columns);
    for (Plateau& plateau : plateaus_) {
        const auto cells = std::count(values.begin(), values.end(), plateau.value);
        plateau.cells += cells;
        if (cells == 0) continue;
        const auto border = [&](std::size_t one, std::size_t other) {
            if (values[one] != plateau.value || values[other] == plateau.value || std::isnan(values[other])) return;
            ++plateau.borders;
            plateau.walls += std::abs(values[one] - values[other]) > k_wall * plateau.value;
        };
        for (std::size_t i = 0; i < values.size(); ++i) {
            if ((i + 1) % width != 0) {
                border(i, i + 1);
                border(i + 1, i);
            }
            if (i + width < values.size()) {
                border(i, i + width);
                border(i + width, i);
            }
        }
    }
    const auto jump = [&](std::size_t zero, std::size_t other) {
        if (values[zero] == 0 && values[other] != 0 && !std::isnan(values[other]))
            jumps_.push_back(static_cast<float>(std::abs(values[other])));
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        zeros_ += values[i] == 0;
        if ((i + 1) % width != 0) {
            jump(i, i + 1);
            jump(i + 1, i);
        }
        if (i + width < values.size()) {
            jump(i, i + width);
            jump(i + width, i);
        }
    }
}

std::int64_t NodataSuspicion::zero_rim(double steep) const {
    const auto n = std::count_if(jumps_.begin(), jumps_.end(), [&](float jump) { return jump > steep; });
    return 2 * static_cast<std::size_t>(n) > jumps_.size() ? zeros_ : 0;
}

std::optional<Sentence> NodataSuspicion::warning(const std::string& path) const {
    for (std::size_t i = 0; i < k_customary.size(); ++i) {
        if (found_[i] == 0) continue;
        return undeclared(path, found_[i], k_customary[i]);
    }
    for (const Plateau& plateau : plateaus_)
        if (plateau.cells > 0 && 2 * plateau.walls > plateau.borders)
            return undeclared(path, plateau.cells, plateau.value);
    return std::nullopt;
}

}  // namespace frana::gis
