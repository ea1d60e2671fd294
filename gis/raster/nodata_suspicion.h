// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace frana::gis {

/// Looks, while a raster is read, for values that were meant as "no data" though the file does not say so.
class NodataSuspicion {
  public:
    /// `values` as stored, row by row, NaN where the file itself says "no data".
    void examine(const std::vector<double>& values, int columns);

    /// Cells read that hold 0 and of whose neighbours most jump by more than `steep` (in the units stored): a
    /// frame of zeros round a terrain model. None where zeros meet their neighbours gently, as the sea does.
    [[nodiscard]] std::int64_t zero_rim(double steep) const;

    /// A warning about a customary value (-9999 and its like; 9999 and its like where they stand like walls), or
    /// nothing.
    [[nodiscard]] std::string warning(const std::string& path) const;

  private:
    static constexpr std::array<double, 8> k_customary{
        -9999.0, -99999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1e32, 1e20, 3.4028234663852886e38};
    std::array<std::int64_t, k_customary.size()> found_{};

    /// Customary too, but a model in centimetres may hold them: suspect where they stand like walls.
    struct Plateau {
        double value = 0;
        std::int64_t cells = 0, borders = 0, walls = 0;
    };
    std::array<Plateau, 4> plateaus_{Plateau{9999}, Plateau{99999}, Plateau{32767}, Plateau{65535}};
    std::int64_t zeros_ = 0;
    std::vector<float> jumps_;  ///< between a zero and each of its neighbours that is none
};

}  // namespace frana::gis
