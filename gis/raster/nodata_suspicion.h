// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/words/sentence.h"

namespace frana::gis {

/// Detects, while a raster is read, values used as "no data" that the file does not declare.
class NodataSuspicion {
  public:
    /// `values` as stored, row by row, NaN where the file declares "no data".
    void examine(const std::vector<double>& values, int columns);

    /// Returns the number of cells read with value 0 most of whose neighbours differ by more than `steep` (in the units
    /// stored): a frame of zeros around a terrain model. None if the values approach zero gradually, as at the sea.
    [[nodiscard]] std::int64_t zero_rim(double steep) const;

    /// Returns a warning about a common value (-9999 and similar; 9999 and similar if they form walls), or
    /// none.
    [[nodiscard]] std::optional<Sentence> warning(const std::string& path) const;

  private:
    static constexpr std::array<double, 8> k_customary{
        -9999.0, -99999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1e32, 1e20, 3.4028234663852886e38};
    std::array<std::int64_t, k_customary.size()> found_{};

    /// Common too, but a model in centimetres may contain them: suspect if they form walls.
    struct Plateau {
        double value = 0;
        std::int64_t cells = 0, borders = 0, walls = 0;
    };
    std::array<Plateau, 4> plateaus_{Plateau{9999}, Plateau{99999}, Plateau{32767}, Plateau{65535}};
    std::int64_t zeros_ = 0;
    std::vector<float> jumps_;  ///< between a zero and each of its neighbours other than zero
};

}  // namespace frana::gis
